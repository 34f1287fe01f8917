#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/NavSatFix.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>

#include "multipath_localization/FixReport.h"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/random.hpp"
#include "ros/fault_injector_node/fault_injector.hpp"
#include "ros/parameters/parameter_server.hpp"
#include "tools/live/node_process.hpp"
#include "tools/live/sensor_messages.hpp"
#include "tools/soak/pose_audit.hpp"
#include "tools/soak/random_faults.hpp"
#include "tools/soak/wandering_robot.hpp"

/// Drives a robot for hours of its own time, with faults of every kind at random, past localization_node as
/// fast as it answers, and looks at every pose: answered, finite, with a proper covariance. Shows for each
/// hour the errors and the memory that the node holds. For a quarter of the time stamps count from zero, then
/// they leap so as to pass 2^31 s at half the time, where they leap an hour on, and back after a quarter
/// more.
namespace multipath_localization {
namespace {

constexpr double kHour = 3600.0;
constexpr double kOdometryRate = 20.0;  ///< [Hz]
constexpr int kOdometryPerFix = 10;
constexpr std::size_t kUnderWay = 10;        ///< odometry sent without waiting for answers
constexpr double kAnswerWithin = 2.0;        ///< [s]
constexpr double kOdometryAfterFixes = 1.0;  ///< at the end [s]
constexpr double kScale = 1.01;              ///< of the wheels
constexpr double kGyroBias = 2e-3;           ///< [rad/s]
constexpr double kRateNoise = 0.01;          ///< of speed [m/s] and yaw rate [rad/s]

struct SoakParameters {
  double hours = 24.0;
  int seed = 1;
  std::string node = "/localization";

  void fields(ParameterVisitor& field) {
    field("hours", hours, {0.01, 1000.0}, "h", "of the robot's time");
    field("seed", seed, {0, 1000000}, "1", "of faults and noise");
    field("node", node, {}, "the localization_node to look at");
  }
};

/// The receiver and the encoders of a wandering robot, spoilt; on a clock that starts at zero and never
/// leaps.
class Stream {
 public:
  explicit Stream(const SoakParameters& parameters)
      : seed_(static_cast<std::uint64_t>(parameters.seed)), robot_(seed_), faults_(injector(parameters)) {}

  struct Step {
    std::optional<nav_msgs::Odometry> odometry;  ///< nothing where it is lost
    std::vector<sensor_msgs::NavSatFix> fixes;
  };
  Step step() {
    RandomStream random(seed_, ++steps_, 1);
    OdometryIncrement u = robot_.step(1.0 / kOdometryRate);
    u.stamp = time();
    u.speed = kScale * u.speed + (u.speed != 0.0 ? kRateNoise * random.normal() : 0.0);
    u.yaw_rate += kGyroBias + kRateNoise * random.normal();
    Step step;
    if (steps_ % kOdometryPerFix == 0) {
      step.fixes = faults_.take(sensors_.fix(truth().position(), ros::Time(time()), random));
    }
    std::vector<sensor_msgs::NavSatFix> late;
    step.odometry = faults_.take(sensors_.odometry(u, ros::Time(u.stamp)), late);
    step.fixes.insert(step.fixes.end(), late.begin(), late.end());
    return step;
  }

  [[nodiscard]] double time() const { return steps_ / kOdometryRate; }
  [[nodiscard]] const Pose2& truth() const { return robot_.pose(); }

