#include "evaluation/trace.hpp"

#include <cmath>
#include <optional>
#include <variant>

#include "evaluation/json.hpp"
#include "evaluation/report.hpp"
#include "evaluation/text_table.hpp"
#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/measurement_kinds.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

/// Columns of an object of JSON: arrays of one number, or text, per item.
template <class Items>
class Columns {
 public:
  Columns(std::ostream& out, const Items& items) : out_(out), items_(items) {}

  template <class Cell>
  Columns& add(const char* name, const Cell& cell) {
    out_ << comma_ << "\"" << name << "\": [";
    const char* separator = "";
    for (const auto& item : items_) {
      out_ << separator << cell(item);
      separator = ",";
    }
    out_ << "]";
    comma_ = ", ";
    return *this;
  }

 private:
  std::ostream& out_;
  const Items& items_;
  const char* comma_ = "";
};

/// An error and when it was made.
struct TimedError {
  double time;
  double error;
};

void write_errors(std::ostream& out, const char* name, const std::vector<TimedError>& errors) {
  out << "\"" << name << "\": {";
  Columns(out, errors)
      .add("t", [](const TimedError& e) { return e.time; })
      .add("error", [](const TimedError& e) { return e.error; });
  out << "}";
}

/// Those that can be drawn: faults may make some of them not finite.
std::vector<GnssFix> finite_fixes(const Drive& drive) {
  std::vector<GnssFix> fixes;
  for (const GnssFix& fix : drive.fixes()) {
    if (fix.position.allFinite()) fixes.push_back(fix);
  }
  return fixes;
}

/// Distances of the fixes from where their antennas truly were [m], as far as truth reaches.
std::vector<TimedError> fix_errors(const Drive& drive, double start) {
  std::vector<TimedError> errors;
  for (const GnssFix& fix : finite_fixes(drive)) {
    const std::optional<TruthSample> truth = truth_at(drive.truth, fix.stamp);
    if (!truth) continue;
    const Eigen::Vector2d antenna = antenna_in_map(*truth, fix.antenna_in_base);
    errors.push_back({fix.stamp - start, (fix.position - antenna).norm()});
  }
  return errors;
}

/// Errors of the position, none without truth [m].
std::vector<TimedError> position_errors(const std::vector<Epoch>& epochs, const Drive& drive) {
  if (drive.truth.empty()) return {};
  std::vector<TimedError> errors;
  errors.reserve(epochs.size());
  for (const Epoch& epoch : epochs) {
    const Eigen::Vector2d off = epoch.estimate.position() - epoch.truth.base_in_map.position();
    errors.push_back({epoch.truth.stamp - drive.start(), off.norm()});
  }
  return errors;
}

/// Errors of the heading where truth has one [deg].
std::vector<TimedError> heading_errors(const std::vector<Epoch>& epochs, double start) {
  std::vector<TimedError> errors;
  for (const Epoch& epoch : epochs) {
    const double error = angle_difference(epoch.estimate.yaw, epoch.truth.base_in_map.yaw);
    if (epoch.truth.has_yaw) errors.push_back({epoch.truth.stamp - start, error * 180.0 / kPi});
  }
  return errors;
}

void write_drive(std::ostream& out, const Drive& drive, double start) {
  const std::vector<GnssFix> fixes = finite_fixes(drive);
  out << "\"fixes\": {";
  Columns(out, fixes)
      .add("t", [&](const GnssFix& f) { return f.stamp - start; })
      .add("x", [](const GnssFix& f) { return f.position.x(); })
      .add("y", [](const GnssFix& f) { return f.position.y(); });
  out << "}, ";
  write_errors(out, "fix_errors", fix_errors(drive, start));
  out << ", \"truth\": {";
  Columns(out, drive.truth)
      .add("t", [&](const TruthSample& t) { return t.stamp - start; })
      .add("x", [](const TruthSample& t) { return t.base_in_map.x; })
      .add("y", [](const TruthSample& t) { return t.base_in_map.y; })
      .add("shadow", [](const TruthSample& t) { return t.shadow.value_or(false) ? 1 : 0; });
  out << "}, \"odometry\": {";
  Columns(out, drive.odometry)
      .add("t", [&](const OdometryIncrement& u) { return u.stamp - start; })
      .add("speed", [](const OdometryIncrement& u) { return u.speed; });
  out << "}";
}

