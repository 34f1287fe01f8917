#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/NavSatFix.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/random.hpp"
#include "ros/parameters/parameter_server.hpp"
#include "tools/live/node_process.hpp"
#include "tools/live/sensor_messages.hpp"

/// Measures how long after an odometry message the pose arrives that localization_node answers it with, and
/// what share of a core the node takes. Times run from before `publish` in this program to the callback in
/// this program, by the steady clock: serialisation, TCP both ways and all queues are included, nothing is
/// subtracted.
namespace multipath_localization {
namespace {

using Clock = std::chrono::steady_clock;

struct LatencyParameters {
  double duration = 30.0;
  double odometry_rate = 50.0;
  int odometry_per_fix = 10;
  double warm_up = 5.0;
  std::string node = "/localization";

  void fields(ParameterVisitor& field) {
    field("duration", duration, {1.0, 3600.0}, "s", "of the measurement");
    field("odometry_rate", odometry_rate, {1.0, 1000.0}, "Hz", "of odometry");
    field("odometry_per_fix", odometry_per_fix, {1, 1000}, "1", "odometry messages to one fix");
    field("warm_up", warm_up, {0.0, 60.0}, "s", "before the measurement");
    field("node", node, {}, "the localization_node to measure");
  }
};

/// A robot on a circle, under open sky.
class Stream {
 public:
  nav_msgs::Odometry odometry(const ros::Time& stamp, double interval) {
    return sensors_.odometry({0.0, interval, kSpeed, kYawRate}, stamp);
  }

  [[nodiscard]] sensor_msgs::NavSatFix fix(std::uint32_t step, const ros::Time& stamp) const {
    RandomStream random(1, step, 0);
    return sensors_.fix(sensors_.base_in_odom().position(), stamp, random);
  }

 private:
  static constexpr double kSpeed = 2.0;
  static constexpr double kYawRate = 0.1;

  SensorMessages sensors_;
};

/// When messages left and how long their answers took.
class Stopwatch {
 public:
  void left(const ros::Time& stamp) {
    const std::lock_guard<std::mutex> lock(mutex_);
    left_[stamp] = Clock::now();
  }

  void answered(const ros::Time& stamp) {
    const auto now = Clock::now();
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = left_.find(stamp);
    if (found == left_.end()) return;
    latencies_.push_back(std::chrono::duration<double>(now - found->second).count());
    left_.erase(found);
  }

  void restart() {
    const std::lock_guard<std::mutex> lock(mutex_);
    left_.clear();
    latencies_.clear();
  }

  /// Sorted [s].
  std::vector<double> latencies() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::sort(latencies_.begin(), latencies_.end());
    return latencies_;
  }

 private:
  std::mutex mutex_;
  std::map<ros::Time, Clock::time_point> left_;
  std::vector<double> latencies_;
};

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return std::nan("");
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// Sends the stream in real time and gives the share of a core that the node took meanwhile.
double drive(const LatencyParameters& parameters, const ros::Publisher& odometry, const ros::Publisher& fixes,
             Stopwatch& stopwatch) {
  Stream stream;
  const NodeProcess process(parameters.node);
  const double interval = 1.0 / parameters.odometry_rate;
  const auto warm_up = static_cast<std::uint32_t>(parameters.warm_up / interval);
  const auto steps = warm_up + static_cast<std::uint32_t>(parameters.duration / interval);
  const ros::Time start = ros::Time::now();
  const auto begin = Clock::now();
  double cpu_before = 0.0;
  for (std::uint32_t step = 0; step < steps && ros::ok(); ++step) {
    std::this_thread::sleep_until(begin + std::chrono::duration<double>(step * interval));
    if (step == warm_up) {
      stopwatch.restart();
      cpu_before = process.cpu_time();
    }
    const ros::Time stamp = start + ros::Duration(step * interval);
    const nav_msgs::Odometry message = stream.odometry(stamp, interval);
    if (step % static_cast<std::uint32_t>(parameters.odometry_per_fix) == 0)
      fixes.publish(stream.fix(step, stamp));
    stopwatch.left(stamp);
    odometry.publish(message);
  }
  ros::WallDuration(0.2).sleep();
  return (process.cpu_time() - cpu_before) / parameters.duration;
}

int measure(const LatencyParameters& parameters) {
  ros::NodeHandle node;
  Stopwatch stopwatch;
  const ros::Publisher odometry = node.advertise<nav_msgs::Odometry>("odom", 100);
  const ros::Publisher fixes = node.advertise<sensor_msgs::NavSatFix>("gps/fix", 100);
  const boost::function<void(const nav_msgs::Odometry&)> on_pose = [&](const nav_msgs::Odometry& message) {
    stopwatch.answered(message.header.stamp);
  };
  const ros::Subscriber poses = node.subscribe<nav_msgs::Odometry>(
      "odometry/filtered_map", 100, on_pose, nullptr, ros::TransportHints().tcpNoDelay());
  ros::AsyncSpinner spinner(1);
  spinner.start();
  while (ros::ok() && (odometry.getNumSubscribers() == 0 || fixes.getNumSubscribers() == 0)) {
    ros::WallDuration(0.1).sleep();
  }
  const double cpu = drive(parameters, odometry, fixes, stopwatch);
  const std::vector<double> latencies = stopwatch.latencies();
  std::printf(
      "%zu of %.0f answered; latency median %.3f ms, 99 %% %.3f ms, max %.3f ms; CPU %.2f %% of a core\n",
      latencies.size(), parameters.duration * parameters.odometry_rate, 1e3 * quantile(latencies, 0.5),
      1e3 * quantile(latencies, 0.99), 1e3 * quantile(latencies, 1.0), 100.0 * cpu);
  return latencies.empty() ? 1 : 0;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  namespace ml = multipath_localization;
  ros::init(argc, argv, "latency");
  ros::NodeHandle keep_alive;
  try {
    ml::LatencyParameters parameters;
    ml::load(ml::read_parameters(ros::NodeHandle("~")), parameters);
    return ml::measure(parameters);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "latency: %s\n", error.what());
    return 1;
  }
}
