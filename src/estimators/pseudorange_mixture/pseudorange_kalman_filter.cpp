#include "estimators/pseudorange_mixture/pseudorange_kalman_filter.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <utility>

#include "models/pseudorange/ionospheric_slant.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kLeastLineOfSight = 1e-6;  // below it a measurement says nothing
constexpr double kLeastMode = 0.001;        // of a mode in the chain: no way without return
constexpr double kUsualCn0 = -10.0;         // against strong signals: the median among buildings [dB]
constexpr double kLeastSigma = 0.5;         // of the usual one: multipath remains, however strong the signal
constexpr double kMostSigma = 3.0;
constexpr double kClockJump = 30.0;  // no reflection delays most satellites alike by as much [m]
constexpr double kJumpSigmas = 5.0;
constexpr double kChangeOfSpeed = 2.0;  // of a vehicle within the age of a measurement [m/s^2]
constexpr double kLeastSpread = 3.0;    // of a reflected range rate [m/s]
// Probability that a range rate is that of the direct path: static walls reflect at the rate of the robot's
// own motion, so that most are near it even where the range is late, and none is sure.
constexpr double kLeastDirect = 0.5;
constexpr double kMostDirect = 0.97;
// Where range rates tell the drift at each epoch, it need not be remembered: oscillators that warm or bend
// change it by that much [m/s/sqrt(s)].
constexpr double kDriftWalk = 1.0;
constexpr double kLeastLogLikelihood = -14.0;  // of a range rate: some are off by more than any model says
constexpr double kLeastCourseSpeed = 0.7;      // slower, the course is noise [m/s]
constexpr double kCourseSigmas = 3.0;
constexpr double kFastestReverse = 4.0;  // [m/s]
constexpr double kKnownYaw = 0.7;        // [rad]
constexpr double kSideslip = 0.05;       // of a robot that points where it goes [rad]

constexpr double kQuarter = 0.25;

/// Values and their weights, one a satellite, which has a slot.
using WeightedValues = boost::container::static_vector<std::pair<double, double>, SatelliteSlots::kCapacity>;

/// The value below which `fraction` of the weight lies, of values in ascending order.
double weighted_quantile(const WeightedValues& sorted, double fraction) {
  double total = 0.0;
  for (const auto& [value, weight] : sorted) total += weight;
  double sum = 0.0;
  for (const auto& [value, weight] : sorted) {
    sum += weight;
    if (sum >= fraction * total) return value;
  }
  return sorted.back().first;
}

/// Where the antenna of a belief is, and how it moves with the yaw.
struct Antenna {
  Eigen::Vector3d position;  ///< in map [m]
  Eigen::Vector2d lever;     ///< from the base, in map [m]

  Antenna(const PseudorangeBelief& belief, const Eigen::Vector2d& antenna_in_base)
      : lever(rotation(belief.mean(kYaw)) * antenna_in_base) {
    position << belief.mean.head<2>() + lever, belief.mean(PseudorangeBelief::kUp);
  }
};

/// What a belief expects of a pseudorange.
struct RangePrediction {
  double range = 0.0;  ///< of a satellite in line of sight [m]
  SparseRow H;

  RangePrediction(const PseudorangeBelief& belief, const SlottedObservation& satellite,
                  const SlottedEpoch& epoch) {
    using State = PseudorangeBelief;
    const Antenna antenna(belief, epoch.antenna_in_base);
    const LineOfSight sight = line_of_sight(satellite.observation, antenna.position);
    const Eigen::Vector3d u = -sight.direction;
    H.set(kX, u.x());
    H.set(kY, u.y());
    H.set(kYaw, u.y() * antenna.lever.x() - u.x() * antenna.lever.y());
    H.set(State::kUp, u.z());
    H.set(State::kClock, 1.0);
    H.set(State::kDrift, -epoch.age);
    H.set(State::state_of(satellite.bias_slot), 1.0);
    const double slant = ionospheric_slant(satellite.observation.elevation);
    H.set(State::kZenithDelay, slant);
    range = sight.range + belief.mean(State::kClock) - epoch.age * belief.mean(State::kDrift) +
            slant * belief.mean(State::kZenithDelay) + belief.mean(State::state_of(satellite.bias_slot));
    if (satellite.offset_slot < 0) return;
    H.set(State::state_of(satellite.offset_slot), 1.0);
    range += belief.mean(State::state_of(satellite.offset_slot));
  }
};

