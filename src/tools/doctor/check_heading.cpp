#include <algorithm>
#include <cmath>

#include "evaluation/metrics.hpp"
#include "multipath_localization/core/angle.hpp"
#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/heading_conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {

namespace {

constexpr double kChord = 5.0;          // of fixes and odometry, over which their directions are known [m]
constexpr double kLongestChord = 15.0;  // in which it may be driven, so that odometry is right [s]
constexpr std::size_t kEnough = 5;      // chords that tell
constexpr double kAlike = 0.35;         // headings differ by less: 20 degrees [rad]
constexpr double kSteady = 0.8;         // length of the mean direction of differences that are one
constexpr double kSameTime = 1.0;       // a heading tells of a moment this near [s]

/// How far headings are off, as directions: told less where the robot pointed, and with the other sign.
struct Differences {
  Eigen::Vector2d off = Eigen::Vector2d::Zero();
  Eigen::Vector2d off_mirrored = Eigen::Vector2d::Zero();
  double count = 0.0;
};

std::vector<Heading> usable(const Observations& seen) {
  AntennaFrames frames(seen.frames);
  for (const Broadcast& broadcast : seen.transforms) frames.add(broadcast.transform, broadcast.is_static);
  std::vector<Heading> all;
  for (const auto& [message, time] : seen.headings) {
    const auto turned =
        message.header.frame_id.empty() ? std::nullopt : frames.rotation_in_base(message.header.frame_id);
    const CheckedHeading checked = to_heading(message, {}, turned.value_or(Eigen::Quaterniond::Identity()));
    if (checked.reason == Reason::kAccepted) all.push_back(checked.heading);
  }
  std::sort(all.begin(), all.end(), [](const Heading& a, const Heading& b) { return a.stamp < b.stamp; });
  return all;
}

Differences differences(const std::vector<Heading>& headings, const Motion& motion) {
  Differences sum;
  for (const Chord& chord : chords(motion.fixes, motion.track, kChord)) {
    const auto told =
        std::lower_bound(headings.begin(), headings.end(), chord.end,
                         [](const Heading& heading, double stamp) { return heading.stamp < stamp; });
    if (told == headings.end() || told->stamp > chord.end + kSameTime) continue;
    const std::optional<Pose2> then = motion.track.pose(told->stamp);
    if (!then || chord.end - chord.start > kLongestChord) continue;
    const double odom_in_map = std::atan2(chord.by_fixes.y(), chord.by_fixes.x()) -
                               std::atan2(chord.by_odometry.y(), chord.by_odometry.x());
    const double yaw = odom_in_map + then->yaw;
    sum.off += Eigen::Vector2d(std::cos(told->yaw - yaw), std::sin(told->yaw - yaw));
    sum.off_mirrored += Eigen::Vector2d(std::cos(told->yaw + yaw), std::sin(told->yaw + yaw));
    sum.count += 1.0;
  }
  return sum;
}

}  // namespace

Findings check_heading(const Observations& seen) {
  if (seen.headings.empty()) return {};
  const std::vector<Heading> headings = usable(seen);
  const std::string name = "heading: ";
  if (2 * headings.size() < seen.headings.size()) {
    return {fix(name + std::to_string(seen.headings.size() - headings.size()) + " of " +
                    std::to_string(seen.headings.size()) + " messages cannot be used",
                "in its driver: stamp, an orientation of length 1, and its covariance")};
  }
  const Differences sum = differences(headings, motion_of(seen));
  if (sum.count < kEnough)
    return {untold(name + "too little driving with fixes and odometry to tell whether it is right")};
  if (sum.off.norm() < kSteady * sum.count) {
    const bool mirrored = sum.off_mirrored.norm() >= kSteady * sum.count;
    return {fix(name + (mirrored ? "it turns the other way round than the robot"
                                 : "it does not go with where the robot points"),
                "in its driver: ENU, counter-clockwise from east, not a compass's clockwise from north; "
                "iron and motors away from a compass")};
  }
  const double off = std::atan2(sum.off.y(), sum.off.x());
  const std::string what = name + text("%.0f degrees off where the robot points", off * 180.0 / kPi);
  if (std::abs(off) > kAlike) {
    return {fix(what,
                "the static transform base_link -> its frame is to turn it as it is mounted; antennas may be "
                "taken for each other (180 degrees) or stand across (90 degrees)")};
  }
  return {pass(what)};
}

}  // namespace multipath_localization
