#include <mrpt/bayes/CParticleFilterCapable.h>
#include <mrpt/bayes/CParticleFilterData.h>
#include <mrpt/random/RandomGenerators.h>

#include "tools/benchmark/full_step.hpp"
#include "tools/benchmark/peer_motion.hpp"

namespace multipath_localization {

namespace {

/// The same step by MRPT's particle filter: systematic resampling at every step.
class MrptFilter
    : public mrpt::bayes::CParticleFilterData<Pose2, mrpt::bayes::particle_storage_mode::VALUE>,
      public mrpt::bayes::CParticleFilterDataImpl<
          MrptFilter,
          mrpt::bayes::CParticleFilterData<Pose2, mrpt::bayes::particle_storage_mode::VALUE>::CParticleList> {
 public:
  explicit MrptFilter(std::size_t size) : random_(42) {
    options_.resamplingMethod = mrpt::bayes::CParticleFilter::prSystematic;
    m_particles.resize(size);
    for (auto& particle : m_particles) {
      particle.d = {0.3 * normal(), 0.3 * normal(), 0.05 * normal()};
      particle.log_w = 0.0;
    }
  }

  void step(const OdometryIncrement& u, const GnssFix& fix) {
    for (auto& particle : m_particles) {
      particle.d = peer_motion(particle.d, u, [this] { return normal(); });
      particle.log_w += peer_log_likelihood(particle.d.x, particle.d.y, fix);
    }
    normalizeWeights();
    average();
    effective_share_ = ESS();
    performResampling(options_);
  }

  [[nodiscard]] double x() const { return mean_.x; }

 private:
  double normal() { return random_.drawGaussian1D_normalized(); }

  void average() {
    double sum = 0.0, x = 0.0, y = 0.0, c = 0.0, s = 0.0;
    for (const auto& particle : m_particles) {
      const double w = std::exp(particle.log_w);
      sum += w;
      x += w * particle.d.x;
      y += w * particle.d.y;
      c += w * std::cos(particle.d.yaw);
      s += w * std::sin(particle.d.yaw);
    }
    mean_ = {x / sum, y / sum, std::atan2(s, c)};
  }

  mrpt::random::CRandomGenerator random_;
  mrpt::bayes::CParticleFilter::TParticleFilterOptions options_;
  double effective_share_ = 1.0;
  Pose2 mean_;
};

}  // namespace

void register_mrpt() { register_full_step<MrptFilter>("MRPT"); }

}  // namespace multipath_localization
