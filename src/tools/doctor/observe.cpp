#include "tools/doctor/observe.hpp"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/bags/bag_file.hpp"
#include "ros/map/datum_file.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/messages/heading_conversions.hpp"
#include "ros/messages/velocity_conversions.hpp"
#include "ros/parameters/parameter_server.hpp"

namespace multipath_localization {

namespace {

constexpr double kFirstTick = 2.0;  // of a simulated clock at the latest [s]

void take_parameters(const YAML::Node& source, Observations& seen) {
  const LocalizationParameters parameters = LocalizationSettings::from(source).parameters;
  seen.frames = parameters.frames;
  seen.datum = parameters.datum.numbers;
  const auto saved = parameters.datum_file.empty() ? std::nullopt : read_datum(parameters.datum_file);
  if (saved) {
    seen.datum = {saved->latitude_deg, saved->longitude_deg};
    seen.datum_file = parameters.datum_file;
  }
  seen.antenna = parameters.gnss.antenna;
  seen.fix_parameters = parameters.gnss.fix;
  seen.odometry_parameters = parameters.odometry;
  seen.localizer_parameters = parameters.localizer;
}

Observations begin(const ObservationRequest& request) {
  Observations seen;
  seen.fix_topic = request.fix_topic;
  seen.odometry_topic = request.odometry_topic;
  seen.imu_topic = request.imu_topic;
  seen.velocity_topic = request.velocity_topic;
  seen.heading_topic = request.heading_topic;
  if (!request.parameters.empty()) take_parameters(read_yaml(request.parameters), seen);
  return seen;
}

std::string fix_topic_of(const Observations& seen) {
  return resolved(seen.types, seen.fix_topic, ros::message_traits::datatype<sensor_msgs::NavSatFix>());
}

std::string odometry_topic_of(const Observations& seen) {
  return resolved(seen.types, seen.odometry_topic, ros::message_traits::datatype<nav_msgs::Odometry>());
}

std::string imu_topic_of(const Observations& seen) {
  auto types = seen.types;
  types.erase(without_slash(seen.heading_topic));
  return resolved(types, seen.imu_topic, ros::message_traits::datatype<sensor_msgs::Imu>());
}

void take_extras(const rosbag::MessageInstance& message, Observations& seen) {
  const std::string topic = without_slash(message.getTopic());
  const double time = message.getTime().toSec();
  if (topic == imu_topic_of(seen)) {
    if (const auto imu = message.instantiate<sensor_msgs::Imu>()) seen.imus.push_back({*imu, time});
  }
  if (topic == without_slash(seen.heading_topic)) {
    if (const auto heading = heading_of(message)) seen.headings.push_back({*heading, time});
  }
  if (topic != without_slash(seen.velocity_topic)) return;
  using Velocity = geometry_msgs::TwistWithCovarianceStamped;
  if (const auto velocity = message.instantiate<Velocity>()) seen.velocities.push_back({*velocity, time});
  if (const auto bare = message.instantiate<geometry_msgs::TwistStamped>()) {
    seen.velocities.push_back({without_covariance(*bare), time});
  }
}

void take(const tf2_msgs::TFMessage& message, const std::string& node, bool is_static, Observations& seen) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    seen.transforms.push_back({transform, node, is_static});
  }
}

void take_connections(rosbag::View& view, Observations& seen) {
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    const std::string topic = without_slash(connection->topic);
    seen.types[topic] = connection->datatype;
    if (of_another_version(*connection)) seen.other_versions[topic] = connection->datatype;
  }
  seen.clock = seen.types.count("clock") > 0;
}

