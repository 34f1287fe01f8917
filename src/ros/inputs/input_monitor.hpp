#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <ros/subscriber.h>
#include <ros/time.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "multipath_localization/core/reason_tally.hpp"

namespace multipath_localization {

/// What came in of one kind of input, on one topic or on several that belong together: how often, how long
/// ago, and what became of it. What is said of an input, on the console and on /diagnostics, is decided here:
/// by the last ten outcomes, or those of the last five seconds where these are more.
class InputMonitor {
 public:
  /// `what`: its name in sentences. `awaited`: whether the node can use it.
  InputMonitor(std::string what, std::vector<ros::Subscriber> subscribers, bool awaited);

  /// A message has come in.
  void arrived();
  /// What became of it; `detail` says more of the reason.
  void count(Reason reason, const std::string& detail = "");

  /// What the console is to be told after an outcome: that more than a tenth is refused, and why. Empty for
  /// nothing, and when the same was said in the last ten seconds.
  std::string complaint();
  /// What became of all since the start; empty where nothing came.
  [[nodiscard]] std::string sum() const;

  struct Standing {
    bool sound = true;
    std::string sentence;
  };
  /// How it is by now.
  [[nodiscard]] Standing standing() const;

  /// "odom on /odom (1 publisher)", "dual on /gps/left/fix (1 publisher), /gps/right/fix (0 publishers)"
  [[nodiscard]] std::string described() const;
  /// Since the last message, or since the start [s, wall clock].
  [[nodiscard]] double silence() const { return (ros::WallTime::now() - last_).toSec(); }
  /// Whether that is longer than `bound` [s] and than three of the intervals at which it comes.
  [[nodiscard]] bool silent(double bound) const;
  /// At which messages come, 0 before the second one [Hz].
  [[nodiscard]] double frequency() const { return interval_ > 0.0 ? 1.0 / interval_ : 0.0; }
  [[nodiscard]] bool seen() const { return messages_ > 0; }
  [[nodiscard]] bool awaited() const { return awaited_; }
  /// Since the start.
  [[nodiscard]] const ReasonTally& tally() const { return all_; }

 private:
  struct Outcome {
    ros::WallTime time;
    Reason reason;
  };
  void forget_old(ros::WallTime now);
  [[nodiscard]] std::string refusal() const;

  std::string what_;
  std::vector<ros::Subscriber> subscribers_;
  bool awaited_;
  ros::WallTime last_ = ros::WallTime::now();
  double interval_ = 0.0;  ///< at which messages come, smoothed [s]
  unsigned messages_ = 0;
  ReasonTally all_, recent_;
  std::deque<Outcome> outcomes_;           ///< that `recent_` counts
  std::map<Reason, std::string> details_;  ///< the last of each reason
  ros::WallTime complained_;
  Reason complained_of_ = Reason::kAccepted;
};

/// Its sentence as the summary of a status on /diagnostics, and a counter for each reason.
void summarise(diagnostic_updater::DiagnosticStatusWrapper& status, const InputMonitor& input);

}  // namespace multipath_localization
