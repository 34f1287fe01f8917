#include "estimators/multipath/fix_block.hpp"

#include <algorithm>

namespace multipath_localization::multipath {

namespace {

constexpr double kReach = 3.0;        // median distances from the median, further are outliers
constexpr double kLeastReach = 1e-3;  // of a receiver that repeats itself to the millimetre [m]
constexpr std::size_t kFewestToTell = 3;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Which of the places lie about their median.
std::vector<bool> agreeing(const std::vector<Eigen::Vector2d>& places) {
  if (places.size() < kFewestToTell) return std::vector<bool>(places.size(), true);
  std::vector<double> east;
  std::vector<double> north;
  east.reserve(places.size());
  north.reserve(places.size());
  for (const Eigen::Vector2d& place : places) {
    east.push_back(place.x());
    north.push_back(place.y());
  }
  const Eigen::Vector2d middle(median(east), median(north));
  std::vector<double> distances;
  distances.reserve(places.size());
  for (const Eigen::Vector2d& place : places) distances.push_back((place - middle).norm());
  const double reach = kReach * median(distances) + kLeastReach;
  std::vector<bool> agree;
  agree.reserve(places.size());
  for (const double distance : distances) agree.push_back(distance <= reach);
  return agree;
}

}  // namespace

void FixBlock::move(const Pose2& step) {
  const Pose2 then_in_now = inverse(step);
  for (GnssFix& fix : fixes_) fix.antenna_in_base = then_in_now * fix.antenna_in_base;
}

GnssFix FixBlock::take(double yaw) {
  std::vector<Eigen::Vector2d> places;
  for (const GnssFix& fix : fixes_) places.emplace_back(fix.position - rotation(yaw) * fix.antenna_in_base);
  const std::vector<bool> agree = agreeing(places);
  const auto count = static_cast<double>(std::count(agree.begin(), agree.end(), true));
  GnssFix mean = fixes_.back();
  mean.position.setZero();
  mean.antenna_in_base.setZero();
  mean.covariance.setZero();
  for (std::size_t i = 0; i < fixes_.size(); ++i) {
    if (!agree[i]) continue;
    mean.position += fixes_[i].position / count;
    mean.antenna_in_base += fixes_[i].antenna_in_base / count;
    mean.covariance += fixes_[i].covariance / count;
  }
  fixes_.clear();
  return mean;
}

}  // namespace multipath_localization::multipath
