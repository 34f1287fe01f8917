#include "estimators/multipath/heading_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kAgree = 0.3;            // headings of a second that agree lie this near each other [rad]
constexpr double kLongestBlock = 1.0;     // where none is weighed for longer, as before the first fix [s]
constexpr double kLargestVariance = 1e3;  // [rad^2]

/// Of one heading against another, both of now [rad].
double difference(const Heading& heading, const Heading& other) {
  return angle_difference(heading.yaw + heading.turn, other.yaw + other.turn);
}

/// How many of the headings lie near one.
long agreeing(const std::vector<Heading>& headings, const Heading& one) {
  return std::count_if(headings.begin(), headings.end(),
                       [&](const Heading& heading) { return std::abs(difference(heading, one)) < kAgree; });
}

}  // namespace

void HeadingBlock::move(const OdometryIncrement& u) {
  const double turn = u.yaw_rate * u.duration;
  for (Heading& heading : headings_) heading.turn += turn;
  turned_ += std::abs(turn);
  now_ = u.stamp;
}

std::optional<Reason> HeadingBlock::add(const Heading& heading) {
  if (!std::isfinite(heading.stamp) || !std::isfinite(heading.yaw) || !std::isfinite(heading.variance)) {
    return Reason::kNotFinite;
  }
  if (heading.variance < 0.0 || heading.variance > kLargestVariance) return Reason::kInvalidCovariance;
  if (std::exchange(last_, heading.yaw) == heading.yaw) return Reason::kRepeated;
  headings_.push_back(heading);
  const auto old = [&](const Heading& h) { return h.stamp < heading.stamp - kLongestBlock; };
  headings_.erase(std::remove_if(headings_.begin(), headings_.end(), old), headings_.end());
  return std::nullopt;
}

HeadingSighting HeadingBlock::take() {
  const auto middle = std::max_element(
      headings_.begin(), headings_.end(),
      [&](const Heading& a, const Heading& b) { return agreeing(headings_, a) < agreeing(headings_, b); });
  HeadingSighting sighting;
  sighting.count = 0.0;
  double off = 0.0;
  for (const Heading& heading : headings_) {
    const double apart = difference(heading, *middle);
    if (std::abs(apart) >= kAgree) continue;
    off += apart;
    sighting.variance += heading.variance;
    sighting.count += 1.0;
  }
  sighting.yaw = wrap_angle(middle->yaw + middle->turn + off / sighting.count);
  sighting.variance /= sighting.count;
  sighting.duration = std::max(1e-3, age());
  sighting.turn_rate = turned_ / sighting.duration;
  headings_.clear();
  taken_ = now_;
  turned_ = 0.0;
  return sighting;
}

}  // namespace multipath_localization::multipath
