#include "nodes/localization_diagnostics.hpp"

#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kLongSilence = 2.0;  ///< [s]

std::string most_frequent_refusal(const InputMonitor& input) {
  Reason found = Reason::kAccepted;
  unsigned most = 0;
  for (const auto& [reason, number] : input.counts()) {
    if (reason == Reason::kAccepted || number <= most) continue;
    found = reason;
    most = number;
  }
  return std::string(to_string(found));
}

void summarise_input(diagnostic_updater::DiagnosticStatusWrapper& status, const InputMonitor& input,
                     unsigned& refused_then) {
  const unsigned newly_refused = input.refused() - std::exchange(refused_then, input.refused());
  if (!input.seen()) {
    status.summaryf(DiagnosticStatus::WARN, "waiting for %s", input.described().c_str());
  } else if (input.silence() > kLongSilence) {
    status.summaryf(DiagnosticStatus::WARN, "silent for %.0f s: %s", input.silence(),
                    input.described().c_str());
  } else if (newly_refused > 0) {
    status.summaryf(DiagnosticStatus::WARN, "refused %u, most often for: %s", newly_refused,
                    most_frequent_refusal(input).c_str());
  } else {
    status.summary(DiagnosticStatus::OK, "arrives and is used");
  }
  for (const auto& [reason, number] : input.counts()) status.add(std::string(to_string(reason)), number);
}

unsigned char level_of(Trust trust) {
  switch (trust) {
    case Trust::kGood:
    case Trust::kMultipath: return DiagnosticStatus::OK;
    case Trust::kLost: return DiagnosticStatus::ERROR;
    default: return DiagnosticStatus::WARN;
  }
}

}  // namespace

LocalizationDiagnostics::LocalizationDiagnostics(const InputMonitor& fix, const InputMonitor& odometry,
                                                 const Localizer& localizer, const TfWatch& tf,
                                                 const LocalizationParameters& parameters)
    : fix_(fix), odometry_(odometry), localizer_(localizer), tf_(tf), parameters_(parameters) {
  updater_.setHardwareID("none");
  updater_.add("fix", this, &LocalizationDiagnostics::report_fix);
  updater_.add("odometry", this, &LocalizationDiagnostics::report_odometry);
  updater_.add("filter", this, &LocalizationDiagnostics::report_filter);
  updater_.add("tf", this, &LocalizationDiagnostics::report_tf);
}

void LocalizationDiagnostics::add(const FixReport& report) {
  last_report_ = report;
  if (report.predicted_sigma <= 0.0) return;
  sum_of_squared_innovations_ += std::pow(report.innovation_x, 2) + std::pow(report.innovation_y, 2);
  ++innovations_;
}

void LocalizationDiagnostics::report_fix(Status& status) {
  summarise_input(status, fix_, refused_fixes_);
  if (last_report_.sequence == 0) return;
  status.add("last reason", last_report_.reason);
  status.add("age [s]", last_report_.age);
  status.add("declared sigma [m]", last_report_.declared_sigma);
  status.add("predicted sigma of innovation [m]", last_report_.predicted_sigma);
  if (innovations_ > 0) {
    status.add("observed sigma of innovation [m]",
               std::sqrt(0.5 * sum_of_squared_innovations_ / innovations_));
  }
  sum_of_squared_innovations_ = 0.0;
  innovations_ = 0;
}

void LocalizationDiagnostics::report_odometry(Status& status) {
  summarise_input(status, odometry_, refused_odometry_);
}

void LocalizationDiagnostics::report_filter(Status& status) {
  const PoseEstimate estimate = localizer_.estimate();
  const Trust trust = localizer_.state();
  status.summary(level_of(trust), std::string(to_string(trust)) + ": " + localizer_.state_reason());
  if (!note_.empty()) status.summary(DiagnosticStatus::WARN, std::exchange(note_, ""));
  status.add("estimator", parameters_.estimator);
  status.add("poses since last report", std::exchange(poses_, 0));
  status.add("slowest update [ms]", 1e3 * std::exchange(slowest_update_, 0.0));
  if (!estimate.valid) return;
  status.add("position sigma [m]", std::sqrt(estimate.position_covariance_overall.trace()));
  status.add("yaw sigma [rad]", std::sqrt(estimate.covariance(2, 2)));
  status.add("bias [m]", estimate.bias.norm());
  status.add("shadow probability", estimate.shadow_probability);
  status.add("canyon probability", estimate.canyon_probability);
  status.add("effective sample size", estimate.effective_sample_size);
}

void LocalizationDiagnostics::report_tf(Status& status) {
  const FrameParameters& frames = parameters_.frames;
  if (!tf_.broadcaster_of_odom().empty() && parameters_.outputs.publish_tf) {
    status.summary(DiagnosticStatus::ERROR, tf_.broadcaster_of_odom() + " broadcasts a parent of " +
                                                frames.odom_frame +
                                                " too: stop it, or set publish_tf to false");
  } else if (!unknown_antenna_frame_.empty()) {
    status.summary(DiagnosticStatus::WARN, "no transform from " + frames.base_link_frame + " to " +
                                               unknown_antenna_frame_ +
                                               ": the antenna is taken to be at the base");
  } else {
    status.summary(DiagnosticStatus::OK, parameters_.outputs.publish_tf
                                             ? "broadcasts " + frames.map_frame + " -> " + frames.odom_frame
                                             : "broadcasts nothing, as asked");
  }
  status.add("antenna frame unknown to tf", unknown_antenna_frame_);
}

}  // namespace multipath_localization
