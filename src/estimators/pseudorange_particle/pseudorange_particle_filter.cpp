#include "estimators/pseudorange_particle/pseudorange_particle_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

#include "multipath_localization/core/epoch_check.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/models/pseudorange/signal_weights.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kVelocityLasts = 3.0;        ///< without an epoch [s]
constexpr double kClockSigma = 3.0;           ///< of a constellation's mean clock, beside its weights [m]
constexpr double kMostRestartedAtOnce = 0.1;  ///< of the particles: an outage does not make the fix better

double free_or(double sigma, ConstellationClocks constellations) {
  return constellations == ConstellationClocks::kTied ? sigma : std::numeric_limits<double>::infinity();
}

}  // namespace

PseudorangeParticleFilter::PseudorangeParticleFilter(const PseudorangeParticleFilterParameters& parameters,
                                                     std::uint64_t seed)
    : parameters_(parameters),
      cloud_(parameters, seed),
      inter_system_bias_(free_or(parameters.inter_system_sigma, parameters.constellations)) {}

void PseudorangeParticleFilter::start(const std::optional<PosePrior>& prior) {
  cloud_.clear();
  inter_system_bias_.forget();
  heights_known_ = false;
  last_increment_ = OdometryIncrement{};
  lost_since_.reset();
  now_ = evidence_time_ = time_since_epoch_ = excluded_share_ = 0.0;
  if (!prior || !usable(*prior)) return;
  now_ = prior->stamp;
  cloud_.start_at(*prior);
}

void PseudorangeParticleFilter::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  const OdometryIncrement before = std::exchange(last_increment_, u);
  if (cloud_.empty()) return;
  time_since_epoch_ += u.duration;
  if (parameters_.motion.motion == MotionSource::kAuto && time_since_epoch_ > kVelocityLasts) {
    cloud_.forget_velocities();
  }
  const bool moving = !standing(u) || cloud_.moves();
  evidence_time_ += (moving ? 1.0 : parameters_.likelihood.standing_evidence) * u.duration;
  cloud_.move(u, before);
}

PreparedEpoch PseudorangeParticleFilter::prepared(const PseudorangeEpoch& epoch) const {
  PreparedEpoch result;
  result.observations = usable_observations(epoch);
  result.antenna_in_base = epoch.antenna_in_base;
  const std::vector<double> by_signal = signal_weights(result.observations);
  result.weights = parameters_.weighting == SatelliteWeighting::kSignal
                       ? by_signal
                       : declared_weights(result.observations);
  result.fix =
      one_sided_position(result.observations, by_signal, parameters_.robust,
                         cloud_.empty() || !heights_known_ ? Eigen::Vector3d(0.0, 0.0, 0.0)
                                                           : cloud_.mean_antenna(epoch.antenna_in_base));
  return result;
}

Innovation PseudorangeParticleFilter::update(const Measurement& z) {
  const auto* measured = std::get_if<PseudorangeEpoch>(&z);
  if (measured == nullptr) return refused(Reason::kUnused);
  if (const auto reason = defect(*measured)) return refused(*reason);
  const PreparedEpoch epoch = prepared(*measured);
  if (epoch.fix) inter_system_bias_.adopt(*epoch.fix);
  if (cloud_.empty()) return begin(epoch);
  if (!heights_known_) {
    if (!epoch.fix) return refused(Reason::kTooFewSatellites);
    cloud_.draw_heights(*epoch.fix);
    heights_known_ = true;
  }
  return track(epoch);
}

Innovation PseudorangeParticleFilter::begin(const PreparedEpoch& epoch) {
  const auto fix = parameters_.start == StartPosition::kRobust
                       ? epoch.fix
                       : solve_position(epoch.observations, epoch.weights, Eigen::Vector3d::Zero());
  if (!fix) return refused(Reason::kTooFewSatellites);
  cloud_.start_near(*fix, epoch.antenna_in_base);
  heights_known_ = true;
  LosSubset subset(epoch.observations, epoch.weights, inter_system_bias_, parameters_.subset);
  cloud_.adopt_velocities(epoch, subset, last_increment_);
  settle();
  subset.solve(cloud_.mean_antenna(epoch.antenna_in_base));
  excluded_share_ = subset.excluded_share();
  Innovation first;
  first.reason = Reason::kAccepted;
  return first;
}

