#include "multipath_localization/estimators/pseudorange_hypothesis.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <utility>

#include "multipath_localization/core/numbers.hpp"
#include "multipath_localization/models/pseudorange.hpp"

namespace multipath_localization {

namespace {

constexpr double kLeastLineOfSight = 1e-6;  // below it a measurement says nothing
constexpr double kLeastMode = 0.001;        // of a mode in the chain: no way without return
constexpr double kJumpSigmas = 5.0;
constexpr double kChangeOfSpeed = 2.0;  // of a vehicle within the age of a measurement [m/s^2]

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
    range = sight.range + belief.mean(State::kClock) - epoch.age * belief.mean(State::kDrift) +
            belief.mean(State::state_of(satellite.bias_slot));
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

void RangeErrorParameters::fields(ParameterVisitor& field) {
  field("range_sigma", range_sigma, {0.1, 100.0}, "m", "noise of a pseudorange in line of sight");
  field("range_correlation_time", range_correlation_time, {0.0, 100.0}, "s",
        "noise of ranges closer in time than this is one and the same, whatever the rate of the receiver");
  field("evidence_time", evidence_time, {0.1, 1e3}, "s",
        "multipath stays alike for this long: data of this duration count once in weighing hypotheses");
  field("mode_time", mode_time, {0.1, 1e3}, "s",
        "a satellite is in line of sight, or not, for this long; its residuals of this duration count once");
  field("range_rate_sigma", range_rate_sigma, {0.01, 10.0}, "m/s", "noise of a range rate in line of sight");
  field("range_rate_correlation_time", range_rate_correlation_time, {0.0, 100.0}, "s",
        "like range_correlation_time");
  field("clock_jump", clock_jump, {1.0, 1e6}, "m",
        "the receiver clock jumped when most residuals are beyond this, and beyond five sigma");
  mixture.fields(field);
}

void PseudorangeHypothesis::append(double variance) {
  chain[static_cast<std::size_t>(belief.mean.size() - PseudorangeBelief::kFixed)] = -1.0;
  belief.append(variance);
}

void PseudorangeHypothesis::remove(int slot) {
  const auto last = static_cast<std::size_t>(belief.mean.size() - PseudorangeBelief::kFixed - 1);
  chain[static_cast<std::size_t>(slot)] = chain[last];
  belief.remove(slot);
}

void PseudorangeHypothesis::update(const SlottedEpoch& epoch, const RangeErrorParameters& errors) {
  reopen_clock(epoch, errors);
  double sum = 0.0;
  for (const SlottedObservation& satellite : epoch.satellites) sum += update(satellite, epoch, errors);
  line_of_sight_share = sum / static_cast<double>(epoch.satellites.size());
}

/// What a range says for the hypothesis. A bias once explained by the satellite's state is charged again as
/// long as it lasts: else a wrong place whose biases fit wins against the right one with late satellites.
double PseudorangeHypothesis::evidence(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                                       const RangeErrorParameters& errors, const Residual& residual) const {
  const int b = PseudorangeBelief::state_of(satellite.bias_slot);
  const double rest = residual.HPHt - 2.0 * residual.PHt(b) + belief.covariance(b, b);
  const double variance = std::max(0.0, rest) + square(errors.range_sigma) + epoch.bias_variance;
  return weigh(residual.innovation + belief.mean(b), variance, satellite.delay, residual.prior)
             .log_likelihood *
         std::min(1.0, epoch.information / errors.evidence_time);
}

double PseudorangeHypothesis::update(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                                     const RangeErrorParameters& errors) {
  const RangePrediction prediction(belief, satellite, epoch);
  const double innovation = satellite.observation.pseudorange - prediction.range;
  const PseudorangeBelief::Vector PHt = belief.covariance_with(prediction.H);
  const double HPHt = prediction.H.dot(PHt);

  // The chain forgets towards what C/N0 and elevation say.
  double& mode = chain[static_cast<std::size_t>(satellite.bias_slot)];
  double prior = satellite.prior;
  if (mode >= 0.0) prior += (mode - prior) * std::exp(-epoch.duration / errors.mode_time);
  const MixtureWeight weight = weigh(innovation, HPHt + square(errors.range_sigma), satellite.delay, prior);
  log_weight += evidence(satellite, epoch, errors, {innovation, HPHt, PHt, prior});
  const double log_odds = std::log(prior / (1.0 - prior)) +
                          weight.log_ratio * std::min(1.0, epoch.information / errors.mode_time);
  mode = std::clamp(1.0 / (1.0 + std::exp(-log_odds)), kLeastMode, 1.0 - kLeastMode);

  if (weight.line_of_sight < kLeastLineOfSight) return 0.0;
  const double inflation = std::max(1.0, errors.range_correlation_time / epoch.information);
  const double R = inflation * square(errors.range_sigma) / weight.line_of_sight;
  belief.correct(PHt, HPHt + R, innovation);
  if (satellite.observation.has_doppler()) update_rate(satellite, epoch, errors, weight.line_of_sight);
  return weight.line_of_sight;
}

void PseudorangeHypothesis::update_rate(const SlottedObservation& satellite, const SlottedEpoch& epoch,
                                        const RangeErrorParameters& errors, double probability) {
  using State = PseudorangeBelief;
  const Antenna antenna(belief, epoch.antenna_in_base);
  const Eigen::Vector3d u = -line_of_sight(satellite.observation, antenna.position).direction;
  const double speed = epoch.speed / (1.0 + belief.mean(kScale));
  const double lateral_speed = epoch.lateral_speed / (1.0 + belief.mean(kScale));
  const double turn = epoch.yaw_rate - belief.mean(kGyroBias);
  const Eigen::Vector2d along(std::cos(belief.mean(kYaw)), std::sin(belief.mean(kYaw)));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d swing(-antenna.lever.y(), antenna.lever.x());
  const Eigen::Vector2d of_base = speed * along + lateral_speed * across;
  const Eigen::Vector2d velocity = of_base + turn * swing;

  SparseRow H;
  H.set(kYaw, u.head<2>().dot(speed * across - lateral_speed * along - turn * antenna.lever));
  H.set(kScale, -speed / (1.0 + belief.mean(kScale)) * u.head<2>().dot(along) -
                    lateral_speed / (1.0 + belief.mean(kScale)) * u.head<2>().dot(across));
  H.set(kGyroBias, -u.head<2>().dot(swing));
  H.set(State::kDrift, 1.0);
  const double predicted =
      -u.dot(satellite.observation.velocity) + u.head<2>().dot(velocity) + belief.mean(State::kDrift);
  const double innovation = satellite.observation.range_rate - predicted;
  const State::Vector PHt = belief.covariance_with(H);
  const double variance = square(errors.range_rate_sigma) + square(kChangeOfSpeed * epoch.age);
  const double S = H.dot(PHt) + variance;

  // A reflected range rate may be off either way, by as much as the vehicle moves.
  const double spread = S + square(errors.range_rate_sigma) + square(speed) + square(lateral_speed);
  const double p = std::clamp(probability, kLeastMode, 1.0 - kLeastMode);
  const double log_ratio = -0.5 * (square(innovation) * (1.0 / S - 1.0 / spread) + std::log(S / spread));
  const double q = 1.0 / (1.0 + (1.0 - p) / p * std::exp(-log_ratio));
  if (q < kLeastLineOfSight) return;
  const double inflation = std::max(1.0, errors.range_rate_correlation_time / epoch.information);
  belief.correct(PHt, H.dot(PHt) + inflation * variance / q, innovation);
}

/// Receivers steer their clocks in jumps: then all residuals move together, which no reflection explains.
void PseudorangeHypothesis::reopen_clock(const SlottedEpoch& epoch, const RangeErrorParameters& errors) {
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
  if (common < errors.clock_jump) return;
  if (common < errors.clock_jump + kJumpSigmas * largest_range_sigma(belief, epoch)) return;
  belief.renew(PseudorangeBelief::kClock, belief.mean(PseudorangeBelief::kClock) + jump,
               square(errors.clock_jump));
}

}  // namespace multipath_localization
