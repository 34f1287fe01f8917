#include "multipath_localization/localization/gyro_turn.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kClockBack = 1.0;       // samples do not overtake each other by so much [s]
constexpr double kLeastReach = 0.1;      // messages of one instant come in whatever order [s]
constexpr double kMostReach = 0.3;       // what is read more seldom misses turns [s]
constexpr double kReachInIntervals = 2;  // one sample may be lost
constexpr double kMemory = 10.0;         // of samples before the odometry that they are for [s]
constexpr double kSmoothing = 0.05;      // share of the latest interval in their mean

constexpr double kFrozenTime = 0.5;    // no gyro says the same to the bit for so long while it turns [s]
constexpr double kFrozenTurn = 0.1;    // of the wheels meanwhile that tells: six degrees [rad]
constexpr double kTurnedByHand = 0.1;  // no bias is as large: the base turns though its wheels stand [rad/s]

constexpr double kPiece = 1.0;         // turns are compared by [s]
constexpr double kComparedFor = 60.0;  // of driving; after that a gyro may have been mended [s]
constexpr double kEnough = 0.02;       // wheels have turned by 8 degrees within a piece [rad^2]
constexpr double kAgainst = -0.7;      // correlation of a gyro that turns the other way round
constexpr double kTogether = 0.3;      // and of one that does not
constexpr double kTooFar = 4.0;        // times: skidding wheels turn further than the robot, not less far

}  // namespace

const char* to_string(GyroStanding standing) {
  switch (standing) {
    case GyroStanding::kAbsent: return "no yaw rate has come";
    case GyroStanding::kUsed: return "yaw rate is used";
    case GyroStanding::kSilent: return "silent or late: turns are the wheels'";
    case GyroStanding::kFrozen: return "frozen: turns are the wheels'";
    case GyroStanding::kReversed: return "turns the other way round than the wheels, and is not used";
    case GyroStanding::kTooLarge: return "turns several times as far as the wheels, and is not used";
  }
  return "";
}

void GyroTurn::add(const YawRate& sample) {
  if (!std::isfinite(sample.stamp) || !std::isfinite(sample.rate)) return;
  if (!samples_.empty() && sample.stamp < samples_.back().sample.stamp - kClockBack) *this = GyroTurn();
  if (samples_.empty()) {
    last_change_ = sample.stamp;
    samples_.push_back({sample, 0.0});
    return;
  }
  const Node last = samples_.back();
  const double step = sample.stamp - last.sample.stamp;
  if (step <= 0.0) return;
  interval_ += (interval_ == 0.0 ? 1.0 : kSmoothing) * (std::min(step, kClockBack) - interval_);
  if (sample.rate != last.sample.rate) {
    last_change_ = sample.stamp;
    missed_turn_ = 0.0;
    frozen_ = false;
  }
  samples_.push_back({sample, last.turn + 0.5 * step * (last.sample.rate + sample.rate)});
  while (samples_.front().sample.stamp < sample.stamp - kMemory) samples_.pop_front();
}

double GyroTurn::reach() const { return std::clamp(kReachInIntervals * interval_, kLeastReach, kMostReach); }

std::optional<double> GyroTurn::turn_until(double stamp) const {
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), stamp,
                                      [](const Node& node, double t) { return node.sample.stamp < t; });
  if (after == samples_.begin()) {
    if (samples_.empty() || after->sample.stamp - stamp > reach()) return std::nullopt;
    return after->turn - (after->sample.stamp - stamp) * after->sample.rate;
  }
  const Node& before = *(after - 1);
  const double since = stamp - before.sample.stamp;
  if (after == samples_.end()) {
    if (since > reach()) return std::nullopt;
    return before.turn + since * before.sample.rate;
  }
  const double step = after->sample.stamp - before.sample.stamp;
  if (step > reach()) return std::nullopt;
  const double slope = (after->sample.rate - before.sample.rate) / step;
  return before.turn + since * (before.sample.rate + 0.5 * slope * since);
}

std::optional<double> GyroTurn::turn_over(const OdometryIncrement& u) {
  const double start = u.stamp - u.duration;
  const bool goes_on = given_ && std::abs(start - given_until_) <= kLeastReach;
  // What was given before its last samples had come is made good now.
  const std::optional<double> from = goes_on ? given_ : turn_until(start);
  given_ = turn_until(u.stamp);
  given_until_ = u.stamp;
  while (samples_.size() > 1 && samples_[1].sample.stamp < u.stamp) samples_.pop_front();
  if (!from || !given_) return std::nullopt;
  return *given_ - *from;
}

OdometryIncrement GyroTurn::with_turn(const OdometryIncrement& wheels, bool at_rest) {
  const std::optional<double> turn = turn_over(wheels);
  covers_ = turn.has_value();
  if (!turn) return wheels;
  OdometryIncrement result = wheels;
  const double rate = *turn / wheels.duration;
  if (at_rest && std::abs(rate) < kTurnedByHand) {
    result.rate_at_rest = rate;
    result.turn_source = TurnSource::kGyro;
    return result;
  }
  const bool was_used = standing() == GyroStanding::kUsed;
  const double missed_before = missed_turn_;
  missed_turn_ += wheels.yaw_rate * wheels.duration - *turn;
  frozen_ = frozen_ || (equal_for() > kFrozenTime && std::abs(missed_turn_) > kFrozenTurn);
  if (frozen_ && was_used) result.yaw_rate += missed_before / wheels.duration;
  compare(wheels, *turn);
  if (standing() != GyroStanding::kUsed) return result;
  result.yaw_rate = rate;
  result.turn_source = TurnSource::kGyro;
  return result;
}

void GyroTurn::compare(const OdometryIncrement& wheels, double turn) {
  const double by_wheels = wheels.yaw_rate * wheels.duration;
  piece_time_ += wheels.duration;
  piece_gyro_ += turn;
  piece_wheels_ += by_wheels;
  if (piece_time_ < kPiece) return;
  const double keep = std::exp(-piece_time_ / kComparedFor);
  products_.gyro = keep * products_.gyro + square(piece_gyro_);
  products_.wheels = keep * products_.wheels + square(piece_wheels_);
  products_.both = keep * products_.both + piece_gyro_ * piece_wheels_;
  piece_time_ = piece_gyro_ = piece_wheels_ = 0.0;
  if (products_.wheels > kEnough) judge();
}

void GyroTurn::judge() {
  const double correlation = products_.both / std::sqrt(products_.gyro * products_.wheels + 1e-12);
  if (correlation < kAgainst) verdict_ = GyroStanding::kReversed;
  if (correlation < kTogether) return;
  const bool too_far = products_.both > kTooFar * products_.wheels;
  verdict_ = too_far ? GyroStanding::kTooLarge : GyroStanding::kUsed;
}

double GyroTurn::equal_for() const {
  return samples_.empty() ? 0.0 : samples_.back().sample.stamp - last_change_;
}

GyroStanding GyroTurn::standing() const {
  if (samples_.empty()) return GyroStanding::kAbsent;
  if (!covers_) return GyroStanding::kSilent;
  return frozen_ ? GyroStanding::kFrozen : verdict_;
}

}  // namespace multipath_localization
