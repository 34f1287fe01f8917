#include "evaluation/trace.hpp"

#include <cmath>
#include <optional>

#include "evaluation/json.hpp"
#include "multipath_localization/core/angle.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

/// One array of JSON under its name, of a number per item.
template <class Items, class Number>
void write_array(std::ostream& out, const char* name, const Items& items, const Number& number) {
  out << "\"" << name << "\": [";
  const char* separator = "";
  for (const auto& item : items) {
    out << separator << number(item);
    separator = ",";
  }
  out << "]";
}

/// An error and when it was made.
struct TimedError {
  double time;
  double error;
};

void write_errors(std::ostream& out, const char* name, const std::vector<TimedError>& errors) {
  out << "\"" << name << "\": {";
  write_array(out, "t", errors, [](const TimedError& e) { return e.time; });
  out << ", ";
  write_array(out, "error", errors, [](const TimedError& e) { return e.error; });
  out << "}";
}

/// Distances of the fixes from where their antennas truly were [m], as far as truth reaches.
std::vector<TimedError> fix_errors(const Drive& drive, double start) {
  std::vector<TimedError> errors;
  for (const GnssFix& fix : drive.fixes()) {
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
  const std::vector<GnssFix> fixes = drive.fixes();
  out << "\"fixes\": {";
  write_array(out, "t", fixes, [&](const GnssFix& f) { return f.stamp - start; });
  out << ", ";
  write_array(out, "x", fixes, [](const GnssFix& f) { return f.position.x(); });
  out << ", ";
  write_array(out, "y", fixes, [](const GnssFix& f) { return f.position.y(); });
  out << "}, ";
  write_errors(out, "fix_errors", fix_errors(drive, start));
  out << ", \"truth\": {";
  write_array(out, "t", drive.truth, [&](const TruthSample& t) { return t.stamp - start; });
  out << ", ";
  write_array(out, "x", drive.truth, [](const TruthSample& t) { return t.base_in_map.x; });
  out << ", ";
  write_array(out, "y", drive.truth, [](const TruthSample& t) { return t.base_in_map.y; });
  out << ", ";
  write_array(out, "shadow", drive.truth,
              [](const TruthSample& t) { return t.shadow.value_or(false) ? 1 : 0; });
  out << "}";
}

void write_run(std::ostream& out, const RunRecord& run, const Drive& drive) {
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
  write_array(out, "t", valid, [&](const Epoch& e) { return e.truth.stamp - start; });
  out << ", ";
  write_array(out, "x", valid, [](const Epoch& e) { return e.estimate.x; });
  out << ", ";
  write_array(out, "y", valid, [](const Epoch& e) { return e.estimate.y; });
  out << ", ";
  write_array(out, "sigma", valid, [](const Epoch& e) { return std::sqrt(e.position_covariance.trace()); });
  out << ", ";
  write_errors(out, "errors", position_errors(valid, drive));
  out << ", ";
  write_errors(out, "heading_errors_deg", heading_errors(valid, start));
  out << "}";
}

}  // namespace

std::string to_trace(const std::string& title, const Stream& stream, const std::vector<RunRecord>& runs) {
  std::vector<const RunRecord*> drawn;
  for (const RunRecord& run : runs) {
    if (run.seed == 1 && run.failure.empty()) drawn.push_back(&run);
  }
  const auto* drive = std::get_if<Drive>(&stream);
  const bool own = !drawn.empty() && !drawn.front()->drive.odometry.empty();
  if (own) drive = &drawn.front()->drive;
  if (drive == nullptr) return "{}";

  PlainStream out;
  out.precision(9);
  out << "{\"title\": " << quoted(title) << ", ";
  write_drive(out, *drive, drive->start());
  out << ", \"runs\": [";
  for (const RunRecord* run : drawn) {
    if (run != drawn.front()) out << ", ";
    write_run(out, *run, *drive);
  }
  out << "]}\n";
  return out.str();
}

}  // namespace multipath_localization
