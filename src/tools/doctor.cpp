// Looks at a robot, live or in a bag, and says what has to be fixed before it can be localised.

#include <ros/ros.h>

#include <boost/program_options.hpp>
#include <iostream>

#include "tools/doctor/checks.hpp"
#include "tools/doctor/observe.hpp"
#include "tools/doctor/raw_stream.hpp"

namespace multipath_localization {
namespace {

namespace po = boost::program_options;

po::options_description options_of(ObservationRequest& request) {
  po::options_description options("What to look at", 110);
  const auto add = [&](auto... arguments) { options.add_options()(arguments...); };
  const auto text = [](std::string& value) { return po::value(&value)->default_value(value); };
  add("bag", po::value<std::string>(), "a bag; left out: the running robot");
  add("fix-topic", text(request.fix_topic), "of sensor_msgs/NavSatFix");
  add("odom-topic", text(request.odometry_topic), "of nav_msgs/Odometry");
  add("imu-topic", text(request.imu_topic), "of sensor_msgs/Imu, where there is one");
  add("velocity-topic", text(request.velocity_topic),
      "of geometry_msgs/TwistWithCovarianceStamped or TwistStamped, where there is one");
  add("heading-topic", text(request.heading_topic),
      "of sensor_msgs/Imu or geometry_msgs/PoseWithCovarianceStamped, where there is one");
  add("params", text(request.parameters), "parameters of localization_node, for frames and datum");
  add("node", text(request.node), "live: the node whose parameters count where --params is not given");
  add("seconds", po::value(&request.seconds)->default_value(request.seconds),
      "live: watch for so long; drive meanwhile");
  add("raw", po::value<std::string>(),
      "a u-blox receiver's own stream instead: a serial line, a file, tcp://host:port");
  add("baud", po::value<int>()->default_value(0), "of that serial line, 0: as it is");
  add("help", "print this");
  return options;
}

Observations observe(int argc, char** argv, const po::variables_map& given,
                     const ObservationRequest& request) {
  if (given.count("bag") > 0) return observe_bag(given["bag"].as<std::string>(), request);
  ros::init(argc, argv, "doctor", ros::init_options::AnonymousName);
  if (!ros::master::check()) throw std::runtime_error("no ROS master; start the robot, or give --bag FILE");
  return observe_live(request);
}

int report(const Findings& findings) {
  int to_fix = 0;
  for (const Finding& finding : findings) {
    std::cout << to_text(finding);
    to_fix += finding.verdict == Finding::Verdict::kFix ? 1 : 0;
  }
  std::cout << (to_fix == 0 ? "Nothing to fix.\n" : std::to_string(to_fix) + " to fix.\n");
  return to_fix == 0 ? 0 : 1;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  namespace ml = multipath_localization;
  try {
    ml::ObservationRequest request;
    const auto description = ml::options_of(request);
    ml::po::variables_map given;
    ml::po::store(ml::po::parse_command_line(argc, argv, description), given);
    ml::po::notify(given);
    if (given.count("help") > 0) {
      std::cout << description
                << "Exit status: 0 when nothing has to be fixed, 1 when something has, 2 on an error.\n";
      return 0;
    }
    if (given.count("raw") > 0) {
      return ml::report(ml::check_stream(
          ml::observe_stream(given["raw"].as<std::string>(), given["baud"].as<int>(), request.seconds)));
    }
    return ml::report(ml::diagnose(ml::observe(argc, argv, given, request)));
  } catch (const std::exception& error) {
    std::cerr << "doctor: " << error.what() << "\n";
    return 2;
  }
}
