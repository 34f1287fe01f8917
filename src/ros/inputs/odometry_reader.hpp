#pragma once

#include <nav_msgs/Odometry.h>

#include <optional>
#include <string>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/twist_sample.hpp"
#include "ros/inputs/pose_agreement.hpp"

namespace multipath_localization {

/// How odometry is read.
struct OdometryParameters {
  bool lateral = true;
  double max_speed = 50.0;
  double max_yaw_rate = 20.0;
  double max_gap = 5.0;
  double time_jump_threshold = 1.0;

  void fields(ParameterVisitor& field);
};

/// One message of odometry as motion, or the reason why it is refused.
struct CheckedOdometry {
  Reason reason = Reason::kAccepted;
  bool restarted = false;       ///< time has jumped, what was known before counts no more; refused or not
  OdometryIncrement increment;  ///< counts only when accepted, as does the pose
  Pose2 base_in_odom;
};

/// Turns nav_msgs/Odometry into increments of the motion since the message before: the difference of the
/// poses where that is what the twist says over the last seconds (PoseAgreement) or the twist is all zero,
/// else the mean of the two twists, and in intervals of uneven length, as in bursts, the later twist. The
/// speed is negative in reverse either way, and motion sideways is read unless `lateral` is false.
///
/// | in the message                                          | what happens                       |
/// |---------------------------------------------------------|------------------------------------|
/// | first message                                           | accepted, stands for one millisecond |
/// | frame is the map's (our own output fed back)            | refused: invalid frame             |
/// | stamp zero                                              | refused: zero stamp                |
/// | stamp repeated or going back                            | refused: old stamp                 |
/// | stamp more than `max_gap` ahead, or after the year 2100 | refused: future stamp              |
/// | second message in a row that went back by more than     | accepted, `restarted`              |
/// | `time_jump_threshold` or ahead by more than `max_gap`   |                                    |
/// | pose, or twist in x, y or yaw, NaN or infinite          | refused: not finite                |
/// | position over 1e7 m                                     | refused: invalid position          |
/// | quaternion not of length 1 (nor all zero), or all zero  | refused: invalid orientation       |
/// | while only the position moves                           |                                    |
/// | speed or yaw rate beyond the limits                     | refused: too fast                  |
///
/// Covariances of odometry are not looked at. What was refused is bridged by the next message's motion.
class OdometryReader {
 public:
  OdometryReader(const OdometryParameters& parameters, std::string map_frame);

  CheckedOdometry read(const nav_msgs::Odometry& message);

  /// Forgets the messages before; the next one is a first one.
  void clear();

 private:
  struct Seen {
    TwistSample twist;
    Pose2 base_in_odom;
    bool oriented;  ///< the pose tells a heading

    [[nodiscard]] double stamp() const { return twist.stamp; }
  };

  [[nodiscard]] Seen seen(const nav_msgs::Odometry& message) const;
  /// Moves by a pose without orientation alone.
  [[nodiscard]] bool tells_no_turn(const nav_msgs::Odometry& message, const Seen& now) const;

  [[nodiscard]] Reason check_content(const nav_msgs::Odometry& message) const;
  Reason check_time(double stamp, bool& restarted);
  OdometryIncrement motion(const nav_msgs::Odometry& message, const Seen& now);

  OdometryParameters parameters_;
  std::string map_frame_;
  std::optional<Seen> last_pose_;  ///< the last message with a usable pose, refused or not
  std::optional<Seen> last_;       ///< the last one accepted, where the last increment ends
  std::optional<double> suspect_;  ///< stamp of the message before, refused for a jump
  PoseAgreement agreement_;
};

}  // namespace multipath_localization
