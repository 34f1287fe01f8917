#include "multipath_localization/localization/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::size_t kMostWaiting = 1000;  ///< measurements ahead of odometry that has stopped

/// "about 7 m more", or "on" where the way is not known.
std::string way_on(double way) {
  if (!std::isfinite(way)) return "on";
  return "about " + std::to_string(std::max(1L, std::lround(std::ceil(way)))) + " m more";
}

OdometryIncrement lasting(OdometryIncrement increment, double start, double end) {
  increment.stamp = end;
  increment.duration = end - start;
  return increment;
}

bool position_known(const PoseEstimate& estimate, double lost_sigma) {
  return estimate.position_covariance_overall.trace() < lost_sigma * lost_sigma;
}

bool any_frozen(const std::map<std::size_t, ReceiverRecord>& receivers) {
  return std::any_of(receivers.begin(), receivers.end(),
                     [](const auto& known) { return known.second.frozen.has_value(); });
}

}  // namespace

void LocalizerParameters::fields(ParameterVisitor& field) {
  field("history_length", history_length, {0.1, 60.0}, "s",
        "odometry kept, so that fixes this late still count");
  tunable(field);
}

void LocalizerParameters::tunable(ParameterVisitor& field) {
  field("future_tolerance", future_tolerance, {0.0, 10.0}, "s",
        "a fix stamped further ahead of the odometry than this is refused");
  field("dead_reckoning_after", dead_reckoning_after, {0.1, 600.0}, "s",
        "without an accepted fix for this long the state is DEAD_RECKONING");
  field("lost_sigma", lost_sigma, {0.1, 1e4}, "m",
        "with a larger standard deviation of position over all hypotheses the state is LOST");
  field("frozen_distance", frozen_distance, {0.0, 1000.0}, "m",
        "a receiver that says the same to the bit while the robot drives this far is frozen");
  field.group("fix_covariance", fix_covariance, "how far receivers are believed");
}

Localizer::Localizer(std::unique_ptr<Estimator> estimator, const LocalizerParameters& parameters)
    : estimator_(std::move(estimator)), parameters_(parameters), history_(parameters.history_length) {}

void Localizer::start(const std::optional<PosePrior>& prior) {
  estimator_->start(prior);
  history_.clear();
  receivers_.clear();
  standstill_ = {};
  waiting_.clear();
  accepted_ = {};
  start_.reset();
  settled_ = prior && prior->confirmed;
}

void Localizer::tune(ParameterVisitor& field) {
  parameters_.tunable(field);
  for (auto& [number, receiver] : receivers_) receiver.covariance.set(parameters_.fix_covariance);
}

void Localizer::add(const OdometryIncrement& reported) {
  const OdometryIncrement settled = standstill_.settled(reported);
  const OdometryIncrement increment = gyro_.with_turn(settled, standstill_.at_rest());
  double from = increment.stamp - increment.duration;
  const auto advance = [&](double to) {
    if (to <= from) return;
    const OdometryIncrement part = lasting(increment, from, to);
    history_.add(part);
    for (auto& [number, receiver] : receivers_) receiver.mirror.add(part);
    driven_ += ground_speed(part) * part.duration;
    estimator_->predict(part);
    now_ = from = to;
  };
  if (!start_) start_ = now_ = from;
  while (!waiting_.empty() && stamp_of(waiting_.front()) <= increment.stamp) {
    const Measurement measurement = waiting_.front();
    waiting_.pop_front();
    advance(stamp_of(measurement));
    apply(measurement);
  }
  advance(increment.stamp);
  if (settled_) return;
  const PoseEstimate estimate = estimator_->estimate();
  settled_ = estimate.valid && estimate.aligned && position_known(estimate, parameters_.lost_sigma);
}

void Localizer::add(const Measurement& measurement) {
  const double stamp = stamp_of(measurement);
  if (!start_) {
    reports_.push_back({stamp, measurement, refused(Reason::kNotStarted), {}, {}});
  } else if (stamp > now_ + parameters_.future_tolerance || waiting_.size() >= kMostWaiting) {
    reports_.push_back({stamp, measurement, refused(Reason::kFutureStamp), {}, {}});
  } else if (stamp > now_) {
    const auto place = std::upper_bound(waiting_.begin(), waiting_.end(), stamp,
                                        [](double t, const Measurement& m) { return t < stamp_of(m); });
    waiting_.insert(place, measurement);
  } else {
    apply(measurement);
  }
}

