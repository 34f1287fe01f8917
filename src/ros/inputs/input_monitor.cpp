#include "ros/inputs/input_monitor.hpp"

#include <algorithm>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::size_t kLeastOutcomes = 10;
constexpr double kRecent = 5.0;          ///< [s]
constexpr double kComplainEvery = 10.0;  ///< [s]
constexpr double kLongSilence = 2.0;     ///< [s]
constexpr double kSilentIntervals = 3.0;
constexpr double kSmoothing = 0.3;  ///< share of the latest in the interval

}  // namespace

InputMonitor::InputMonitor(std::string what, std::vector<ros::Subscriber> subscribers, bool awaited)
    : what_(std::move(what)), subscribers_(std::move(subscribers)), awaited_(awaited) {}

void InputMonitor::arrived() {
  if (messages_ > 0) interval_ += (messages_ == 1 ? 1.0 : kSmoothing) * (silence() - interval_);
  ++messages_;
  last_ = ros::WallTime::now();
}

bool InputMonitor::silent(double bound) const {
  return silence() > std::max(bound, kSilentIntervals * interval_);
}

void InputMonitor::count(Reason reason, const std::string& detail) {
  const ros::WallTime now = ros::WallTime::now();
  all_.count(reason);
  recent_.count(reason);
  outcomes_.push_back({now, reason});
  if (!detail.empty()) details_[reason] = detail;
  forget_old(now);
}

void InputMonitor::forget_old(ros::WallTime now) {
  while (outcomes_.size() > kLeastOutcomes && (now - outcomes_.front().time).toSec() > kRecent) {
    recent_.remove(outcomes_.front().reason);
    outcomes_.pop_front();
  }
}

std::string InputMonitor::refusal() const {
  const auto detail = details_.find(recent_.most_frequent_refusal());
  return recent_.refusal() + (detail == details_.end() ? "" : ": " + detail->second);
}

std::string InputMonitor::complaint() {
  const Reason why = recent_.most_frequent_refusal();
  const ros::WallTime now = ros::WallTime::now();
  const bool said = why == complained_of_ && (now - complained_).toSec() < kComplainEvery;
  if (!awaited_ || !recent_.loses() || said) return "";
  complained_ = now;
  complained_of_ = why;
  return what_ + ": " + refusal();
}

std::string InputMonitor::sum() const { return all_.total() == 0 ? "" : what_ + ": " + all_.sum(); }

InputMonitor::Standing InputMonitor::standing() const {
  if (!seen()) return {false, "waiting for " + described()};
  if (silent(kLongSilence)) {
    return {false, "silent for " + std::to_string(static_cast<int>(silence())) + " s: " + described()};
  }
  if (recent_.loses()) return {false, refusal()};
  if (recent_.total() == 0) return {false, "arrives, and waits to be used"};
  const unsigned used = recent_.of(Reason::kAccepted);
  if (used == 0 && recent_.of(Reason::kOverload) > 0) return {false, "arrives, and none is used: overload"};
  if (used == 0 && recent_.of(Reason::kRepeated) > 0) return {true, "arrives and repeats itself, as parked"};
  return {true, used == 0 ? "arrives and is not needed" : "arrives and is used"};
}

std::string InputMonitor::described() const {
  std::string text = what_ + " on ";
  const char* separator = "";
  for (const ros::Subscriber& subscriber : subscribers_) {
    const auto publishers = subscriber.getNumPublishers();
    text += separator + subscriber.getTopic() + " (" + std::to_string(publishers) +
            (publishers == 1 ? " publisher)" : " publishers)");
    separator = ", ";
  }
  return text;
}

void summarise(diagnostic_updater::DiagnosticStatusWrapper& status, const InputMonitor& input) {
  using diagnostic_msgs::DiagnosticStatus;
  const InputMonitor::Standing standing = input.standing();
  status.summary(standing.sound ? DiagnosticStatus::OK : DiagnosticStatus::WARN, standing.sentence);
  for (const auto& [reason, number] : input.tally().counts()) {
    status.add(std::string(to_string(reason)), number);
  }
}

}  // namespace multipath_localization