void take(const rosbag::Bag& bag, Observations& seen) {
  rosbag::View view(bag);
  take_connections(view, seen);
  const std::string fix_topic = fix_topic_of(seen);
  const std::string odometry_topic = odometry_topic_of(seen);
  for (const rosbag::MessageInstance& message : view) {
    const std::string topic = without_slash(message.getTopic());
    const double time = message.getTime().toSec();
    if (topic == fix_topic) {
      if (const auto fix = message.instantiate<sensor_msgs::NavSatFix>()) seen.fixes.push_back({*fix, time});
    }
    if (topic == odometry_topic) {
      if (const auto odom = message.instantiate<nav_msgs::Odometry>()) seen.odometry.push_back({*odom, time});
    }
    take_extras(message, seen);
    if (topic == "tf" || topic == "tf_static") {
      const auto transforms = message.instantiate<tf2_msgs::TFMessage>();
      if (transforms) take(*transforms, message.getCallerId(), topic == "tf_static", seen);
    }
  }
}

/// Takes what comes in for `seconds`. Whether /clock ticks shows in its messages alone: a player without a
/// clock advertises it too.
void listen(double seconds, Observations& seen) {
  using Transforms = ros::MessageEvent<tf2_msgs::TFMessage const>;
  const auto now = [] { return ros::Time::now().toSec(); };
  const boost::function<void(const sensor_msgs::NavSatFix&)> on_fix = [&](const auto& fix) {
    seen.fixes.push_back({fix, now()});
  };
  const boost::function<void(const nav_msgs::Odometry&)> on_odometry = [&](const auto& odometry) {
    seen.odometry.push_back({odometry, now()});
  };
  const boost::function<void(const sensor_msgs::Imu&)> on_imu = [&](const auto& imu) {
    seen.imus.push_back({imu, now()});
  };
  const boost::function<void(const topic_tools::ShapeShifter&)> on_velocity = [&](const auto& message) {
    if (const auto velocity = velocity_of(message)) seen.velocities.push_back({*velocity, now()});
  };
  const boost::function<void(const topic_tools::ShapeShifter&)> on_heading = [&](const auto& message) {
    if (const auto heading = heading_of(message)) seen.headings.push_back({*heading, now()});
  };
  const boost::function<void(const rosgraph_msgs::Clock&)> on_clock = [&](const auto&) { seen.clock = true; };
  const auto on_transforms = [&](bool is_static) {
    return boost::function<void(const Transforms&)>([&seen, is_static](const Transforms& event) {
      take(*event.getConstMessage(), event.getPublisherName(), is_static, seen);
    });
  };
  ros::NodeHandle node;
  ros::Time::waitForValid(ros::WallDuration(kFirstTick));
  const std::vector<ros::Subscriber> subscribers = {
      node.subscribe<sensor_msgs::NavSatFix>("/" + fix_topic_of(seen), 1000, on_fix),
      node.subscribe<nav_msgs::Odometry>("/" + odometry_topic_of(seen), 1000, on_odometry),
      node.subscribe<sensor_msgs::Imu>("/" + imu_topic_of(seen), 1000, on_imu),
      node.subscribe<topic_tools::ShapeShifter>("/" + without_slash(seen.velocity_topic), 1000, on_velocity),
      node.subscribe<topic_tools::ShapeShifter>("/" + without_slash(seen.heading_topic), 1000, on_heading),
      node.subscribe<rosgraph_msgs::Clock>("/clock", 10, on_clock),
      node.subscribe<tf2_msgs::TFMessage>("/tf", 1000, on_transforms(false)),
      node.subscribe<tf2_msgs::TFMessage>("/tf_static", 1000, on_transforms(true))};
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::ok() && ros::WallTime::now() < end) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
  }
}

}  // namespace

Observations observe_bag(const std::string& file, const ObservationRequest& request) {
  Observations seen = begin(request);
  with_bag(file, [&](const rosbag::Bag& bag) { take(bag, seen); });
  return seen;
}

Observations observe_live(const ObservationRequest& request) {
  Observations seen = begin(request);
  seen.from_bag = false;
  const YAML::Node parameters = read_parameters(ros::NodeHandle(request.node));
  if (parameters && request.parameters.empty()) take_parameters(parameters, seen);
  ros::param::get("/use_sim_time", seen.use_sim_time);
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  for (const ros::master::TopicInfo& topic : topics) seen.types[without_slash(topic.name)] = topic.datatype;
  listen(request.seconds, seen);
  return seen;
}

}  // namespace multipath_localization
