#include "ros/gnss_receiver_node/receiver_diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kClockTolerance = 1.0;  // of the host's clock [s]
constexpr double kBadShare = 0.01;       // of messages with a wrong checksum
constexpr const char* kEnable = ": enable them on this port (u-center, or the driver's parameters)";

std::string plural(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

ReceiverDiagnostics::ReceiverDiagnostics(const ByteSource* source, const UbxReceiver& receiver,
                                         const LivePositioning& positioning)
    : source_(source), receiver_(receiver), positioning_(positioning) {
  updater_.setHardwareID("none");
  updater_.add("receiver", [this](Status& status) { tell(status); });
}

void ReceiverDiagnostics::add_epoch(double ahead, bool published) {
  host_ahead_ = ahead;
  ++epochs_;
  published_ += published ? 1 : 0;
}

std::string ReceiverDiagnostics::what_is_wrong(double seconds) const {
  const std::size_t bad = receiver_.framing().checksum_errors();
  const std::size_t good = receiver_.framing().messages();
  if (source_ != nullptr && !source_->trouble().empty()) return source_->trouble();
  if (!refused_.empty()) return refused_ + ": messages of another version or type";
  // A file is read ahead.
  if (source_ != nullptr && !source_->is_file() && bytes_ == 0) return "no bytes come";
  if (epochs_ == 0) return "no RXM-RAWX for " + std::to_string(static_cast<int>(seconds)) + " s" + kEnable;
  if (receiver_.counts().subframes == 0 && positioning_.standing().with_ephemeris == 0) {
    return std::string("no RXM-SFRBX so far") + kEnable;
  }
  if (!positioning_.standing().shortage.empty()) return positioning_.standing().shortage;
  if (static_cast<double>(bad) > kBadShare * static_cast<double>(good)) {
    return plural(bad, "checksum error") + " in " + plural(good, "message") +
           ": is the line too slow, or the cable too long?";
  }
  return "";
}

void ReceiverDiagnostics::tell(Status& status) {
  const ros::WallTime now = ros::WallTime::now();
  const double seconds = std::max((now - std::exchange(reported_, now)).toSec(), 1e-3);
  const LivePositioning::Standing& standing = positioning_.standing();
  const std::string wrong = what_is_wrong(seconds);
  if (!wrong.empty()) {
    status.summary(published_ == 0 ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN, wrong);
  } else if (std::abs(host_ahead_) > kClockTolerance) {
    status.summaryf(DiagnosticStatus::WARN,
                    "the host's clock is %.1f s ahead of the receiver's: synchronise it, or set stamps to "
                    "arrival",
                    host_ahead_);
  } else {
    status.summary(DiagnosticStatus::OK, "epochs of " + plural(standing.used, "satellite"));
  }
  status.add("bytes per second", static_cast<double>(std::exchange(bytes_, 0)) / seconds);
  status.add("epochs per second", static_cast<double>(std::exchange(epochs_, 0)) / seconds);
  status.add("epochs published per second", static_cast<double>(std::exchange(published_, 0)) / seconds);
  status.add("messages", receiver_.framing().messages());
  status.add("checksum errors", receiver_.framing().checksum_errors());
  status.add("subframes", receiver_.counts().subframes);
  status.add("ephemerides", receiver_.broadcast().ephemerides());
  status.add("impossible ephemerides", receiver_.broadcast().impossible());
  status.add("satellites heard", standing.heard);
  status.add("satellites with ephemeris", standing.with_ephemeris);
  status.add("satellites used", standing.used);
  status.add("clock resets", receiver_.counts().clock_resets);
  refused_.clear();
}

}  // namespace multipath_localization
