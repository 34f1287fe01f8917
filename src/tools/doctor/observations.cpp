#include "tools/doctor/observations.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "ros/inputs/odometry_reader.hpp"
#include "ros/map/datum_search.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

std::vector<GnssFix> fixes_of(const Observations& seen) {
  std::vector<GnssFix> fixes;
  const std::optional<Geodetic> origin = place_of_fixes(seen);
  if (!origin) return fixes;
  const LocalFrame map(*origin);
  for (const auto& arrived : seen.fixes) {
    const CheckedFix checked = to_fix(arrived.message, map, seen.fix_parameters);
    const bool in_order = fixes.empty() || checked.fix.stamp > fixes.back().stamp;
    if (checked.reason == Reason::kAccepted && in_order) fixes.push_back(checked.fix);
  }
  return fixes;
}

nav_msgs::Odometry said_by(Voice voice, nav_msgs::Odometry message) {
  if (voice == Voice::kPoses) message.twist.twist = geometry_msgs::Twist();
  if (voice == Voice::kTwist) message.pose.pose = geometry_msgs::Pose();
  return message;
}

std::vector<OdometryIncrement> increments_of(const Observations& seen, Voice voice) {
  std::vector<OdometryIncrement> increments;
  OdometryReader reader(seen.odometry_parameters, seen.frames.map_frame);
  for (const auto& arrived : seen.odometry) {
    const CheckedOdometry checked = reader.read(said_by(voice, arrived.message));
    if (checked.restarted) increments.clear();
    if (checked.reason == Reason::kAccepted) increments.push_back(checked.increment);
  }
  return increments;
}

/// Whether a localisation puts that out, in whatever namespace.
bool is_output(const std::string& topic) {
  constexpr std::array<std::string_view, 3> kOutputs = {"/gps/filtered", "/odometry/gps",
                                                        "/odometry/filtered_map"};
  const std::string name = "/" + topic;
  return std::any_of(kOutputs.begin(), kOutputs.end(), [&](std::string_view output) {
    return name.size() >= output.size() &&
           name.compare(name.size() - output.size(), output.size(), output) == 0;
  });
}

}  // namespace

std::optional<Geodetic> place_of_fixes(const Observations& seen) {
  GnssParameters gnss;
  gnss.fix = seen.fix_parameters;
  DatumSearch search(gnss, seen.odometry_parameters.max_speed, 0.0);
  std::optional<Geodetic> first;
  for (const auto& arrived : seen.fixes) {
    if (check(arrived.message, seen.fix_parameters) != Reason::kAccepted) continue;
    if (!first) first = to_geodetic(arrived.message);
    search.add(arrived.message);
  }
  return search.place() ? search.place() : first;
}

Motion motion_of(const Observations& seen, Voice voice) {
  const std::vector<OdometryIncrement> increments = increments_of(seen, voice);
  return {fixes_of(seen), increments, OdometryTrack(increments)};
}

std::string resolved(const std::map<std::string, std::string>& types, const std::string& asked,
                     const std::string& type) {
  const auto named = types.find(without_slash(asked));
  if (named != types.end() && named->second == type) return named->first;
  const auto is_it = [&](const auto& topic) { return topic.second == type && !is_output(topic.first); };
  const auto only = std::find_if(types.begin(), types.end(), is_it);
  const bool several = std::count_if(types.begin(), types.end(), is_it) != 1;
  return several ? without_slash(asked) : only->first;
}

}  // namespace multipath_localization