/// 1 sigma of the range of which a belief knows least [m].
double largest_range_sigma(const PseudorangeBelief& belief, const SlottedEpoch& epoch) {
  double most_variance = 0.0;
  for (const SlottedObservation& satellite : epoch.satellites) {
    const RangePrediction prediction(belief, satellite, epoch);
    most_variance = std::max(most_variance, prediction.H.dot(belief.covariance_with(prediction.H)));
  }
  return std::sqrt(most_variance);
}

}  // namespace

double line_of_sight_sigma(const SatelliteObservation& observation, const RangeErrorParameters& errors) {
  if (!std::isfinite(observation.cn0)) return errors.range_sigma;
  return errors.range_sigma *
         std::clamp(std::pow(10.0, (kUsualCn0 - observation.cn0) / 20.0), kLeastSigma, kMostSigma);
}

void PseudorangeKalmanFilter::propagate(const PreintegratedOdometry& odometry, const MotionLaw& law,
                                        const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise,
                                        const SatelliteSlots& slots) {
  ReceiverStateNoise scaled = noise;
  scaled.bias_sigma *= scales.bias;
  belief.propagate(odometry, law, odometry_noise, scaled, slots);
}

void PseudorangeKalmanFilter::learn_biases(const SlottedEpoch& epoch) {
  double sum = 0.0;
  double count = 0.0;
  for (const SlottedObservation& satellite : epoch.satellites) {
    const int b = PseudorangeBelief::state_of(satellite.bias_slot);
    const double weight = chain[static_cast<std::size_t>(satellite.bias_slot)];
    sum += weight * (square(belief.mean(b)) + belief.covariance(b, b)) / epoch.bias_variance;
    count += weight;
  }
  scales.learn_bias(sum, count, epoch.information);
}

void PseudorangeKalmanFilter::append(double variance) {
  chain[static_cast<std::size_t>(belief.mean.size() - PseudorangeBelief::kFixed)] = -1.0;
  belief.append(variance);
}

void PseudorangeKalmanFilter::remove(int slot) {
  const auto last = static_cast<std::size_t>(belief.mean.size() - PseudorangeBelief::kFixed - 1);
  chain[static_cast<std::size_t>(slot)] = chain[last];
  belief.remove(slot);
}

EpochEvidence PseudorangeKalmanFilter::update(const SlottedEpoch& epoch, const RangeErrorParameters& errors) {
  reopen_clock(epoch);
  if (epoch.has_rates) {
    belief.covariance(PseudorangeBelief::kDrift, PseudorangeBelief::kDrift) +=
        square(kDriftWalk) * epoch.duration;
  }
  EpochEvidence evidence;
  double sum = 0.0;
  for (const SlottedObservation& satellite : epoch.satellites) {
    sum += update_range(satellite, epoch, errors, evidence);
  }
  learn_biases(epoch);
  if (!epoch.wheels) follow_course();
  line_of_sight_share = sum / static_cast<double>(epoch.satellites.size());
  return evidence;
}

