#include "multipath_localization/localization/tilt_record.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kClockBack = 1.0;  // samples do not overtake each other by so much [s]
constexpr double kMemory = 5.0;     // as late as fixes may come [s]
constexpr double kHolds = 1.0;      // samples may come late by so much [s]
constexpr double kFades = 3.0;      // then, so that a lever arm does not jump [s]
constexpr double kAlike = 0.87;     // cosine of 30 degrees: more is no error of an orientation
constexpr double kSteepest = 0.71;  // cosine of 45 degrees

bool finite(const std::optional<Eigen::Vector3d>& vector) { return !vector || vector->allFinite(); }

bool finite(const InertialSample& sample) {
  return std::isfinite(sample.stamp) && finite(sample.up) && finite(sample.acceleration) &&
         finite(sample.rate);
}

}  // namespace

const char* to_string(TiltStanding standing) {
  switch (standing) {
    case TiltStanding::kAbsent: return "tells no roll and pitch as yet";
    case TiltStanding::kUsed: return "roll and pitch used";
    case TiltStanding::kSilent: return "silent or frozen: the ground is taken to be level";
    case TiltStanding::kImplausible:
      return "leans by over 45 degrees, and roll and pitch are not used: does tf have its mounting?";
  }
  return "";
}

bool TiltRecord::repeats(const InertialSample& sample) const {
  const bool noisy = sample.acceleration || sample.rate;
  return noisy && last_ && sample.up == last_->up && sample.acceleration == last_->acceleration &&
         sample.rate == last_->rate;
}

std::optional<Eigen::Vector3d> TiltRecord::up(const InertialSample& sample) const {
  const std::optional<Eigen::Vector3d> by_gravity = gravity_.up();
  if (!sample.up || (by_gravity && by_gravity->dot(*sample.up) < kAlike)) return by_gravity;
  return sample.up;
}

void TiltRecord::add(const InertialSample& sample) {
  if (!finite(sample)) return;
  if (last_ && sample.stamp < last_->stamp - kClockBack) *this = TiltRecord();
  if (last_ && sample.stamp <= last_->stamp) return;
  if (repeats(sample)) {
    last_->stamp = sample.stamp;
    return;
  }
  last_ = sample;
  gravity_.add(sample);
  const std::optional<Eigen::Vector3d> upwards = up(sample);
  if (!upwards) return;
  implausible_ = !(upwards->z() >= kSteepest);
  if (implausible_) return;
  told_.push_back({sample.stamp, tilt_of(*upwards)});
  while (told_.front().stamp < sample.stamp - kMemory) told_.pop_front();
}

Tilt TiltRecord::at(double stamp) const {
  const auto after = std::upper_bound(told_.begin(), told_.end(), stamp,
                                      [](double t, const Told& told) { return t < told.stamp; });
  if (told_.empty()) return {};
  const Told& near = after == told_.begin() ? *after : *(after - 1);
  const double share = std::clamp(1.0 - (std::abs(stamp - near.stamp) - kHolds) / kFades, 0.0, 1.0);
  return {share * near.tilt.roll, share * near.tilt.pitch};
}

TiltStanding TiltRecord::standing(double now) const {
  if (implausible_) return TiltStanding::kImplausible;
  if (told_.empty()) return TiltStanding::kAbsent;
  return now - told_.back().stamp > kHolds ? TiltStanding::kSilent : TiltStanding::kUsed;
}

}  // namespace multipath_localization
