#include "multipath_localization/evaluation/trace.hpp"

#include <cmath>
#include <functional>
#include <sstream>

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

void write_drive(std::ostream& out, const Drive& drive, double start) {
  out << "\"fixes\": {";
  write_array(out, "t", drive.fixes, [&](const RecordedFix& f) { return f.fix.stamp - start; });
  out << ", ";
  write_array(out, "x", drive.fixes, [](const RecordedFix& f) { return f.fix.position.x(); });
  out << ", ";
  write_array(out, "y", drive.fixes, [](const RecordedFix& f) { return f.fix.position.y(); });
  out << "}, \"truth\": {";
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

void write_run(std::ostream& out, const RunRecord& run, double start) {
  std::vector<Epoch> valid;
  for (const Epoch& epoch : run.epochs) {
    if (epoch.valid) valid.push_back(epoch);
  }
  out << R"({"estimator": ")" << run.estimator << R"(", "rmse": )";
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
  write_array(out, "error", valid,
              [](const Epoch& e) { return (e.estimate.position() - e.truth.base_in_map.position()).norm(); });
  out << ", ";
  write_array(out, "sigma", valid, [](const Epoch& e) { return std::sqrt(e.position_covariance.trace()); });
  out << "}";
}

}  // namespace

std::string to_trace(const std::string& title, const Stream& stream, const std::vector<RunRecord>& runs) {
  std::vector<const RunRecord*> drawn;
  for (const RunRecord& run : runs) {
    if (run.seed == 1 && run.failure.empty()) drawn.push_back(&run);
  }
  const auto* recorded = std::get_if<Drive>(&stream);
  const Drive* const drive = recorded != nullptr ? recorded : drawn.empty() ? nullptr : &drawn.front()->drive;
  if (drive == nullptr) return "{}";

  std::ostringstream out;
  out.precision(9);
  out << R"({"title": ")" << title << "\", ";
  write_drive(out, *drive, drive->start());
  out << ", \"runs\": [";
  for (const RunRecord* run : drawn) {
    if (run != drawn.front()) out << ", ";
    write_run(out, *run, drive->start());
  }
  out << "]}\n";
  return out.str();
}

}  // namespace multipath_localization
