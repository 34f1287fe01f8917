#pragma once

#include <nav_msgs/Odometry.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <string>

#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Holds the poses that come back against the odometry that was sent: each answered once, at its own stamp,
/// finite and with a covariance that is one. Keeps account of errors. One thread sends, another one answers.
class PoseAudit {
 public:
  /// Odometry of that stamp is about to leave; the base is truly there.
  void sent(const ros::Time& stamp, const Pose2& truth);
  /// A pose has come back.
  void answered(const nav_msgs::Odometry& message);
  /// Waits until no more than `most` are without an answer, or `timeout` has passed [s], then gives up those
  /// that are. Having given up it waits but a moment until there is an answer again: a node without a fix as
  /// yet is silent.
  void wait_for(std::size_t most, double timeout);

  struct Figures {
    std::size_t answered = 0;
    std::size_t unanswered = 0;   ///< within the timeout
    double square_sum = 0.0;      ///< of errors of position [m^2]
    double largest = 0.0;         ///< error of position [m]
    double longest_beyond = 0.0;  ///< time on end outside 3 sigma [s]
    std::size_t faulty = 0;       ///< not finite, or without a proper covariance
    std::string first_fault;
  };
  /// Since the last call.
  Figures take_figures();

 private:
  void compare(const nav_msgs::Odometry& message, const Pose2& truth);
  void fault(const std::string& what, const ros::Time& stamp);

  std::mutex mutex_;
  std::condition_variable answered_;
  std::map<ros::Time, Pose2> open_;
  std::map<ros::Time, Pose2> given_up_;  ///< of late, an answer may come yet
  bool silent_ = false;
  Figures figures_;
  ros::Time inside_;  ///< the last pose within 3 sigma
};

}  // namespace multipath_localization
