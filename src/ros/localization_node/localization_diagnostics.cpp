#include "ros/localization_node/localization_diagnostics.hpp"

#include <cmath>
#include <utility>

#include "ros/localization_node/estimate_messages.hpp"

namespace multipath_localization {

namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kLongSilence = 2.0;     ///< [s]
constexpr std::size_t kMostFrames = 10;  ///< unknown to tf, that are told

void tell(const FixReport& last, diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (last.sequence == 0) return;
  status.add("last reason", last.reason);
  status.add("age [s]", last.age);
  if (last.satellites > 0) {
    status.add("satellites", last.satellites);
    status.add("usable satellites", last.usable_satellites);
  } else {
    status.add("declared sigma [m]", last.declared_sigma);
    status.add("observed sigma [m]", last.observed_sigma);
    status.add("used sigma [m]", last.used_sigma);
  }
  status.add("predicted sigma of innovation [m]", last.predicted_sigma);
}

/// What of several receivers one is held to be off by.
void tell_receiver(const PoseEstimate& estimate, std::size_t receiver,
                   diagnostic_updater::DiagnosticStatusWrapper& status) {
  for (const ReceiverEstimate& known : estimate.receivers) {
    if (known.receiver != receiver) continue;
    status.add("bias [m]", known.bias.norm());
    status.add("shadow probability", known.shadow_probability);
  }
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

LocalizationDiagnostics::LocalizationDiagnostics(const LocalizationInputs& inputs, const Localizer& localizer,
                                                 const TfWatch& tf, Backlog& backlog,
                                                 const LocalizationParameters& parameters)
    : inputs_(inputs), localizer_(localizer), tf_(tf), backlog_(backlog), parameters_(parameters) {
  updater_.setHardwareID("none");
  updater_.add("odometry", this, &LocalizationDiagnostics::report_odometry);
  updater_.add("filter", this, &LocalizationDiagnostics::report_filter);
  updater_.add("tf", this, &LocalizationDiagnostics::report_tf);
}

void LocalizationDiagnostics::report() {
  for (const GnssInput& input : inputs_.gnss.all()) {
    if ((!input.counts() && !input.monitor.seen()) || !shown_.insert(input.name).second) continue;
    updater_.add(input.name, [this, &input](Status& status) { report_gnss(status, input); });
  }
  if (inputs_.gyro.monitor().seen() && shown_.insert("gyro").second) {
    updater_.add("gyro", this, &LocalizationDiagnostics::report_gyro);
  }
  if (inputs_.tilt.seen() && shown_.insert("tilt").second) {
    updater_.add("tilt", this, &LocalizationDiagnostics::report_tilt);
  }
  updater_.force_update();
}

bool LocalizationDiagnostics::set_antenna_frame(const std::string& frame, bool known) {
  if (!known) {
    return unknown_antenna_frames_.size() < kMostFrames && unknown_antenna_frames_.insert(frame).second;
  }
  unknown_antenna_frames_.erase(frame);
  return false;
}

void LocalizationDiagnostics::report_gnss(Status& status, const GnssInput& input) {
  const InputMonitor& monitor = input.monitor;
  summarise(status, monitor);
  const std::optional<FrozenReceiver> frozen = localizer_.frozen(input.receiver);
  if (input.kind == kFixKind && frozen && !monitor.silent(kLongSilence)) {
    status.summaryf(DiagnosticStatus::ERROR,
                    "receiver frozen %.0f s, the robot has driven %.0f m meanwhile: restart its driver",
                    frozen->duration, frozen->driven);
  }
  const FixReport& last = figures_[input.name];
  if (!monitor.awaited()) {
    status.summary(DiagnosticStatus::OK, parameters_.estimator + " has no use for it");
  } else if (!monitor.seen() && !inputs_.gnss.silent(kLongSilence)) {
    status.summary(DiagnosticStatus::OK, "does not come and is not needed");
  } else if (const std::string sigmas = sigmas_told(last);
             status.level == DiagnosticStatus::OK && !sigmas.empty()) {
    status.summary(DiagnosticStatus::OK, status.message + ": " + sigmas);
  }
  tell(last, status);
  if (input.kind == kFixKind) tell_receiver(localizer_.estimate(), input.receiver, status);
}

void LocalizationDiagnostics::report_odometry(Status& status) {
  summarise(status, inputs_.odometry);
  if (localizer_.mirrored()) {
    status.summary(
        DiagnosticStatus::ERROR,
        "turns the other way round than the fixes: mirrored, or NED; yaw is to be counter-clockwise");
  }
}

void LocalizationDiagnostics::report_gyro(Status& status) {
  const InputMonitor::Standing standing = inputs_.gyro.standing(localizer_.gyro());
  summarise(status, inputs_.gyro.monitor());
  status.summary(standing.sound ? DiagnosticStatus::OK : DiagnosticStatus::WARN, standing.sentence);
}

void LocalizationDiagnostics::report_tilt(Status& status) {
  const InputMonitor::Standing standing = inputs_.tilt.standing();
  status.summary(standing.sound ? DiagnosticStatus::OK : DiagnosticStatus::WARN, standing.sentence);
  const Tilt tilt = inputs_.tilt.now();
  status.add("roll [rad]", tilt.roll);
  status.add("pitch [rad]", tilt.pitch);
}

void LocalizationDiagnostics::report_filter(Status& status) {
  const PoseEstimate estimate = localizer_.estimate();
  const Trust trust = localizer_.state();
  status.summary(level_of(trust), std::string(to_string(trust)) + ": " + localizer_.state_reason());
  const Backlog::LeftOut left_out = backlog_.take_left_out();
  if (left_out.measurements > 0 || left_out.increments > 0) {
    status.summaryf(
        DiagnosticStatus::WARN,
        "does not keep up: %u measurements not weighed, %u of odometry summed up; lower the number "
        "of particles or the rates",
        left_out.measurements, left_out.increments);
  }
  if (!note_.empty()) status.summary(DiagnosticStatus::WARN, std::exchange(note_, ""));
  status.add("estimator", parameters_.estimator);
  status.add("poses since last report", std::exchange(poses_, 0));
  status.add("slowest update [ms]", 1e3 * std::exchange(slowest_update_, 0.0));
  if (!estimate.valid) return;
  status.add("position sigma [m]", std::sqrt(estimate.position_covariance_overall.trace()));
  status.add("yaw sigma [rad]", std::sqrt(estimate.covariance(2, 2)));
  status.add("bias [m]", estimate.bias.norm());
  status.add("shadow probability", estimate.shadow_probability);
  status.add("wheel fault probability", estimate.wheel_fault_probability);
  status.add("effective sample size", estimate.effective_sample_size);
}

void LocalizationDiagnostics::report_tf(Status& status) {
  const FrameParameters& frames = parameters_.frames;
  std::string unknown;
  for (const std::string& frame : unknown_antenna_frames_) unknown += " " + tf_.antennas().described(frame);
  if (!tf_.broadcaster_of_odom().empty() && parameters_.outputs.publish_tf) {
    status.summary(DiagnosticStatus::ERROR, tf_.broadcaster_of_odom() + " broadcasts a parent of " +
                                                frames.odom_frame +
                                                " too: stop it, or set publish_tf to false");
  } else if (!unknown.empty()) {
    status.summary(DiagnosticStatus::WARN, "no transform from " + frames.base_link_frame + " to" + unknown +
                                               parameters_.gnss.otherwise_at());
  } else {
    status.summary(DiagnosticStatus::OK, parameters_.outputs.publish_tf
                                             ? "broadcasts " + frames.map_frame + " -> " + frames.odom_frame
                                             : "broadcasts nothing, as asked");
  }
  status.add("antenna frames unknown to tf", unknown);
}

}  // namespace multipath_localization
