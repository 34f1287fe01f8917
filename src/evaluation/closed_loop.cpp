#include "evaluation/closed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

namespace {

/// Keeps how near the robot truly came to each waypoint the follower steered for.
class CourseWatch {
 public:
  explicit CourseWatch(const WaypointFollower& follower) : follower_(follower) {}

  void see(const Eigen::Vector2d& truth, const MotionCommand& command, double duration) {
    const std::vector<Eigen::Vector2d>& waypoints = follower_.waypoints();
    if (waypoints.empty()) return;
    const std::size_t passed =
        waypoints.size() * static_cast<std::size_t>(follower_.route().rounds()) + follower_.target();
    closest_.resize(passed + 1, std::numeric_limits<double>::infinity());
    for (std::size_t i = passed == 0 ? 0 : passed - 1; i <= passed; ++i) {
      closest_[i] = std::min(closest_[i], (waypoints[i % waypoints.size()] - truth).norm());
    }
    if (command.speed == 0.0) standing_ += duration;
  }

  [[nodiscard]] Course course() const {
    Course course;
    course.standing = standing_;
    course.laps = follower_.route().rounds();
    if (closest_.size() < 2) return course;
    course.waypoints_passed = closest_.size() - 1;
    course.worst_miss = *std::max_element(closest_.begin(), closest_.end() - 1);
    return course;
  }

 private:
  const WaypointFollower& follower_;
  std::vector<double> closest_;  ///< by number of waypoints passed before; the last is still steered for
  double standing_ = 0.0;
};

TruthSample truth_of(const Simulator& simulator) {
  TruthSample sample;
  sample.stamp = simulator.time();
  sample.base_in_map = simulator.truth();
  sample.has_yaw = true;
  sample.shadow = simulator.around().in_shadow;
  return sample;
}

/// What the follower knows of where the robot is: published with each odometry.
struct Published {
  double stamp = -std::numeric_limits<double>::infinity();
  Pose2 pose;
  Trust trust = Trust::kNotReady;
  double sigma = 0.0;  ///< of the position to a side [m]
};

/// What the follower is told at the end of a step.
Published published_by(const Scenario& scenario, const Simulator& simulator, const PoseEstimate& estimate,
                       Trust trust) {
  if (scenario.steered_on_truth) return {simulator.time(), simulator.truth(), Trust::kGood};
  return {simulator.time(), estimate.pose, trust,
          mean_sigma(covariance_overall(estimate).topLeftCorner<2, 2>())};
}

/// Who gives the robot's commands: the follower, or a sequence whatever the estimate.
class Driver {
 public:
  explicit Driver(const Scenario& scenario)
      : scenario_(scenario),
        follower_(scenario.steering, scenario.waypoints),
        limiter_(scenario.steering.limits, scenario.steering.wheelbase) {}

  /// The command for the next `duration` [s], by what is published at `time` [s].
  MotionCommand command(const Published& published, double time, double duration) {
    if (!scenario_.sequence.empty()) {
      return command_at(scenario_.sequence, time, scenario_.simulator.robot.wheelbase);
    }
    const double age = time - published.stamp;
    const FollowerOutput output = follower_.command(limiter_.carried_forward(published.pose, age), age,
                                                    published.trust, published.sigma);
    return limiter_.limited(output.command, output.urgent, duration);
  }

  [[nodiscard]] const WaypointFollower& follower() const { return follower_; }

 private:
  const Scenario& scenario_;
  WaypointFollower follower_;
  CommandLimiter limiter_;
};

/// Without the fixes that a fault makes say they are none, which no reader takes.
std::vector<Measurement> readable(const Simulator& simulator, std::vector<Measurement> measurements) {
  const auto claims_no_fix = [&](const Measurement& measurement) {
    const bool fix = std::holds_alternative<GnssFix>(measurement);
    return fix && simulator.claimed_status(stamp_of(measurement)).value_or(0) < 0;
  };
  measurements.erase(std::remove_if(measurements.begin(), measurements.end(), claims_no_fix),
                     measurements.end());
  return measurements;
}

/// Puts what was read of the motion in one step on the stream and on record.
void take_motion(const Readings& readings, double now, Localizer& localizer, Drive& drive) {
  for (const YawRate& yaw_rate : readings.yaw_rates) {
    localizer.add(yaw_rate);
    drive.yaw_rates.push_back({yaw_rate, now});
  }
  if (!readings.odometry) return;
  localizer.add(*readings.odometry);
  drive.odometry.push_back(*readings.odometry);
}

}  // namespace

ClosedLoopRun run_scenario(const Scenario& scenario, std::uint64_t seed, const EstimatorFactory& make,
                           const RunSettings& settings, const ProgressReport& progress,
                           const FateReport& fate) {
  Simulator simulator(scenario.simulator, seed);
  Driver driver(scenario);
  CourseWatch watch(driver.follower());
  Localizer localizer(make(), settings.localizer);
  localizer.start(settings.known_start ? std::optional(known_start(0.0, simulator.truth())) : std::nullopt);

  ClosedLoopRun run;
  run.drive.name = scenario.name;
  run.drive.datum = scenario.simulator.datum();
  Published published;
  std::optional<OdometryIncrement> last;
  const auto steps = static_cast<std::int64_t>(std::llround(scenario.duration / simulator.time_step()));
  for (std::int64_t step = 0; step < steps; ++step) {
    const MotionCommand command = driver.command(published, simulator.time(), simulator.time_step());
    const Readings readings = simulator.step(command);
    take_motion(readings, simulator.time(), localizer, run.drive);
    if (readings.odometry) last = readings.odometry;
    for (const Measurement& measurement : readable(simulator, readings.measurements)) {
      localizer.add(measurement);
      run.drive.measurements.push_back({measurement, simulator.time()});
    }
    hand_on_reports(localizer, fate);
    run.drive.truth.push_back(truth_of(simulator));
    const PoseEstimate estimate = localizer.estimate();
    run.epochs.push_back(epoch_of(estimate, run.drive.truth.back(), last));
    run.epochs.back().state = localizer.state();
    if (readings.odometry) published = published_by(scenario, simulator, estimate, run.epochs.back().state);
    watch.see(simulator.truth().position(), command, simulator.time_step());
    if (progress && step % 64 == 0) progress(static_cast<double>(step) / static_cast<double>(steps));
  }
  run.course = watch.course();
  return run;
}

}  // namespace multipath_localization
