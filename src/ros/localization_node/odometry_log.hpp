#pragma once

#include <nav_msgs/Odometry.h>

#include <deque>
#include <optional>
#include <utility>

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/tilt.hpp"

namespace multipath_localization {

/// Odometry that was accepted.
struct ReadOdometry {
  nav_msgs::Odometry message;  ///< its twist is the motion read from it
  Pose2 base_in_odom;
  Tilt tilt;  ///< of the base then
};

/// The last odometry, and that of the last moments which no pose has answered as yet.
class OdometryLog {
 public:
  /// Notes the last message; returns whether it is the first one ever.
  bool note(const ReadOdometry& odometry) {
    last_ = odometry;
    return !std::exchange(begun_, true);
  }
  /// The last one is to be answered by a pose.
  void await_answer() { unanswered_.push_back(*last_); }

  /// Nothing before the first, and after `forget_last`.
  [[nodiscard]] const std::optional<ReadOdometry>& last() const { return last_; }
  /// Of the last, zero where there is none.
  [[nodiscard]] ros::Time stamp() const { return last_ ? last_->message.header.stamp : ros::Time(); }
  [[nodiscard]] bool answered() const { return unanswered_.empty(); }

  /// Gives away those that await an answer, oldest first.
  std::deque<ReadOdometry> take_unanswered() { return std::exchange(unanswered_, {}); }
  /// No answer is awaited any more by those older than the last one by more than `age` [s].
  void give_up_older_than(double age);

  void forget_last() { last_.reset(); }

 private:
  std::optional<ReadOdometry> last_;
  std::deque<ReadOdometry> unanswered_;
  bool begun_ = false;
};

}  // namespace multipath_localization
