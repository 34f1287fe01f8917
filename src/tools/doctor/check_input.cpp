#include <algorithm>
#include <cmath>

#include "evaluation/metrics.hpp"
#include "ros/messages/conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {

namespace {

constexpr double kSlowestFixes = 0.5;      // [Hz]
constexpr double kSlowestOdometry = 10.0;  // [Hz]
constexpr double kClockError = 1.0;        // of odometry, which comes in as soon as it is stamped [s]
constexpr double kOtherClock = 10.0;       // no receiver is that late [s]
constexpr double kNearly = 0.95;           // of a rate, which is as good
constexpr double kLongestBridge = 60.0;    // nobody knows where a robot went for longer [s]
constexpr double kLongInterval = 2.0;      // that is a silence where it stands out [s]
constexpr double kManyIntervals = 5.0;     // times the mean, which stands out
constexpr double kBurst = 0.3;             // of the mean interval, within a burst
constexpr double kManyInBursts = 0.4;      // of the intervals
constexpr char kSetTheClock[] =
    "sudo chronyc makestep on every host, with chrony fed by NTP or by the receiver";

/// One of the two inputs, as the checks that are the same for both see it.
struct Input {
  std::string argument;  ///< of localization.launch
  std::string topic;     ///< as the node expects it
  std::string found;     ///< where messages of the type are
  std::string type;
  std::vector<double> stamps;
  std::vector<double> arrivals;
  double slowest;  ///< rate [Hz]
};

template <class Message>
Input input(const std::string& argument, const std::string& topic, const std::string& type,
            const std::vector<Arrived<Message>>& messages, const Observations& seen, double slowest) {
  Input result{argument, without_slash(topic), resolved(seen.types, topic, type), type, {}, {}, slowest};
  for (const Arrived<Message>& arrived : messages) {
    result.stamps.push_back(arrived.message.header.stamp.toSec());
    result.arrivals.push_back(arrived.time);
  }
  return result;
}

std::vector<Input> inputs(const Observations& seen) {
  return {input("fix", seen.fix_topic, "sensor_msgs/NavSatFix", seen.fixes, seen, kSlowestFixes),
          input("odom", seen.odometry_topic, "nav_msgs/Odometry", seen.odometry, seen, kSlowestOdometry)};
}

std::string launch_with(const Observations& seen, const Input& in) {
  return std::string("roslaunch multipath_localization ") +
         (seen.from_bag ? "bag.launch bag:=FILE " + in.argument + "_topic:=/"
                        : "localization.launch " + in.argument + ":=/") +
         in.found;
}

Finding of_another_version(const std::string& topic, const std::string& type) {
  return fix(
      "/" + topic + " is a " + type + " of another version, which cannot be read",
      "record it with the message definitions of this machine; rosbag check tells whether the bag can be "
      "migrated: rosbag fix");
}

/// A topic of which wheel_odometry_node may make odometry; empty where there is none.
std::string topic_of_wheels(const Observations& seen) {
  for (const char* type : {"ackermann_msgs/AckermannDriveStamped", "sensor_msgs/JointState"}) {
    for (const auto& [topic, its_type] : seen.types) {
      if (its_type == type) return topic;
    }
  }
  return "";
}

Finding topic_of(const Observations& seen, const Input& in) {
  if (seen.other_versions.count(in.found) > 0) return of_another_version(in.found, in.type);
  if (in.found == in.topic && !in.stamps.empty()) {
    return pass(text("%s: %zu messages on /%s", in.argument.c_str(), in.stamps.size(), in.found.c_str()));
  }
  const auto named = seen.types.find(in.topic);
  if (named != seen.types.end() && named->second != in.type) {
    return fix("/" + in.topic + " is a " + named->second + ", not a " + in.type,
               in.found != in.topic ? launch_with(seen, in) : "have the driver publish " + in.type);
  }
  if (in.found != in.topic) {
    return fix("nothing on /" + in.topic + ", but " + in.type + " on /" + in.found, launch_with(seen, in));
  }
  const std::string wheels = in.argument == "odom" ? topic_of_wheels(seen) : "";
  return fix("no message on /" + in.topic + " (" + in.type + ")",
             "start the driver, or name the topic: --" + in.argument + "-topic TOPIC" +
                 (wheels.empty() ? ""
                                 : "; or have /" + wheels +
                                       " become odometry: robot.launch wheels:=FILE, a copy of "
                                       "config/wheel_odometry.yaml"));
}

/// Messages a second and the longest silence [s]. Silences that stand out do not lower the rate.
struct Pace {
  double rate;  ///< [Hz]
  double gap;
};

Pace pace_of(const std::vector<double>& arrivals) {
  const double span = std::max(arrivals.back() - arrivals.front(), 1e-3);
  const auto count = static_cast<double>(arrivals.size() - 1);
  const double longest_interval = std::max(kLongInterval, kManyIntervals * span / count);
  double counted = 0.0, time = 0.0, gap = 0.0;
  for (std::size_t i = 1; i < arrivals.size(); ++i) {
    const double interval = arrivals[i] - arrivals[i - 1];
    gap = std::max(gap, interval);
    if (interval > longest_interval) continue;
    time += interval;
    ++counted;
  }
  return {counted / std::max(time, 1e-3), gap};
}

Finding rate_of(const Input& in, double bridged) {
  const auto [rate, gap] = pace_of(in.arrivals);
  const std::string seen = text("%s: %.2f Hz, longest gap %.2f s", in.argument.c_str(), rate, gap);
  if (rate < kNearly * in.slowest)
    return fix(seen, text("set the driver's rate to %g Hz or more", in.slowest));
  if (in.argument == "odom" && gap > bridged) {
    const bool bridgeable = gap < kLongestBridge;
    return fix(seen, "find what stops it" +
                         (bridgeable ? text(", or bridge it: localization.yaml, odometry: {max_gap: %.0f}",
                                            std::ceil(gap))
                                     : std::string()));
  }
  return pass(seen);
}

/// Whether many stamps follow the one before much sooner than the mean.
bool comes_in_bursts(const Input& in) {
  const auto count = static_cast<double>(in.stamps.size() - 1);
  const double mean = (in.stamps.back() - in.stamps.front()) / count;
  double soon = 0.0;
  for (std::size_t i = 1; i < in.stamps.size(); ++i) {
    if (in.stamps[i] - in.stamps[i - 1] < kBurst * mean) ++soon;
  }
  return soon > kManyInBursts * count;
}

Finding stamps_of(const Input& in) {
  std::size_t zero = 0, repeated = 0, backwards = 0;
  for (std::size_t i = 0; i < in.stamps.size(); ++i) {
    if (in.stamps[i] == 0.0) ++zero;
    if (i == 0) continue;
    if (in.stamps[i] == in.stamps[i - 1]) ++repeated;
    if (in.stamps[i] < in.stamps[i - 1]) ++backwards;
  }
  const std::string what = in.argument + ": ";
  if (zero > 0) {
    return fix(what + text("%zu stamps of zero", zero),
               "in the driver: msg.header.stamp = ros::Time::now();");
  }
  if (backwards > 0) {
    return fix(
        what + text("%zu stamps go back", backwards),
        "run one driver on this topic only: rostopic info /" + in.found + ", or cut the bag: rosbag filter");
  }
  if (repeated > 0) {
    return fix(what + text("%zu stamps come twice", repeated),
               "run one driver on this topic only (rostopic info /" + in.found +
                   "); if there is one, stamp each message with the time its data are of, not with that of a "
                   "packet of several");
  }
  return comes_in_bursts(in)
             ? untold(what +
                      "stamps come in bursts, as times of arrival do: stamped when sampled it would be more "
                      "precise")
             : pass(what + "stamps increase");
}

/// Whether most stamps are filled in.
bool is_stamped(const Input& in) {
  const auto zero = std::count(in.stamps.begin(), in.stamps.end(), 0.0);
  return !in.stamps.empty() && 2 * static_cast<std::size_t>(zero) < in.stamps.size();
}

/// Median of arrival - stamp [s].
double lateness(const Input& in) {
  std::vector<double> late;
  for (std::size_t i = 0; i < in.stamps.size(); ++i) late.push_back(in.arrivals[i] - in.stamps[i]);
  return quantile(late, 0.5);
}

}  // namespace

