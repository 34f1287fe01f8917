#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "estimators/pseudorange_particle/pseudorange_particle_filter.hpp"
#include "multipath_localization/filters/resampling.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::uint32_t kResampling = 0xFFFFFFFFU;  ///< random stream beside those of the particles
constexpr double kClockSigma = 3.0;  ///< of a constellation's mean clock, beside its weights [m]
constexpr double kNever = -std::numeric_limits<double>::infinity();

/// log of the likelihood, Eqs. (11), (12) of [SUZ], up to a constant. Departs, unless "distance": Eq. (12)
/// prints the normal density without the determinant of Sigma.
double log_likelihood(const SubsetSolution& solution, const SubsetLikelihoodParameters& parameters) {
  const double quadratic = -0.5 * solution.mahalanobis_squared / square(parameters.likelihood_sigma);
  return parameters.likelihood == SubsetLikelihood::kDensity ? 0.5 * solution.log_determinant + quadratic
                                                             : quadratic;
}

/// What a subset that says next to nothing would give.
double log_floor(const SubsetLikelihoodParameters& parameters) {
  if (parameters.likelihood != SubsetLikelihood::kDensity || parameters.outlier_sigma == 0.0) return kNever;
  return -3.0 * std::log(parameters.outlier_sigma);
}

}  // namespace

double PseudorangeParticleFilter::exponent() const {
  if (parameters_.likelihood.tempering == Tempering::kNone) return 1.0;
  return std::min(1.0, parameters_.likelihood.evidence_rate * evidence_time_);
}

Innovation PseudorangeParticleFilter::track(const Sky& sky) {
  LosSubset subset(sky.observations, sky.weights, inter_system_bias_, parameters_.subset);
  const Innovation result = compare(sky, subset);
  const InterSystemBias corrected = corrected_inter_system_bias(subset);
  const double share = subset.excluded_share();
  if (!weigh(sky, subset)) return miss(sky);
  inter_system_bias_ = corrected;
  excluded_share_ = share;
  take_stock();
  if (effective_sample_size_ <= parameters_.ess_fraction * static_cast<double>(particles_.size())) resample();
  restart_some(sky);
  settle();
  return result;
}

void PseudorangeParticleFilter::settle() {
  take_stock();
  lost_since_.reset();
  evidence_time_ = time_since_epoch_ = 0.0;
}

/// No particle has a subset, of which [SUZ] says nothing.
Innovation PseudorangeParticleFilter::miss(const Sky& sky) {
  if (!lost_since_) lost_since_ = now_;
  const bool lost = now_ - *lost_since_ >= parameters_.reset_after;
  if (!lost || parameters_.reset == Reset::kNever || !sky.fix) return refused(Reason::kTooFewSatellites);
  restart_all(sky);
  settle();
  Innovation result;
  result.reason = Reason::kAccepted;
  return result;
}

/// Eqs. (5)-(12) of [SUZ] for every particle; false, and nothing changed, when none has a subset.
bool PseudorangeParticleFilter::weigh(const Sky& sky, LosSubset& subset) {
  const double floor = log_floor(parameters_.likelihood);
  bool any = false;
  std::vector<double> gain(particles_.size(), floor);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Eigen::Vector2d antenna = particles_.pose(i) * sky.antenna_in_base;
    const auto solution = subset.solve({antenna.x(), antenna.y(), rest_[i].height});
    if (!solution) continue;
    any = true;
    gain[i] = std::max(floor, log_likelihood(*solution, parameters_.likelihood));
    adopt_velocity(i, sky, subset);
  }
  const double share = exponent();
  for (std::size_t i = 0; any && share > 0.0 && i < gain.size(); ++i) {
    particles_.log_weight[i] += share * gain[i];
  }
  return any;
}

void PseudorangeParticleFilter::adopt_velocity(std::size_t i, const Sky& sky, const LosSubset& subset) {
  if (parameters_.motion.motion == MotionSource::kOdometry) return;
  const auto velocity = subset.velocity(parameters_.motion.doppler_tolerance);
  if (!velocity) {
    if (parameters_.motion.motion == MotionSource::kAuto) rest_[i].velocity.reset();
    return;
  }
  Pose2 pose = particles_.pose(i);
  multipath_localization::adopt_velocity(pose, rest_[i], *velocity, sky.antenna_in_base, last_increment_);
  particles_.yaw[i] = pose.yaw;
}

/// The mean of the particles against the position that its subset speaks for.
Innovation PseudorangeParticleFilter::compare(const Sky& sky, LosSubset& subset) const {
  Innovation result;
  result.reason = Reason::kAccepted;
  const auto solution = subset.solve(mean_antenna(sky.antenna_in_base));
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

void PseudorangeParticleFilter::resample() {
  const double uniform = RandomStream(seed_, step_, kResampling).uniform();
  const auto ancestors = systematic_resampling(weights_, particles_.size(), uniform);
  particles_ = particles_.selected(ancestors);
  rest_ = selected(rest_, ancestors);
  ++step_;
}

}  // namespace multipath_localization
