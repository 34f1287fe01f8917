#include "ros/gnss_epoch_node/gnss_epoch_node.hpp"

#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <utility>

namespace multipath_localization {

namespace {

constexpr double kTick = 0.005;        // [s, wall clock]
constexpr double kLargestStep = 0.2;   // per tick, where time is ours to slow down [s]
constexpr double kFirstStamp = 1.0;    // ROS has no time zero [s]
constexpr double kLastMessages = 0.5;  // time to leave the queues before the exit [s]
constexpr std::uint32_t kQueue = 1000;

std::vector<DriveEvent> events_from(const Drive& drive, double start) {
  std::vector<DriveEvent> events = events_of(drive);
  const double first = drive.start() + start;
  events.erase(events.begin(), std::find_if(events.begin(), events.end(), [first](const DriveEvent& event) {
                 return event.time >= first;
               }));
  if (events.empty()) throw ParameterError("start: the drive is over by then");
  return events;
}

geometry_msgs::TransformStamped transform_of(const nav_msgs::Odometry& odometry) {
  geometry_msgs::TransformStamped transform;
  transform.header = odometry.header;
  transform.child_frame_id = odometry.child_frame_id;
  transform.transform.translation.x = odometry.pose.pose.position.x;
  transform.transform.translation.y = odometry.pose.pose.position.y;
  transform.transform.rotation = odometry.pose.pose.orientation;
  return transform;
}

}  // namespace

void GnssEpochNodeParameters::fields(ParameterVisitor& field) {
  field("drive", drive, {}, "the directory: odometry.csv, fix.csv or pseudoranges.csv or both, truth.csv");
  field("rate", rate, {0.01, 100.0}, "1",
        "recorded seconds per second; other than 1 the node drives /clock and needs /use_sim_time");
  field("start", start, {0.0, 1e6}, "s", "of the drive that is left out");
  field("delay", delay, {0.0, 60.0}, "s", "before the first message, for the listeners to come up");
  field("at_end", at_end, {"exit", "hold", "loop"}, "of the drive: leave, stay, or play it again");
  field("loop_pause", loop_pause, {0.0, 600.0}, "s",
        "silence before it is played again; more than odometry/max_gap of localization_node makes that start "
        "afresh");
  field("publish_clock", publish_clock, "drive /clock at the recorded pace too");
  frames.fields(field);
}

GnssEpochNode::GnssEpochNode(const ros::NodeHandle& node, const GnssEpochNodeParameters& parameters)
    : parameters_(parameters),
      drive_(read_drive(parameters.drive)),
      events_(events_from(drive_, parameters.start)),
      messages_(drive_.datum, parameters.frames, [this](double time) { return stamp(time); }) {
  if (parameters_.drives_clock() && !ros::Time::isSimTime()) {
    throw ParameterError("rate and publish_clock need /use_sim_time to be true before any node starts");
  }
  ros::NodeHandle outer(node);
  time_ = events_.front().time - parameters_.delay * parameters_.rate;
  shift_ = parameters_.drives_clock() ? std::max(0.0, kFirstStamp - time_) : ros::Time::now().toSec() - time_;
  advertise(outer);
  static_transforms_.sendTransform(messages_.static_transforms(drive_).transforms);
  for (const std::string& notice : drive_.notices) ROS_INFO("%s: %s", drive_.name.c_str(), notice.c_str());
  ROS_INFO("%s: %.1f s; datum [%.9f, %.9f, %.3f]", drive_.name.c_str(),
           events_.back().time - events_.front().time, drive_.datum.latitude_deg, drive_.datum.longitude_deg,
           drive_.datum.altitude);
  last_tick_ = ros::WallTime::now();
  timer_ = outer.createWallTimer(ros::WallDuration(kTick), [this](const ros::WallTimerEvent&) { tick(); });
}

void GnssEpochNode::advertise(ros::NodeHandle& node) {
  for (const DriveEvent& event : events_) {
    for (const TopicMessage& made : messages_.of(event)) {
      if (publishers_.count(made.topic) > 0) continue;
      std::visit(
          [&](const auto& message) {
            publishers_[made.topic] = node.advertise<std::decay_t<decltype(message)>>(made.topic, kQueue);
          },
          made.message);
    }
  }
  messages_.restart();
  if (parameters_.drives_clock()) clock_ = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
}

void GnssEpochNode::tick() {
  const ros::WallTime now = ros::WallTime::now();
  const double passed = (now - std::exchange(last_tick_, now)).toSec() * parameters_.rate;
  time_ += parameters_.drives_clock() ? std::min(passed, kLargestStep) : passed;
  while (!ended_ && events_[next_].time <= time_) {
    publish(events_[next_]);
    if (++next_ == events_.size()) end();
  }
  publish_clock(time_);
}

void GnssEpochNode::publish(const DriveEvent& event) {
  publish_clock(event.time);
  for (const TopicMessage& made : messages_.of(event)) {
    std::visit([&](const auto& message) { publishers_.at(made.topic).publish(message); }, made.message);
    const auto* odometry = std::get_if<nav_msgs::Odometry>(&made.message);
    if (odometry != nullptr && made.topic == "odom") transforms_.sendTransform(transform_of(*odometry));
  }
}

void GnssEpochNode::publish_clock(double time) {
  if (!clock_) return;
  rosgraph_msgs::Clock message;
  message.clock = stamp(time);
  clock_.publish(message);
}

void GnssEpochNode::end() {
  ROS_INFO("end of the drive %s", drive_.name.c_str());
  if (parameters_.at_end == "loop") {
    const double back = events_.back().time - events_.front().time + parameters_.loop_pause;
    shift_ += back;
    time_ -= back;
    next_ = 0;
    messages_.restart();
    return;
  }
  ended_ = true;
  if (parameters_.at_end == "hold") return;
  exit_timer_ = ros::NodeHandle().createWallTimer(
      ros::WallDuration(kLastMessages), [](const ros::WallTimerEvent&) { ros::shutdown(); }, true);
}

}  // namespace multipath_localization
