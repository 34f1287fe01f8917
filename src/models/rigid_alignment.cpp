#include "multipath_localization/models/rigid_alignment.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr std::size_t kMinPairs = 4;
constexpr double kMinCoverage = 0.8;   ///< of the length, before it says anything
constexpr double kMaxVariance = 0.15;  ///< [rad^2]
constexpr double kMinSpreadToResidual = 2.0;

}  // namespace

void RigidAlignment::clear() {
  pairs_.clear();
  base_in_odom_ = Pose2{};
  distance_ = 0.0;
}

void RigidAlignment::add(const OdometryIncrement& increment) {
  base_in_odom_ = base_in_odom_ * displacement(increment);
  distance_ += ground_speed(increment) * increment.duration;
}

void RigidAlignment::add(const Eigen::Vector2d& base_by_fix) {
  pairs_.push_back({base_in_odom_.position(), base_by_fix, distance_});
  while (pairs_.size() > 2 && distance_ - pairs_.front().distance > length_) pairs_.pop_front();
}

std::optional<AlignedHeading> RigidAlignment::heading() const {
  if (pairs_.size() < kMinPairs) return std::nullopt;
  if (pairs_.back().distance - pairs_.front().distance < kMinCoverage * length_) return std::nullopt;

  const auto count = static_cast<double>(pairs_.size());
  Eigen::Vector2d odom_mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d map_mean = Eigen::Vector2d::Zero();
  for (const Pair& pair : pairs_) {
    odom_mean += pair.base_in_odom / count;
    map_mean += pair.base_in_map / count;
  }
  double dot = 0.0;
  double cross = 0.0;
  double odom_spread = 0.0;
  double map_spread = 0.0;
  for (const Pair& pair : pairs_) {
    const Eigen::Vector2d p = pair.base_in_odom - odom_mean;
    const Eigen::Vector2d q = pair.base_in_map - map_mean;
    dot += p.dot(q);
    cross += p.x() * q.y() - p.y() * q.x();
    odom_spread += p.squaredNorm();
    map_spread += q.squaredNorm();
  }
  if (odom_spread <= 0.0) return std::nullopt;
  const double residual =
      std::max(0.0, odom_spread + map_spread - 2.0 * std::hypot(dot, cross)) / (2.0 * count);
  const double variance = 2.0 * std::max(residual, fix_sigma_ * fix_sigma_) / odom_spread + floor_;
  if (odom_spread / count <= kMinSpreadToResidual * residual || variance >= kMaxVariance) return std::nullopt;
  return AlignedHeading{wrap_angle(std::atan2(cross, dot) + base_in_odom_.yaw), variance};
}

}  // namespace multipath_localization
