#include "estimators/multipath/velocity_block.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/covariance.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kHalfWindow =
    0.1;  // ticks of wheels and the receiver's own filter are smoother than that [s]
constexpr double kLeastWindow = 0.05;  // of odometry that has to be there [s]
constexpr double kNearStart = 5.0;     // within which a heading that is any is turned about the start [m]
constexpr double kStandstill = 0.05;   // of wheels that stand [m/s]
constexpr double kSlow = 0.3;     // of velocities of a robot that stands, rather than one that slides [m/s]
constexpr double kFastest = 1e3;  // of a velocity that is none [m/s]
constexpr double kLongestBlock = 1.0;  // where none is weighed for longer, as before the first fix [s]

bool stands(const VelocitySighting& sighting) {
  const bool wheels_stand = std::all_of(sighting.driven.begin(), sighting.driven.end(),
                                        [](const Eigen::Vector2d& v) { return v.norm() < kStandstill; });
  return wheels_stand && sighting.velocity.norm() < kSlow;
}

}  // namespace

void VelocityBlock::move(const OdometryIncrement& u) {
  if (last_) history_.add(u);  // robots without velocities pay nothing for it
  now_ = u.stamp;
  way_ += ground_speed(u) * u.duration;
  antenna_at_start_ = inverse(displacement(u)) * antenna_at_start_;
}

void VelocityBlock::start(const Eigen::Vector2d& antenna_in_base) {
  antenna_at_start_ = {antenna_in_base.x(), antenna_in_base.y(), 0.0};
  way_ = 0.0;
}

std::optional<Eigen::Vector2d> VelocityBlock::from_start() const {
  if (way_ >= kNearStart) return std::nullopt;
  return Eigen::Vector2d(-antenna_at_start_.position());
}

std::optional<Reason> VelocityBlock::add(const GnssVelocity& velocity) {
  const bool finite = std::isfinite(velocity.stamp) && velocity.velocity.allFinite() &&
                      velocity.covariance.allFinite() && velocity.antenna_in_base.allFinite();
  if (!finite) return Reason::kNotFinite;
  if (!positive_semi_definite(velocity.covariance)) return Reason::kInvalidCovariance;
  if (velocity.velocity.cwiseAbs().maxCoeff() > kFastest) return Reason::kTooFast;
  const bool repeated = last_ == velocity.velocity;
  last_ = velocity.velocity;
  if (repeated) return Reason::kRepeated;
  velocities_.push_back(velocity);
  const auto old = [&](const GnssVelocity& v) { return v.stamp < velocity.stamp - kLongestBlock; };
  velocities_.erase(std::remove_if(velocities_.begin(), velocities_.end(), old), velocities_.end());
  return std::nullopt;
}

std::optional<Eigen::Vector2d> VelocityBlock::driven(const GnssVelocity& velocity, double delay) const {
  const double until = std::min(now_, velocity.stamp - delay + kHalfWindow);
  const double from = velocity.stamp - delay - kHalfWindow;
  const std::optional<Pose2> last = history_.base_then_in_base_now(until);
  const std::optional<Pose2> first = history_.base_then_in_base_now(from);
  if (!last || !first || until - from < kLeastWindow) return std::nullopt;
  return Eigen::Vector2d((*last * velocity.antenna_in_base - *first * velocity.antenna_in_base) /
                         (until - from));
}

std::optional<VelocitySighting> VelocityBlock::take() {
  VelocitySighting sighting;
  sighting.duration = std::max(1e-3, age());
  sighting.driven.fill(Eigen::Vector2d::Zero());
  sighting.count = 0.0;
  for (const GnssVelocity& velocity : velocities_) {
    std::optional<Eigen::Vector2d> driven = this->driven(velocity, 0.0);
    if (!driven) continue;
    for (std::size_t k = 0; k < kDelays; ++k) {
      const auto earlier = this->driven(velocity, static_cast<double>(k) * kDelayStep);
      if (earlier) driven = earlier;
      sighting.driven[k] += *driven;
    }
    sighting.velocity += velocity.velocity;
    sighting.variance += mean_sigma(velocity.covariance) * mean_sigma(velocity.covariance);
    sighting.count += 1.0;
  }
  velocities_.clear();
  taken_ = now_;
  if (sighting.count < 1.0) return std::nullopt;
  sighting.velocity /= sighting.count;
  sighting.variance /= sighting.count;
  for (Eigen::Vector2d& driven : sighting.driven) driven /= sighting.count;
  const std::optional<Eigen::Vector2d> from = from_start();
  sighting.near_start = from.has_value();
  if (from) sighting.from_start = *from;
  if (stands(sighting)) return std::nullopt;
  return sighting;
}

}  // namespace multipath_localization::multipath
