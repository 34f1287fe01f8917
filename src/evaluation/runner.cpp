#include "evaluation/runner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath_localization {

namespace {

constexpr double kLongestCarry = 1.0;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Walks a drive's streams in the order of arrival.
class Replay {
 public:
  Replay(const Drive& drive, Localizer& localizer, const FateReport& fate)
      : drive_(drive), localizer_(localizer), fate_(fate) {}

  /// Everything that had arrived by `stamp`.
  void advance_to(double stamp) {
    while (true) {
      const double odometry = next_odometry_stamp();
      const double measurement = next_measurement_arrival();
      const double yaw_rate = next_yaw_rate_arrival();
      if (std::min({odometry, measurement, yaw_rate}) > stamp) break;
      if (yaw_rate <= std::min(odometry, measurement)) {
        localizer_.add(drive_.yaw_rates[next_yaw_rate_++].yaw_rate);
      } else if (odometry <= measurement) {
        restart_at(odometry);
        localizer_.add(drive_.odometry[next_odometry_++]);
      } else {
        localizer_.add(drive_.measurements[next_measurement_++].measurement);
      }
    }
    hand_on_reports(localizer_, fate_);
  }

  /// The increment that came in last.
  [[nodiscard]] std::optional<OdometryIncrement> last() const {
    if (next_odometry_ == 0) return std::nullopt;
    return drive_.odometry[next_odometry_ - 1];
  }

 private:
  [[nodiscard]] double next_odometry_stamp() const {
    if (next_odometry_ == drive_.odometry.size()) return kNever;
    return drive_.odometry[next_odometry_].stamp;
  }

  [[nodiscard]] double next_measurement_arrival() const {
    if (next_measurement_ == drive_.measurements.size()) return kNever;
    return drive_.measurements[next_measurement_].arrival;
  }

  [[nodiscard]] double next_yaw_rate_arrival() const {
    if (next_yaw_rate_ == drive_.yaw_rates.size()) return kNever;
    return drive_.yaw_rates[next_yaw_rate_].arrival;
  }

  void restart_at(double stamp) {
    if (next_restart_ == drive_.restarts.size() || drive_.restarts[next_restart_] > stamp) return;
    ++next_restart_;
    localizer_.start(std::nullopt);
  }

  const Drive& drive_;
  Localizer& localizer_;
  const FateReport& fate_;
  std::size_t next_restart_ = 0;
  std::size_t next_odometry_ = 0;
  std::size_t next_measurement_ = 0;
  std::size_t next_yaw_rate_ = 0;
};

/// The direction in which truth goes on from a sample: to the first one a metre away, within two seconds and
/// while the odometry drives straight forward.
std::optional<double> direction_of_travel(const Drive& drive, const TruthSample& from) {
  const OdometryIncrement& first = drive.odometry.front();
  if (first.speed <= 0.0 || first.lateral_speed != 0.0) return std::nullopt;
  for (const TruthSample& to : drive.truth) {
    const Eigen::Vector2d way = to.base_in_map.position() - from.base_in_map.position();
    if (to.stamp > from.stamp + 2.0) break;
    if (to.stamp > from.stamp && way.norm() >= 1.0) return std::atan2(way.y(), way.x());
  }
  return std::nullopt;
}

std::optional<PosePrior> prior_of(const Drive& drive) {
  const double stamp = std::max(drive.odometry.front().stamp - drive.odometry.front().duration,
                                drive.truth.empty() ? 0.0 : drive.truth.front().stamp);
  std::optional<TruthSample> truth = truth_at(drive.truth, stamp);
  if (!truth) throw RunError("the start cannot be known: no truth there");
  if (!truth->has_yaw) {
    const std::optional<double> yaw = direction_of_travel(drive, *truth);
    if (!yaw) throw RunError("the start cannot be known: truth has no heading and does not set out at once");
    truth->base_in_map.yaw = *yaw;
  }
  return known_start(stamp, truth->base_in_map);
}

constexpr double kBetweenInstants = 0.1;  ///< of the estimates on a drive without truth [s]

/// When the estimate is asked for: where truth is or, without any, along the odometry.
std::vector<TruthSample> instants_of(const Drive& drive) {
  if (!drive.truth.empty()) return drive.truth;
  std::vector<TruthSample> instants;
  for (const OdometryIncrement& u : drive.odometry) {
    if (!instants.empty() && u.stamp - instants.back().stamp < kBetweenInstants) continue;
    instants.emplace_back();
    instants.back().stamp = u.stamp;
  }
  return instants;
}

}  // namespace

void hand_on_reports(Localizer& localizer, const FateReport& fate) {
  for (const MeasurementReport& report : localizer.take_reports()) {
    if (fate) fate(report);
  }
}

PosePrior known_start(double stamp, const Pose2& base_in_map) {
  PosePrior prior;
  prior.stamp = stamp;
  prior.pose = base_in_map;
  prior.covariance = Eigen::Vector3d(0.01, 0.01, 4e-4).asDiagonal();
  return prior;
}

Epoch epoch_of(const PoseEstimate& estimate, const TruthSample& truth,
               const std::optional<OdometryIncrement>& last) {
  Epoch epoch;
  epoch.truth = truth;
  if (!estimate.valid || !last || truth.stamp - last->stamp > kLongestCarry) return epoch;
  if (!estimate.pose.finite() || !estimate.position_covariance_overall.allFinite()) {
    throw RunError("the estimate at " + std::to_string(truth.stamp) + " s is not finite");
  }
  OdometryIncrement carry = *last;
  carry.duration = truth.stamp - last->stamp;
  epoch.valid = true;
  epoch.aligned = estimate.aligned;
  epoch.estimate = estimate.pose * displacement(carry);
  epoch.position_covariance = estimate.position_covariance_overall;
  epoch.yaw_variance = estimate.covariance(2, 2);
  epoch.shadow_probability = estimate.shadow_probability;
  epoch.wheel_fault_probability = estimate.wheel_fault_probability;
  return epoch;
}

std::vector<Epoch> run_drive(const Drive& drive, const EstimatorFactory& make, const RunSettings& settings,
                             const ProgressReport& progress, const FateReport& fate) {
  Localizer localizer(make(), settings.localizer);
  localizer.start(settings.known_start ? prior_of(drive) : std::nullopt);
  Replay replay(drive, localizer, fate);
  const std::vector<TruthSample> instants = instants_of(drive);
  std::vector<Epoch> epochs;
  for (const TruthSample& truth : instants) {
    replay.advance_to(truth.stamp);
    epochs.push_back(epoch_of(localizer.estimate(), truth, replay.last()));
    epochs.back().state = localizer.state();
    if (progress && epochs.size() % 64 == 0) {
      progress(static_cast<double>(epochs.size()) / static_cast<double>(instants.size()));
    }
  }
  replay.advance_to(std::numeric_limits<double>::max());
  return epochs;
}

}  // namespace multipath_localization