 private:
  static FaultInjectorParameters injector(const SoakParameters& parameters) {
    FaultInjectorParameters injector;
    injector.seed = parameters.seed;
    injector.faults = random_faults(parameters.hours, static_cast<std::uint64_t>(parameters.seed));
    return injector;
  }

  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  WanderingRobot robot_;
  FaultInjector faults_;
  SensorMessages sensors_;
};

/// Brings a stamp of the stream's to the clock of stamps as it is at `time`.
void leap(ros::Time& stamp, double time, double hours) {
  const double share = time / (hours * kHour);
  if (share < 0.25) return;
  stamp += ros::Duration(2147483648.0 - 0.5 * hours * kHour);
  if (share >= 0.5 && share < 0.75) stamp += ros::Duration(kHour);
}

void show(double time, const PoseAudit::Figures& figures, double memory) {
  std::printf(
      "%5.1f h  %7zu poses  rmse %5.2f m  max %6.2f m  beyond 3 sigma <= %5.1f s  %zu unanswered  %6.1f MB\n",
      time / kHour, figures.answered,
      std::sqrt(figures.square_sum / static_cast<double>(std::max<std::size_t>(1, figures.answered))),
      figures.largest, figures.longest_beyond, figures.unanswered, memory);
  if (figures.faulty > 0) std::printf("%zu faulty poses: %s\n", figures.faulty, figures.first_fault.c_str());
  std::fflush(stdout);
}

/// The stream's way to the node and back.
class Soak {
 public:
  explicit Soak(const SoakParameters& parameters)
      : parameters_(parameters),
        stream_(parameters),
        odometry_(node_.advertise<nav_msgs::Odometry>("odom", 1000)),
        fixes_(node_.advertise<sensor_msgs::NavSatFix>("gps/fix", 1000)),
        poses_(node_.subscribe<nav_msgs::Odometry>(
            "odometry/filtered_map", 1000,
            [this](const nav_msgs::OdometryConstPtr& m) { audit_.answered(*m); }, nullptr,
            ros::TransportHints().tcpNoDelay())),
        reports_(node_.subscribe<FixReport>("localization/fix_report", 1000,
                                            [this](const FixReportConstPtr&) { ++reported_; })) {}

  /// Returns whether nothing was wrong.
  bool run() {
    spinner_.start();
    while (ros::ok() && (odometry_.getNumSubscribers() == 0 || fixes_.getNumSubscribers() == 0 ||
                         poses_.getNumPublishers() == 0 || reports_.getNumPublishers() == 0)) {
      ros::WallDuration(0.1).sleep();
    }
    const NodeProcess process(parameters_.node);
    bool sound = true;
    for (double hour = 1.0; hour < parameters_.hours + 1.0 && ros::ok(); ++hour) {
      const double end = kHour * std::min(hour, parameters_.hours);
      while (stream_.time() < end && ros::ok()) send(stream_.step());
      audit_.wait_for(0, kAnswerWithin);
      const PoseAudit::Figures figures = audit_.take_figures();
      show(stream_.time(), figures, process.resident_memory());
      sound = sound && figures.faulty == 0;
    }
    use_up();
    std::printf("%zu fixes sent, %zu reported\n", sent_, reported_.load());
    return sound && sent_ == reported_;
  }

 private:
  void send(Stream::Step step) {
    for (sensor_msgs::NavSatFix& fix : step.fixes) {
      leap(fix.header.stamp, stream_.time(), parameters_.hours);
      fixes_.publish(fix);
      ++sent_;
    }
    if (!step.odometry) return;
    leap(step.odometry->header.stamp, stream_.time(), parameters_.hours);
    audit_.sent(step.odometry->header.stamp, stream_.truth());
    odometry_.publish(*step.odometry);
    audit_.wait_for(kUnderWay, kAnswerWithin);
  }

  /// A fix ahead of the odometry waits for it: drives on without fixes until the last one has its report.
  void use_up() {
    const double end = stream_.time() + kOdometryAfterFixes;
    while (stream_.time() < end && ros::ok()) {
      Stream::Step step = stream_.step();
      step.fixes.clear();
      send(std::move(step));
    }
    audit_.wait_for(0, kAnswerWithin);
    const ros::WallTime patience = ros::WallTime::now() + ros::WallDuration(kAnswerWithin);
    while (reported_ < sent_ && ros::WallTime::now() < patience) ros::WallDuration(0.01).sleep();
  }

  SoakParameters parameters_;
  Stream stream_;
  PoseAudit audit_;
  std::size_t sent_ = 0;                  ///< fixes
  std::atomic<std::size_t> reported_{0};  ///< of them
  ros::NodeHandle node_;
  ros::Publisher odometry_, fixes_;
  ros::Subscriber poses_, reports_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  namespace ml = multipath_localization;
  ros::init(argc, argv, "soak");
  const ros::NodeHandle keep_alive;
  try {
    ml::SoakParameters parameters;
    ml::load(ml::read_parameters(ros::NodeHandle("~")), parameters);
    return ml::Soak(parameters).run() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "soak: %s\n", error.what());
    return 1;
  }
}
