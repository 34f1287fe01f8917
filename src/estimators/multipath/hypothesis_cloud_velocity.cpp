#include <algorithm>
#include <cmath>
#include <optional>

#include "estimators/multipath/hypothesis_cloud.hpp"
#include "estimators/multipath/velocity_explanations.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kEvidenceTime = 2.0;  // velocities are off alike for about that [s]
constexpr double kDoubted = 0.003;     // of receivers' velocities are of another frame or sign

/// Draws laws of velocities for the hypotheses that have none.
void draw_velocity_laws(std::vector<Hypothesis>& hypotheses, bool near_start, std::uint64_t seed,
                        std::uint32_t step) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    Hypothesis& h = hypotheses[i];
    if (h.velocity.drawn) continue;
    RandomStream random(seed ^ kAidSeed, step, static_cast<std::uint32_t>(i));
    h.velocity.drawn = true;
    draw_velocity_errors(h.velocity, random);
    h.velocity.believed = draw_belief(h, kDoubted, random);
    h.velocity.seeks_course = h.velocity.seeks_course && near_start;
    h.velocity.way_noise.setZero();
  }
}

}  // namespace

void HypothesisCloud::weigh(const VelocitySighting& sighting) {
  aids_.velocity = true;
  draw_velocity_laws(hypotheses_, sighting.near_start, seed_, ++aid_step_);
  ++aid_step_;
  const double share = std::min(1.0, sighting.duration / kEvidenceTime);
  std::vector<std::optional<double>> log_density(hypotheses_.size());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    RandomStream random(seed_ ^ kAidSeed, aid_step_, static_cast<std::uint32_t>(i));
    Hypothesis& h = hypotheses_[i];
    wander(h.velocity, sighting.duration, random);
    if (h.velocity.believed) log_density[i] = explain_velocity(h, sighting, random);
    if (log_density[i]) *log_density[i] *= share;
    h.velocity.way_noise.setZero();
  }
  weigh_believing(hypotheses_, log_density, mixture_.covariance(2, 2) < kAgreedVariance,
                  [](const Hypothesis& h) { return h.velocity.outlier; });
  refresh();
  resample();
}

}  // namespace multipath_localization::multipath