/// What a range says for the place. A bias once explained by the satellite's state is charged again as long
/// as it lasts: else a wrong place whose biases fit wins against the right one with late satellites.
double PseudorangeKalmanFilter::evidence_of_place(const SlottedObservation& satellite,
                                                  const SlottedEpoch& epoch, const Residual& residual) const {
  const int b = PseudorangeBelief::state_of(satellite.bias_slot);
  const double rest = residual.HPHt - 2.0 * residual.PHt(b) + belief.covariance(b, b);
  const double variance = std::max(0.0, rest) + square(scales.range * satellite.sigma) +
                          square(scales.bias) * epoch.bias_variance;
  return satellite.share *
         weigh(residual.innovation + belief.mean(b), variance, satellite.delay, residual.prior)
             .log_likelihood;
}

double PseudorangeKalmanFilter::update_range(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                                             const RangeErrorParameters& errors, EpochEvidence& evidence) {
  const RangePrediction prediction(belief, satellite, epoch);
  const double innovation = satellite.observation.pseudorange - prediction.range;
  const PseudorangeBelief::Vector PHt = belief.covariance_with(prediction.H);
  const double HPHt = prediction.H.dot(PHt);

  // The chain forgets towards what C/N0 and elevation say.
  double& mode = chain[static_cast<std::size_t>(satellite.bias_slot)];
  double prior = satellite.prior;
  if (mode >= 0.0) prior += (mode - prior) * std::exp(-epoch.duration / errors.mode_time);
  const double variance = square(scales.range * satellite.sigma);
  const MixtureWeight weight = weigh(innovation, HPHt + variance, satellite.delay, prior);
  evidence.ranges += weight.log_likelihood;
  evidence.place += evidence_of_place(satellite, epoch, {innovation, HPHt, PHt, prior});
  const double log_odds = std::log(prior / (1.0 - prior)) +
                          weight.log_ratio * std::min(1.0, epoch.information / errors.mode_time);
  mode = std::clamp(1.0 / (1.0 + std::exp(-log_odds)), kLeastMode, 1.0 - kLeastMode);

  if (weight.line_of_sight < kLeastLineOfSight) return 0.0;
  const double inflation = std::max(1.0, errors.range_correlation_time / epoch.information);
  const double R = inflation * variance / weight.line_of_sight;
  scales.learn_range(innovation / std::sqrt(HPHt + variance),
                     weight.line_of_sight * std::min(1.0, epoch.information));
  belief.correct(PHt, HPHt + R, innovation);
  if (satellite.observation.has_doppler()) {
    evidence.rates += update_rate(satellite, epoch, errors, weight.line_of_sight);
  }
  return weight.line_of_sight;
}

double PseudorangeKalmanFilter::update_rate(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                                            const RangeErrorParameters& errors, double line_of_sight) {
  using State = PseudorangeBelief;
  const Antenna antenna(belief, epoch.antenna_in_base);
  const Eigen::Vector3d u =
      -multipath_localization::line_of_sight(satellite.observation, antenna.position).direction;
  const double per_scale = 1.0 / (1.0 + belief.mean(kScale));
  const double turn = epoch.yaw_rate - belief.mean(kGyroBias);
  const Eigen::Matrix2d R = rotation(belief.mean(kYaw));
  const Eigen::Vector2d of_base = per_scale * (R * Eigen::Vector2d(epoch.speed, epoch.lateral_speed));
  const Eigen::Vector2d swing(-antenna.lever.y(), antenna.lever.x());
  const Eigen::Vector2d velocity = of_base + belief.mean.segment<2>(State::kVelocityEast) + turn * swing;

  SparseRow H;
  H.set(kYaw, u.y() * of_base.x() - u.x() * of_base.y() - turn * u.head<2>().dot(antenna.lever));
  H.set(kScale, -per_scale * u.head<2>().dot(of_base));
  H.set(kGyroBias, -u.head<2>().dot(swing));
  H.set(State::kVelocityEast, u.x());
  H.set(State::kVelocityNorth, u.y());
  H.set(State::kDrift, 1.0);
  const double predicted =
      -u.dot(satellite.observation.velocity) + u.head<2>().dot(velocity) + belief.mean(State::kDrift);
  const double innovation = satellite.observation.range_rate - predicted;
  const State::Vector PHt = belief.covariance_with(H);
  const double sigma = errors.range_rate_sigma * scales.rate * satellite.sigma / errors.range_sigma;
  const double variance = square(sigma) + square(kChangeOfSpeed * epoch.age);
  const double S = H.dot(PHt) + variance;

  // A reflected range rate may be off either way, by as much as the vehicle moves.
  const double spread = S + std::max(square(kLeastSpread), velocity.squaredNorm());
  const double p = kLeastDirect + (kMostDirect - kLeastDirect) * line_of_sight;
  const double direct = std::log(p) - 0.5 * (square(innovation) / S + std::log(S));
  const double reflected = std::log(1.0 - p) - 0.5 * (square(innovation) / spread + std::log(spread));
  const double likelihood = log_sum(direct, reflected);
  const double q = std::exp(direct - likelihood);
  scales.learn_rate(innovation / std::sqrt(S), q);
  if (q < kLeastLineOfSight) return std::max(likelihood, kLeastLogLikelihood);
  const double inflation = std::max(1.0, kRangeRateTime / epoch.information);
  belief.correct(PHt, H.dot(PHt) + inflation * variance / q, innovation);
  return std::max(likelihood, kLeastLogLikelihood);
}

