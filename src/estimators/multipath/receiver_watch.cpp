#include "estimators/multipath/receiver_watch.hpp"

#include <algorithm>

#include "estimators/multipath/error_laws.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

/// Fixes within this time are one, just below a receiver's second [s].
constexpr double kBlock = 0.9;
/// A receiver that fixes its ambiguities declares less than this from one fix to the next,
constexpr double kFixed = 0.1;  // [m]
constexpr double kFloat = 0.3;  ///< and more than that before [m]
/// Sigma of what a receiver begins anew wrong by, at most: ambiguities, one reflection [m].
constexpr double kMostWrong = 5.0;

}  // namespace

bool ReceiverWatch::due(double now) const { return now - weighed_ >= kBlock; }

bool ReceiverWatch::overdue(double now) const { return !block_.empty() && now - added_ >= kBlock; }

double ReceiverWatch::doubt(double now) const { return still_wrong(now - reacquired_) * square(wrong_by_); }

bool ReceiverWatch::refixed(FixLevel level, double declared) const {
  if (level == FixLevel::kUntold || level_ == FixLevel::kUntold) {
    return declared < kFixed && declared_ > kFloat;
  }
  return level == FixLevel::kFixed && level_ != FixLevel::kFixed;
}

Sighting ReceiverWatch::take(double now, double yaw, double known) {
  Sighting sighting;
  fixes_in_block_ = static_cast<double>(block_.size());
  sighting.fix = block_.take(yaw);
  sighting.duration = std::max(kShortestTime, now - weighed_);
  const double declared = mean_sigma(sighting.fix.covariance);
  sighting.refixed = refixed(sighting.fix.level, declared);
  if (sighting.duration > kOutage || sighting.refixed) {
    reacquired_ = now;
    wrong_by_ = std::min(known, kMostWrong);
  }
  sighting.reacquired = now - reacquired_ < kSettling;
  declared_ = declared;
  level_ = sighting.fix.level;
  status_ = sighting.fix.status;
  weighed_ = now;
  return sighting;
}

}  // namespace multipath_localization::multipath