double PseudorangeParticleFilter::exponent() const {
  if (parameters_.likelihood.tempering == Tempering::kNone) return 1.0;
  return std::min(1.0, parameters_.likelihood.evidence_rate * evidence_time_);
}

Innovation PseudorangeParticleFilter::track(const PreparedEpoch& epoch) {
  LosSubset subset(epoch.observations, epoch.weights, inter_system_bias_, parameters_.subset);
  const Innovation result = compare(epoch, subset);
  const InterSystemBias corrected = corrected_inter_system_bias(subset);
  const double share = subset.excluded_share();
  if (!cloud_.weigh(epoch, subset, exponent(), last_increment_)) return miss(epoch);
  inter_system_bias_ = corrected;
  excluded_share_ = share;
  cloud_.take_stock();
  cloud_.resample_if_uneven();
  // A few particles try the robust fix at any time, so that a cloud gone astray is contradicted by its own
  // weights. Departs: [SUZ] has no way back.
  if (parameters_.reset != Reset::kNever && epoch.fix) {
    cloud_.restart_some(*epoch.fix, epoch.antenna_in_base,
                        std::min(kMostRestartedAtOnce, parameters_.restart_rate * time_since_epoch_));
  }
  settle();
  return result;
}

void PseudorangeParticleFilter::settle() {
  cloud_.take_stock();
  lost_since_.reset();
  evidence_time_ = time_since_epoch_ = 0.0;
}

Innovation PseudorangeParticleFilter::miss(const PreparedEpoch& epoch) {
  if (!lost_since_) lost_since_ = now_;
  const bool lost = now_ - *lost_since_ >= parameters_.reset_after;
  if (!lost || parameters_.reset == Reset::kNever || !epoch.fix) return refused(Reason::kTooFewSatellites);
  cloud_.restart_all(*epoch.fix, epoch.antenna_in_base);
  settle();
  Innovation result;
  result.reason = Reason::kAccepted;
  return result;
}

Innovation PseudorangeParticleFilter::compare(const PreparedEpoch& epoch, LosSubset& subset) const {
  Innovation result;
  result.reason = Reason::kAccepted;
  const auto solution = subset.solve(cloud_.mean_antenna(epoch.antenna_in_base));
  if (!solution) return result;
  const Eigen::Matrix3d covariance = solution->information.inverse();
  result.innovation = solution->step.head<2>();
  result.covariance = covariance.topLeftCorner<2, 2>() + estimate().covariance.topLeftCorner<2, 2>();
  result.nis = result.innovation.dot(result.covariance.inverse() * result.innovation);
  return result;
}

/// By the subset at the mean of the particles, which `compare` left selected.
InterSystemBias PseudorangeParticleFilter::corrected_inter_system_bias(const LosSubset& subset) const {
  InterSystemBias bias = inter_system_bias_;
  bias.wander(time_since_epoch_);
  const double share = exponent();
  const auto common = bias.reference() ? subset.clock_residual(*bias.reference()) : std::nullopt;
  if (!common || !(share > 0.0)) return bias;
  for (int k = 0; k < kConstellations; ++k) {
    const auto constellation = static_cast<Constellation>(k);
    const auto own = subset.clock_residual(constellation);
    if (!own || constellation == *bias.reference()) continue;
    const double variance = own->variance + common->variance + square(kClockSigma);
    bias.correct(constellation, own->mean - common->mean, variance / share);
  }
  return bias;
}

PoseEstimate PseudorangeParticleFilter::estimate() const {
  PoseEstimate result = cloud_.empty() ? PoseEstimate() : cloud_.estimate();
  result.stamp = now_;
  if (!cloud_.empty()) result.shadow_probability = excluded_share_;
  return result;
}

std::vector<Hypothesis> PseudorangeParticleFilter::hypotheses() const { return cloud_.hypotheses(); }

}  // namespace multipath_localization