void Localizer::apply(const Measurement& measurement) {
  const double stamp = stamp_of(measurement);
  MeasurementReport report{stamp, measurement, refused(Reason::kOldStamp), std::nullopt, std::nullopt};
  std::optional<Measurement> carried = carried_back(measurement, [this](double then) {
    return then == now_ ? std::optional<Pose2>(Pose2{}) : history_.base_then_in_base_now(then);
  });
  if (carried) {
    auto* fix = std::get_if<GnssFix>(&*carried);
    report.innovation = fix == nullptr ? estimator_->update(*carried) : weigh(*fix, report);
  }
  if (report.innovation.accepted() || report.innovation.reason == Reason::kRepeated) {
    accepted_.note(measurement);
  }
  reports_.push_back(report);
}

Innovation Localizer::weigh(GnssFix& fix, MeasurementReport& report) {
  const PoseEstimate before = estimator_->estimate();
  ReceiverRecord& receiver = receivers_.try_emplace(fix.receiver, parameters_.fix_covariance).first->second;
  fix.covariance = receiver.covariance.of(fix.covariance);
  Innovation innovation = estimator_->update(fix);
  receiver.tell_frozen(fix, driven_, parameters_.frozen_distance, innovation.reason);
  const double expected = innovation.covariance.trace();
  if (expected > 0.0) {
    report.used_sigma = std::sqrt(0.5 * (expected + before.bias_of(fix.receiver).squaredNorm()));
  }
  const bool sound = innovation.accepted() || innovation.reason == Reason::kGated;
  if (sound) receiver.mirror.add(fix);
  if (sound && before.aligned) {
    receiver.covariance.observe(driven_, fix.position - before.pose * fix.antenna_in_base);
  }
  report.observed_sigma = receiver.covariance.observed_sigma();
  return innovation;
}

std::optional<FrozenReceiver> Localizer::frozen(std::size_t receiver) const {
  const auto known = receivers_.find(receiver);
  return known == receivers_.end() ? std::nullopt : known->second.frozen;
}

bool Localizer::mirrored() const {
  return std::any_of(receivers_.begin(), receivers_.end(),
                     [](const auto& known) { return known.second.mirror.mirrored(); });
}

std::vector<MeasurementReport> Localizer::take_reports() { return std::exchange(reports_, {}); }

Trust Localizer::state() const {
  const PoseEstimate estimate = estimator_->estimate();
  if (!start_ || !estimate.valid) return Trust::kNotReady;
  if (!estimate.aligned || mirrored()) return Trust::kAligning;
  if (!position_known(estimate, parameters_.lost_sigma)) return settled_ ? Trust::kLost : Trust::kAligning;
  if (now_ - std::max(*start_, accepted_.stamp()) > parameters_.dead_reckoning_after)
    return Trust::kDeadReckoning;
  return estimate.shadow_probability > 0.5 ? Trust::kMultipath : Trust::kGood;
}

std::string Localizer::state_reason() const {
  const PoseEstimate estimate = estimator_->estimate();
  const std::string missed = accepted_.missed(now_, parameters_.dead_reckoning_after);
  switch (state()) {
    case Trust::kNotReady: return start_ ? "waiting for a usable fix" : "waiting for odometry";
    case Trust::kAligning:
      if (mirrored()) {
        return "odometry turns the other way round than the fixes: is it mirrored, or NED? Let doctor look";
      }
      if (estimate.wheel_fault_probability > 0.5) {
        return "odometry contradicts the fixes: do the wheels slip, does an encoder fail?";
      }
      return "heading or position not yet confirmed, drive " + way_on(estimate.way_to_alignment) +
             " under open sky";
    case Trust::kGood: return accepted_.kind() + " agree with odometry" + missed;
    case Trust::kMultipath: return accepted_.kind() + " are biased, the bias is being tracked" + missed;
    case Trust::kDeadReckoning:
      return std::string(any_frozen(receivers_) ? "receiver frozen" : "no usable fix") +
             ", running on odometry";
    case Trust::kLost: return "position too uncertain to drive by";
  }
  return "";
}

}  // namespace multipath_localization