Findings check_topics(const Observations& seen) {
  Findings all;
  for (const Input& in : inputs(seen)) all.push_back(topic_of(seen, in));
  for (const char* topic : {"tf", "tf_static"}) {
    const auto other = seen.other_versions.find(topic);
    if (other != seen.other_versions.end()) all.push_back(of_another_version(topic, other->second));
  }
  return all;
}

Findings check_rates(const Observations& seen) {
  Findings all;
  for (const Input& in : inputs(seen)) {
    if (in.arrivals.size() > 1) all.push_back(rate_of(in, seen.odometry_parameters.max_gap));
  }
  return all;
}

Findings check_stamps(const Observations& seen) {
  Findings all;
  for (const Input& in : inputs(seen)) {
    if (!in.stamps.empty()) all.push_back(stamps_of(in));
  }
  return all;
}

Findings check_clocks(const Observations& seen) {
  const std::vector<Input> both = inputs(seen);
  if (!is_stamped(both[0]) || !is_stamped(both[1])) return {};
  const double odometry_late = lateness(both[1]);
  const double behind = lateness(both[0]) - odometry_late;
  const LocalizerParameters& node = seen.localizer_parameters;
  Findings all;
  if (behind < -node.future_tolerance || behind > kOtherClock) {
    all.push_back(fix(text("fix: stamped %.2f s %s the odometry that comes in with it: two clocks",
                           std::abs(behind), behind < 0.0 ? "ahead of" : "behind"),
                      kSetTheClock));
  } else if (behind > node.history_length) {
    all.push_back(fix(
        text("fix: %.1f s late against the odometry, of which %.0f s are kept", behind, node.history_length),
        text("localization.yaml, localizer: {history_length: %.0f}", std::ceil(behind) + 1.0)));
  } else {
    all.push_back(pass(text("fix: %.2f s late against the odometry", behind)));
  }
  if (!seen.from_bag && std::abs(odometry_late) > kClockError) {
    all.push_back(fix(text("odom: stamped %.1f s %s the host's clock", std::abs(odometry_late),
                           odometry_late < 0.0 ? "ahead of" : "behind"),
                      kSetTheClock));
  }
  return all;
}

Findings check_simulated_time(const Observations& seen) {
  if (seen.from_bag) {
    if (!seen.clock) return {};
    return {fix("the bag holds /clock, which fights with rosbag play --clock",
                "rosbag filter IN.bag OUT.bag \"topic != '/clock'\"")};
  }
  if (seen.clock && !seen.use_sim_time) {
    return {fix("somebody publishes /clock, but /use_sim_time is not set",
                "before any node starts: rosparam set use_sim_time true")};
  }
  if (!seen.clock && seen.use_sim_time) {
    return {fix("/use_sim_time is set, but nobody publishes /clock, so time stands",
                "rosbag play --clock FILE, or on a robot: rosparam set use_sim_time false")};
  }
  return {pass(seen.clock ? "time is simulated, and all know" : "time is the host's")};
}

}  // namespace multipath_localization
