#include <cmath>
#include <map>

#include "multipath_localization/localization/gyro_turn.hpp"
#include "multipath_localization/localization/standstill.hpp"
#include "ros/inputs/antenna_frames.hpp"
#include "ros/messages/imu_conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {

namespace {

constexpr double kSlowest = 20.0;       // by less turns are cut off [Hz]
constexpr double kEnoughTurning = 1.0;  // of odometry that tells whether the gyro turns with it [rad]
constexpr double kCounts = 0.05;        // share of the drive, below which it is a moment

/// What the yaw rates came to beside the odometry.
struct GyroRun {
  std::map<GyroStanding, double> time;  ///< with each standing [s]
  std::map<Reason, std::size_t> refused;
  std::string unknown_frame;
  double duration = 0.0;     ///< [s]
  double wheels_turn = 0.0;  ///< whichever way [rad]
  double frequency = 0.0;    ///< [Hz]

  [[nodiscard]] double share(GyroStanding standing) const {
    const auto found = time.find(standing);
    return found == time.end() ? 0.0 : found->second / duration;
  }
};

GyroRun run_gyro(const Observations& seen) {
  GyroRun run;
  AntennaFrames frames(seen.frames);
  for (const Broadcast& broadcast : seen.transforms) frames.add(broadcast.transform, broadcast.is_static);
  ImuReader reader([&](const std::string& frame) { return frames.rotation_in_base(frame); });
  GyroTurn gyro;
  Standstill standstill;
  auto next = seen.imus.begin();
  for (const OdometryIncrement& increment : motion_of(seen).increments) {
    for (; next != seen.imus.end() && next->message.header.stamp.toSec() <= increment.stamp; ++next) {
      const CheckedYawRate read = reader.read(next->message);
      if (reader.frame_is_news()) run.unknown_frame = next->message.header.frame_id;
      if (read.reason == Reason::kAccepted) {
        gyro.add(read.yaw_rate);
      } else {
        ++run.refused[read.reason];
      }
    }
    const OdometryIncrement settled = standstill.settled(increment);
    gyro.with_turn(settled, standstill.at_rest());
    run.time[gyro.standing()] += increment.duration;
    run.duration += increment.duration;
    run.wheels_turn += std::abs(increment.yaw_rate) * increment.duration;
  }
  run.frequency = gyro.frequency();
  return run;
}

Finding standing_of(const GyroRun& run) {
  if (run.share(GyroStanding::kReversed) > kCounts) {
    return fix(
        "imu: it turns the other way round than odometry",
        "the static transform base_link -> the IMU's frame is to turn its z axis upwards, as of one that "
        "is mounted upside down or counts in NED");
  }
  if (run.share(GyroStanding::kTooLarge) > kCounts) {
    return fix("imu: it turns several times as far as odometry",
               "in the IMU's driver: angular_velocity in rad/s, not in degrees");
  }
  if (run.share(GyroStanding::kFrozen) > kCounts) {
    return fix("imu: it says the same to the bit while the robot turns", "restart the IMU or its driver");
  }
  if (run.share(GyroStanding::kSilent) + run.share(GyroStanding::kAbsent) > 0.5) {
    return fix("imu: its messages are not of the time of odometry, or have long gaps",
               "stamp both by one clock; in the IMU's driver: 50 Hz or more");
  }
  const std::string what = text("imu: %.0f Hz, used for turns", run.frequency);
  if (run.frequency < kSlowest)
    return fix(what, text("set the IMU driver's rate to %g Hz or more", kSlowest));
  if (run.wheels_turn < kEnoughTurning)
    return untold(what + "; too few turns to tell whether they are right; drive a figure of eight");
  return pass(what + ", which are those of odometry");
}

}  // namespace

Findings check_gyro(const Observations& seen) {
  if (seen.imus.empty()) return {};
  const GyroRun run = run_gyro(seen);
  if (run.duration <= 0.0) return {untold("imu: without odometry nothing tells whether its turns are right")};
  Findings findings;
  if (!run.unknown_frame.empty()) {
    findings.push_back(fix("imu: no transform from " + seen.frames.base_link_frame + " to " +
                               run.unknown_frame + ": it is taken to be level, with z upwards",
                           "rosrun tf2_ros static_transform_publisher X Y Z YAW PITCH ROLL " +
                               seen.frames.base_link_frame + " " + run.unknown_frame));
  }
  for (const auto& [reason, times] : run.refused) {
    const std::string what = "imu: " + std::to_string(times) + " messages ";
    if (reason == Reason::kUnused) {
      findings.push_back(fix(what + "declare that it has no gyro: angular_velocity_covariance[0] is -1",
                             "in the IMU's driver: fill in angular_velocity and its covariance"));
      if (2 * times > seen.imus.size()) return findings;
    } else {
      findings.push_back(fix(what + "refused: " + std::string(to_string(reason)),
                             "in the IMU's driver: see what it publishes"));
    }
  }
  findings.push_back(standing_of(run));
  return findings;
}

}  // namespace multipath_localization
