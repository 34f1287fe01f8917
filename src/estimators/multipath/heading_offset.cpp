#include "estimators/multipath/heading_offset.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kDisbelieved = 0.1;  // probability of headings that are off by more than noise
constexpr double kKnownYaw = 0.01;    // variance of a yaw that tells by what [rad^2]
constexpr double kSpread = 0.15;      // of what is always the same, give or take noise [rad]
constexpr int kEnough = 20;           // sightings, of a second each,
constexpr int kMostMisses = 4;        // of which one in so many may be an outlier
constexpr double kTurns = 1.0;  // of the robot, in which headings of another sign or frozen ones differ [rad]

}  // namespace

std::optional<double> HeadingOffset::judge(const HeadingSighting& sighting, const Mixture& mixture) {
  if (mixture.heading > kDisbelieved || mixture.covariance(2, 2) > kKnownYaw) {
    *this = {};
    return std::nullopt;
  }
  const double yaw = mixture.mean(kYaw);
  const double difference = angle_difference(sighting.yaw, yaw);
  if (kMostMisses * misses_ >= count_) {
    *this = {};
    mean_ = difference;
    yaw_ = yaw;
  }
  turned_ += angle_difference(yaw, std::exchange(yaw_, yaw));
  const double off = angle_difference(difference, mean_);
  if (std::abs(off) > kSpread) {
    ++misses_;
    return std::nullopt;
  }
  ++count_;
  mean_ = wrap_angle(mean_ + off / count_);
  leftmost_ = std::max(leftmost_, turned_);
  rightmost_ = std::min(rightmost_, turned_);
  if (count_ < kEnough || leftmost_ - rightmost_ < kTurns) return std::nullopt;
  const double offset = mean_;
  *this = {};
  return offset;
}

}  // namespace multipath_localization::multipath
