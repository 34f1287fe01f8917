#include "multipath_localization/evaluation/drive.hpp"

#include <algorithm>
#include <filesystem>

namespace multipath_localization {

namespace {

constexpr double kFirstInterval = 1e-3;

double stamp_in_order(const CsvTable& table, std::size_t row) {
  const double stamp = table.number(row, "t");
  if (row > 0 && stamp <= table.number(row - 1, "t")) throw table.error(row, "t does not increase");
  return stamp;
}

Geodetic point(const CsvTable& table, std::size_t row) {
  const Geodetic point{table.number(row, "lat_deg"), table.number(row, "lon_deg"),
                       table.has("alt_m") ? table.number(row, "alt_m") : 0.0};
  if (!valid(point)) throw table.error(row, "latitude or longitude out of range");
  return point;
}

std::vector<OdometryIncrement> read_odometry(const std::string& file) {
  const CsvTable table(file, {"t", "vx", "wz"});
  if (table.rows() < 2) throw DriveError(file + ": fewer than two rows");
  std::vector<TwistSample> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    samples.push_back({stamp_in_order(table, i), table.number(i, "vx"), table.number(i, "wz")});
  }
  return increments(samples);
}

RecordedFix read_fix(const CsvTable& table, std::size_t row, const LocalFrame& map) {
  RecordedFix recorded;
  recorded.fix.stamp = stamp_in_order(table, row);
  recorded.fix.position = map.to_map(point(table, row));
  const double cross = table.number(row, "cov_en_m2");
  recorded.fix.covariance << table.number(row, "cov_ee_m2"), cross, cross, table.number(row, "cov_nn_m2");
  recorded.arrival = table.has("t_arrival") ? table.number(row, "t_arrival") : recorded.fix.stamp;
  return recorded;
}

TruthSample read_truth_sample(const CsvTable& table, std::size_t row, const LocalFrame& map) {
  TruthSample sample;
  sample.stamp = stamp_in_order(table, row);
  const Eigen::Vector2d position = map.to_map(point(table, row));
  sample.has_yaw = table.has("yaw");
  sample.base_in_map = {position.x(), position.y(), sample.has_yaw ? table.number(row, "yaw") : 0.0};
  if (table.has("shadow")) sample.shadow = table.number(row, "shadow") != 0.0;
  return sample;
}

}  // namespace

double Drive::start() const {
  double first = odometry.front().stamp - odometry.front().duration;
  if (!truth.empty()) first = std::min(first, truth.front().stamp);
  return first;
}

std::vector<OdometryIncrement> increments(const std::vector<TwistSample>& samples) {
  std::vector<OdometryIncrement> all;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const TwistSample& a = samples[i == 0 ? 0 : i - 1];
    const TwistSample& b = samples[i];
    const double duration = i == 0 ? kFirstInterval : b.stamp - a.stamp;
    all.push_back({b.stamp, duration, 0.5 * (a.speed + b.speed), 0.5 * (a.yaw_rate + b.yaw_rate)});
  }
  return all;
}

std::optional<TruthSample> truth_at(const std::vector<TruthSample>& truth, double stamp) {
  const auto after = std::lower_bound(truth.begin(), truth.end(), stamp,
                                      [](const TruthSample& sample, double t) { return sample.stamp < t; });
  if (after == truth.end()) return std::nullopt;
  if (after->stamp == stamp) return *after;
  if (after == truth.begin()) return std::nullopt;
  TruthSample sample = *(after - 1);
  const double part = (stamp - sample.stamp) / (after->stamp - sample.stamp);
  const Pose2& from = sample.base_in_map;
  const Pose2& to = after->base_in_map;
  sample.base_in_map = {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                        wrap_angle(from.yaw + part * angle_difference(to.yaw, from.yaw))};
  sample.stamp = stamp;
  sample.has_yaw = sample.has_yaw && after->has_yaw;
  return sample;
}

Eigen::Vector2d antenna_in_map(const TruthSample& truth, const Eigen::Vector2d& antenna_in_base) {
  return truth.has_yaw ? truth.base_in_map * antenna_in_base : truth.base_in_map.position();
}

Drive read_drive(const std::string& directory) {
  const std::filesystem::path folder = directory;
  Drive drive;
  drive.name = (folder / "").parent_path().filename().string();
  drive.odometry = read_odometry(folder / "odometry.csv");

  const CsvTable fixes(folder / "fix.csv",
                       {"t", "lat_deg", "lon_deg", "cov_ee_m2", "cov_en_m2", "cov_nn_m2"});
  if (fixes.rows() == 0) throw DriveError((folder / "fix.csv").string() + ": no fix");
  drive.datum = point(fixes, 0);
  const LocalFrame map(drive.datum);
  for (std::size_t i = 0; i < fixes.rows(); ++i) drive.fixes.push_back(read_fix(fixes, i, map));
  std::stable_sort(drive.fixes.begin(), drive.fixes.end(),
                   [](const RecordedFix& a, const RecordedFix& b) { return a.arrival < b.arrival; });

  const CsvTable truth(folder / "truth.csv", {"t", "lat_deg", "lon_deg"});
  for (std::size_t i = 0; i < truth.rows(); ++i) drive.truth.push_back(read_truth_sample(truth, i, map));
  return drive;
}

}  // namespace multipath_localization