/// Where the estimate was, and how sure.
void write_estimates(std::ostream& out, const std::vector<Epoch>& epochs, double start) {
  Columns(out, epochs)
      .add("t", [&](const Epoch& e) { return e.truth.stamp - start; })
      .add("x", [](const Epoch& e) { return e.estimate.x; })
      .add("y", [](const Epoch& e) { return e.estimate.y; })
      .add("yaw", [](const Epoch& e) { return e.estimate.yaw; })
      .add("state", [](const Epoch& e) { return quoted(std::string(to_string(e.state))); })
      .add("sigma", [](const Epoch& e) { return std::sqrt(e.position_covariance.trace()); });
  out << ", \"covariance\": {";
  Columns(out, epochs)
      .add("xx", [](const Epoch& e) { return e.position_covariance(0, 0); })
      .add("xy", [](const Epoch& e) { return e.position_covariance(0, 1); })
      .add("yy", [](const Epoch& e) { return e.position_covariance(1, 1); });
  out << "}";
}

/// What became of the measurements the estimator has a model for.
void write_weighings(std::ostream& out, const RunRecord& run, double start) {
  std::vector<Weighing> used;
  for (const Weighing& weighing : run.weighings) {
    if (weighing.reason != Reason::kUnused) used.push_back(weighing);
  }
  out << "\"weighings\": {";
  Columns(out, used)
      .add("t", [&](const Weighing& w) { return w.stamp - start; })
      .add("kind", [&](const Weighing& w) { return quoted(std::string(kMeasurementNames.at(w.kind))); })
      .add("reason", [](const Weighing& w) { return quoted(std::string(to_string(w.reason))); })
      .add("nis", [](const Weighing& w) { return w.nis ? number(*w.nis, 6) : "null"; });
  out << "}";
}

/// What a run went over: a drive of its own, as every run of a scenario has, or the recording.
const Drive* drive_of(const RunRecord& run, const Stream& stream) {
  return run.drive.odometry.empty() ? std::get_if<Drive>(&stream) : &run.drive;
}

/// A run over `drive`, which is told too where it is another one than that of the first run.
void write_run(std::ostream& out, const RunRecord& run, const Drive& drive, bool another) {
  const double start = drive.start();
  std::vector<Epoch> valid;
  for (const Epoch& epoch : run.epochs) {
    if (epoch.valid) valid.push_back(epoch);
  }
  out << "{\"estimator\": " << quoted(run.estimator) << ", \"rmse\": ";
  if (run.score.rmse) {
    out << *run.score.rmse << ", ";
  } else {
    out << "null, ";
  }
  write_estimates(out, valid, start);
  out << ", ";
  write_errors(out, "errors", position_errors(valid, drive));
  out << ", ";
  write_errors(out, "heading_errors_deg", heading_errors(valid, start));
  out << ", ";
  write_weighings(out, run, start);
  if (another) {
    out << ", \"drive\": {";
    write_drive(out, drive, start);
    out << "}";
  }
  out << ", \"figures\": " << json_of_figures(run) << "}";
}

}  // namespace

std::string to_trace(const std::string& title, const Stream& stream, const std::vector<RunRecord>& runs) {
  std::vector<const RunRecord*> drawn;
  for (const RunRecord& run : runs) {
    if (run.seed == runs.front().seed && run.failure.empty()) drawn.push_back(&run);
  }
  const Drive* drive = drawn.empty() ? std::get_if<Drive>(&stream) : drive_of(*drawn.front(), stream);
  if (drive == nullptr) return "{}";

  PlainStream out;
  out.precision(9);
  out << "{\"title\": " << quoted(title) << ", ";
  write_drive(out, *drive, drive->start());
  out << ", \"runs\": [";
  for (const RunRecord* run : drawn) {
    if (run != drawn.front()) out << ", ";
    const Drive* driven = drive_of(*run, stream);
    write_run(out, *run, *driven, driven != drive);
  }
  out << "]}\n";
  return out.str();
}

}  // namespace multipath_localization
