#include "simulation/odometry_faults.hpp"

#include <algorithm>

#include "multipath_localization/core/random.hpp"
#include "simulation/streams.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

template <class Fault>
const Fault* first_at(const std::vector<Fault>& faults, double time) {
  const auto found = std::find_if(faults.begin(), faults.end(), [time](const Fault& fault) {
    return time >= fault.start && time < fault.start + fault.duration;
  });
  return found == faults.end() ? nullptr : &*found;
}

/// The share of some value in a sentence, "0.5".
std::string number(double value) {
  std::string text = fixed_text(value, 6);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text + "0" : text;
}

}  // namespace

void EncoderFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("wheel", wheel, {"left", "right", "both"}, "whose encoder is dead");
  field("wheel_separation", wheel_separation, {0.01, 100.0}, "m", "between the two wheels");
}

void OdometryFaultParameters::fields(ParameterVisitor& field) {
  field.list("slips", slips, "wheels that turn more than the robot moves");
  field.list("dead_encoders", dead_encoders, "wheels that seem to stand");
  field.list("losses", losses, "messages that never arrive");
}

OdometryIncrement OdometryFaults::distorted(OdometryIncrement increment) const {
  const double time = increment.stamp - start_;
  if (const SlipParameters* slip = first_at(parameters_.slips, time)) {
    increment.speed *= 1.0 + slip->ratio;
    increment.lateral_speed *= 1.0 + slip->ratio;
  }
  if (const EncoderFault* dead = first_at(parameters_.dead_encoders, time)) {
    const double apart = 0.5 * increment.yaw_rate * dead->wheel_separation;
    const double left = dead->wheel == "right" ? increment.speed - apart : 0.0;
    const double right = dead->wheel == "left" ? increment.speed + apart : 0.0;
    increment.speed = 0.5 * (left + right);
    increment.lateral_speed *= dead->wheel == "both" ? 0.0 : 0.5;  // the mean of the wheels on both sides
    increment.yaw_rate = (right - left) / dead->wheel_separation;
  }
  return increment;
}

bool OdometryFaults::next_is_lost(double stamp) {
  const double drawn = RandomStream(seed_, messages_++, kOdometryLossStream).uniform();
  const ChanceFault* loss = first_at(parameters_.losses, stamp - start_);
  return loss != nullptr && drawn < loss->share;
}

std::optional<OdometryIncrement> OdometryFaults::spoil(const OdometryIncrement& increment) {
  OdometryIncrement spoilt = distorted(increment);
  spoilt.duration += lost_;
  if (next_is_lost(increment.stamp)) {
    lost_ = spoilt.duration;
    return std::nullopt;
  }
  lost_ = 0.0;
  return spoilt;
}

std::vector<std::string> OdometryFaults::active(double now) const {
  const double time = now - start_;
  std::vector<std::string> all;
  const auto add = [&](const std::string& what) { all.push_back("odometry: " + what); };
  if (const SlipParameters* slip = first_at(parameters_.slips, time)) add("slip of " + number(slip->ratio));
  if (const EncoderFault* dead = first_at(parameters_.dead_encoders, time)) {
    add(dead->wheel == "both" ? "both encoders dead" : dead->wheel + " encoder dead");
  }
  if (const ChanceFault* loss = first_at(parameters_.losses, time)) add(number(loss->share) + " of it lost");
  return all;
}

}  // namespace multipath_localization
