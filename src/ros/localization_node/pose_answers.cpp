#include "ros/localization_node/pose_answers.hpp"

#include <cmath>

#include "ros/localization_node/estimate_messages.hpp"

namespace multipath_localization {

namespace {

constexpr double kAnsweredLate = 0.5;  ///< [s]

}  // namespace

PoseAnswers::PoseAnswers(const LocalizationParameters& parameters, LocalizationOutputs& outputs)
    : outputs_(outputs),
      map_to_odom_(parameters.frames, parameters.outputs),
      persistence_(parameters.pose_file, parameters.pose_file_max_age) {}

std::optional<unsigned> PoseAnswers::publish(const Localizer& localizer, const Datum& datum) {
  if (odometry_.answered()) return 0;
  const PoseEstimate estimate = localizer.estimate();
  if (estimate.valid && !finite(estimate)) return std::nullopt;
  if (!estimate.valid || !datum.map()) {
    odometry_.give_up_older_than(kAnsweredLate);
    outputs_.publish_changed_state(localizer, odometry_.stamp());
    return 0;
  }
  const Pose2 base_in_odom = odometry_.last()->base_in_odom;
  const Pose2 odom_in_map = estimate.pose * inverse(base_in_odom);
  unsigned poses = 0;
  for (const ReadOdometry& odometry : odometry_.take_unanswered()) {
    PoseEstimate then = estimate;
    then.pose = odom_in_map * odometry.base_in_odom;
    outputs_.publish(localizer, then, odometry, *datum.map());
    ++poses;
  }
  if (!estimate.aligned) map_to_odom_.jump();
  save(estimate, datum);
  map_to_odom_.send(odom_in_map, base_in_odom, odometry_.stamp(), ros::Time::now());
  return poses;
}

OdometryState PoseAnswers::state() const {
  const ReadOdometry& last = *odometry_.last();
  const geometry_msgs::Twist& twist = last.message.twist.twist;
  return {odometry_.stamp().toSec(), last.base_in_odom, std::hypot(twist.linear.x, twist.linear.y),
          twist.angular.z};
}

void PoseAnswers::save(const PoseEstimate& estimate, const Datum& datum) {
  if (!persistence_.due(odometry_.stamp().toSec()) || !datum.settled()) return;
  persistence_.save(
      {datum.map()->datum(), estimate.pose, covariance_overall(estimate), state(), estimate.aligned});
}

}  // namespace multipath_localization
