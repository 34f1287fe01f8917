#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/motion_command.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

/// A while in which an omnidirectional robot moves sideways, beside what it is commanded.
struct StrafeParameters {
  double start = 0.0;
  double duration = 10.0;
  double speed = 0.5;

  void fields(ParameterVisitor& field);
};

/// How the robot moves, as `drive` says.
enum class DriveKind { kSteering, kDifferential, kOmnidirectional };

struct RobotParameters {
  DriveKind drive = DriveKind::kSteering;
  double wheelbase = 1.0;
  double start_x = 0.0;
  double start_y = 0.0;
  double start_yaw = 0.0;
  double max_speed = 12.0;
  double max_acceleration = 2.0;
  double max_steering_angle = 0.6;
  double max_steering_rate = 1.5;
  std::vector<double> alpha = {3.0, 0.3, 3.0, 0.3, 3.0, 0.3};
  double noise_scale = 0.0;
  double wheel_separation = 0.35;
  double wheel_noise = 0.0;
  std::vector<StrafeParameters> strafes;

  void fields(ParameterVisitor& field);
};

/// A robot whose true motion strays from its command: one with front-wheel steering, Eqs. (3)-(8) of [NIS],
/// or one with two driven wheels, section 4 of [KAM], which turns as that with the same command would. The
/// reference point is the centre of the rear or driven axle, whose wheels do not slip sideways. An
/// omnidirectional one drives as the latter and strafes beside.
class Robot {
 public:
  /// Throws ParameterError unless there are six noise constants.
  Robot(const RobotParameters& parameters, std::uint64_t seed);

  /// Drives for `duration` [s] under a command, cut to the robot's limits. A command that is not finite
  /// counts as a stop.
  void step(const MotionCommand& command, double duration);

  [[nodiscard]] const Pose2& pose() const { return pose_; }    ///< base in map
  [[nodiscard]] double speed() const { return speed_; }        ///< true, over the last step [m/s]
  [[nodiscard]] double yaw_rate() const { return yaw_rate_; }  ///< true, over the last step [rad/s]
  /// True, to the left, over the last step [m/s].
  [[nodiscard]] double lateral_speed() const { return lateral_speed_; }
  /// What it strafes by, before noise [m/s].
  [[nodiscard]] double strafing() const { return strafing_; }
  /// The command within the limits of speed, acceleration and steering, before noise.
  [[nodiscard]] const MotionCommand& command() const { return command_; }
  [[nodiscard]] const RobotParameters& parameters() const { return parameters_; }

 private:
  void limit(const MotionCommand& command, double duration);
  void steer(RandomStream& random, double duration);
  void roll(RandomStream& random, double duration);
  void strafe(RandomStream& random, double duration);

  RobotParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  Pose2 pose_;
  MotionCommand command_;
  double speed_ = 0.0;
  double yaw_rate_ = 0.0;
  double strafing_ = 0.0;
  double lateral_speed_ = 0.0;
  double time_ = 0.0;
};

}  // namespace multipath_localization
