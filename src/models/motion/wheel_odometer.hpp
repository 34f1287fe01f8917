#pragma once

#include <optional>
#include <vector>

#include "models/motion/joint_turn.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/twist_sample.hpp"

namespace multipath_localization {

/// Measures of a base on wheels [m].
struct WheelGeometry {
  double wheel_radius = 0.0;
  double track = 0.0;      ///< between left and right wheels
  double wheelbase = 0.0;  ///< between the axle that is not steered and the one that is
  double axle = 0.0;  ///< x in the base of the axle that is not steered, or of the middle of skidding wheels
};

/// What no robot of this kind does.
struct WheelLimits {
  double max_speed = 10.0;     ///< [m/s]
  double max_yaw_rate = 10.0;  ///< [rad/s]
  double max_gap = 5.0;        ///< between two readings, over which the motion is still told [s]
};

/// Speed and steering angle as a driver tells them.
struct DriveReading {
  double speed = 0.0;           ///< of the axle that is not steered, negative in reverse [m/s]
  double steering_angle = 0.0;  ///< of a wheel in the middle of the other one, to the left [rad]
};

/// Readings of the wheels of one instant. With steering joints the others need not be of two sides.
struct WheelReadings {
  std::vector<JointReading> left;
  std::vector<JointReading> right;
  std::vector<JointReading> steering;
};

/// What became of a reading: its motion, unless it is a first one or the reason is another than `accepted`.
struct WheelMotion {
  Reason reason = Reason::kAccepted;
  std::optional<OdometryIncrement> motion;
};

/// Odometry of a base that tells nothing but what its wheels do: of left and right wheels as a differential
/// drive, of steered ones as the bicycle whose front wheel stands as the mean of theirs.
///
/// | reading                                                    | what happens |
/// |------------------------------------------------------------|---------------------------------------------|
/// | first, or more than `max_gap` after or 1 s before the last | accepted, no motion | | some joint neither
/// with position nor velocity, NaN         | refused: not finite                         | | stamp zero |
/// refused: zero stamp                         | | stamp repeated or going back | refused: old stamp | |
/// speed or yaw rate beyond the limits, as of an encoder that | refused: too fast; joints go on from there  |
/// | was set back, or steering of a quarter turn or more        | |
class WheelOdometer {
 public:
  WheelOdometer(const WheelGeometry& geometry, const WheelLimits& limits)
      : geometry_(geometry), limits_(limits) {}

  /// At a stamp [s].
  WheelMotion take(double stamp, const DriveReading& reading);
  WheelMotion take(double stamp, const WheelReadings& readings);

 private:
  /// Why a reading of that stamp does not count, if it does not; begins afresh where time has leapt.
  Reason check_time(double stamp);
  /// Mean turns of the joints since the last readings [rad]; nothing where one of them does not tell.
  static std::optional<double> turn_of(std::vector<JointTurn>& turns,
                                       const std::vector<JointReading>& readings, double duration);
  [[nodiscard]] TwistSample steered(double stamp, double speed, double angle) const;
  [[nodiscard]] TwistSample differential(double stamp, double left, double right) const;
  [[nodiscard]] bool possible(double speed, double yaw_rate) const;

  WheelGeometry geometry_;
  WheelLimits limits_;
  std::optional<double> stamp_;       ///< of the last reading [s]
  std::optional<TwistSample> drive_;  ///< the last one
  std::optional<double> angle_;       ///< the last one of the steering joints [rad]
  std::vector<JointTurn> left_, right_;
};

}  // namespace multipath_localization