void PseudorangeKalmanFilter::follow_course() {
  constexpr int v = PseudorangeBelief::kVelocityEast;
  const Eigen::Vector2d velocity = belief.mean.segment<2>(v);
  const double speed = velocity.norm();
  const double sigma = mean_sigma(belief.covariance.block<2, 2>(v, v));
  if (speed < std::max(kLeastCourseSpeed, kCourseSigmas * sigma)) return;
  double course = std::atan2(velocity.y(), velocity.x());
  const bool known = belief.covariance(kYaw, kYaw) < square(kKnownYaw);
  if (known && speed < kFastestReverse && std::abs(angle_difference(course, belief.mean(kYaw))) > kPi / 2.0) {
    course = wrap_angle(course + kPi);
  }
  SparseRow H;
  H.set(kYaw, 1.0);
  const double variance = square(kSideslip) + square(sigma / speed);
  const PseudorangeBelief::Vector PHt = belief.covariance_with(H);
  belief.correct(PHt, belief.covariance(kYaw, kYaw) + variance, angle_difference(course, belief.mean(kYaw)));
}

void PseudorangeKalmanFilter::mix(const PseudorangeKalmanFilter& other, double share) {
  merge(belief.mean, belief.covariance, other.belief.mean, other.belief.covariance, share);
  for (std::size_t i = 0; i < chain.size(); ++i) chain[i] += share * (other.chain[i] - chain[i]);
  scales.mix(other.scales, share);
  line_of_sight_share += share * (other.line_of_sight_share - line_of_sight_share);
}

/// Receivers steer their clocks in jumps: then all residuals move together, which no reflection explains.
void PseudorangeKalmanFilter::reopen_clock(const SlottedEpoch& epoch) {
  WeightedValues residuals;
  for (const SlottedObservation& satellite : epoch.satellites) {
    const RangePrediction prediction(belief, satellite, epoch);
    residuals.emplace_back(satellite.observation.pseudorange - prediction.range, satellite.prior);
  }
  std::sort(residuals.begin(), residuals.end());
  const double low = weighted_quantile(residuals, kQuarter);
  const double high = weighted_quantile(residuals, 1.0 - kQuarter);
  const double jump = low > 0.0 ? low : high;
  const double common = std::max(low, -high);  // by which most are off the same way
  if (common < kClockJump) return;
  if (common < kClockJump + kJumpSigmas * largest_range_sigma(belief, epoch)) return;
  belief.renew(PseudorangeBelief::kClock, belief.mean(PseudorangeBelief::kClock) + jump, square(kClockJump));
}

}  // namespace multipath_localization
