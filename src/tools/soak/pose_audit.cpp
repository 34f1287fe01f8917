#include "tools/soak/pose_audit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

constexpr double kPatienceInSilence = 0.005;  ///< [s]

using Covariance = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

Eigen::Matrix3d of_pose(const Covariance& covariance) {
  Eigen::Matrix3d block;
  block << covariance.topLeftCorner<2, 2>(), covariance.block<2, 1>(0, 5), covariance.block<1, 2>(5, 0),
      covariance(5, 5);
  return block;
}

bool finite(const nav_msgs::Odometry& message) {
  const auto& pose = message.pose.pose;
  return std::isfinite(pose.position.x + pose.position.y + pose.position.z + pose.orientation.x +
                       pose.orientation.y + pose.orientation.z + pose.orientation.w) &&
         Eigen::Map<const Covariance>(message.pose.covariance.data()).allFinite();
}

bool proper(const Covariance& covariance) {
  const Eigen::Matrix3d block = of_pose(covariance);
  return covariance == covariance.transpose() && Eigen::LLT<Eigen::Matrix3d>(block).info() == Eigen::Success;
}

}  // namespace

void PoseAudit::sent(const ros::Time& stamp, const Pose2& truth) {
  const std::lock_guard<std::mutex> lock(mutex_);
  open_[stamp] = truth;
}

void PoseAudit::answered(const nav_msgs::Odometry& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto question = open_.extract(message.header.stamp);
  if (!question) question = given_up_.extract(message.header.stamp);
  if (!question) return fault("an answer to nothing", message.header.stamp);
  ++figures_.answered;
  silent_ = false;
  compare(message, question.mapped());
  answered_.notify_one();
}

void PoseAudit::wait_for(std::size_t most, double timeout) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto few = [&] { return open_.size() <= most; };
  const std::chrono::duration<double> patience(silent_ ? kPatienceInSilence : timeout);
  if (answered_.wait_for(lock, patience, few)) return;
  silent_ = true;
  figures_.unanswered += open_.size();
  given_up_.merge(open_);
  open_.clear();
}

PoseAudit::Figures PoseAudit::take_figures() {
  const std::lock_guard<std::mutex> lock(mutex_);
  given_up_.clear();
  return std::exchange(figures_, {});
}

void PoseAudit::compare(const nav_msgs::Odometry& message, const Pose2& truth) {
  const ros::Time& stamp = message.header.stamp;
  if (!finite(message)) return fault("not finite", stamp);
  const Covariance covariance = Eigen::Map<const Covariance>(message.pose.covariance.data());
  if (!proper(covariance)) return fault("covariance not symmetric or not positive", stamp);
  const Eigen::Vector2d error(message.pose.pose.position.x - truth.x, message.pose.pose.position.y - truth.y);
  figures_.square_sum += error.squaredNorm();
  figures_.largest = std::max(figures_.largest, error.norm());
  const Eigen::Matrix2d position = covariance.topLeftCorner<2, 2>();
  if (error.dot(position.llt().solve(error)) <= 9.0 || stamp < inside_) inside_ = stamp;
  figures_.longest_beyond = std::max(figures_.longest_beyond, stamp.toSec() - inside_.toSec());
}

void PoseAudit::fault(const std::string& what, const ros::Time& stamp) {
  if (figures_.faulty++ == 0) figures_.first_fault = what + " at " + std::to_string(stamp.toSec());
}

}  // namespace multipath_localization
