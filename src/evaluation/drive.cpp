#include "evaluation/drive.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "evaluation/doppler_odometry.hpp"
#include "evaluation/fix_claims.hpp"
#include "evaluation/pseudorange_file.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/twist_sample.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kFastest = 1e3;       ///< that wheels say [m/s], [rad/s]
constexpr double kMostTurned = 1e6;    ///< that a yaw says [rad]
constexpr double kLongestArm = 100.0;  ///< of an antenna on a base [m]
const std::vector<std::string> kFixColumns = {"t",         "lat_deg",   "lon_deg",
                                              "cov_ee_m2", "cov_en_m2", "cov_nn_m2"};

double stamp_in_order(const CsvTable& table, std::size_t row) {
  const double stamp = table.number(row, "t", kLatestTime);
  if (row > 0 && stamp <= table.number(row - 1, "t")) throw table.error(row, "t does not increase");
  return stamp;
}

Geodetic point(const CsvTable& table, std::size_t row) {
  const Geodetic point{table.number(row, "lat_deg"), table.number(row, "lon_deg"),
                       table.has("alt_m") ? table.number(row, "alt_m") : 0.0};
  if (!valid(point)) throw table.error(row, "latitude, longitude or altitude out of range");
  return point;
}

/// How long the motion of a row lasted, where the file tells.
std::optional<double> told_duration(const CsvTable& table, std::size_t row) {
  if (!table.has("duration")) return std::nullopt;
  const double duration = table.number(row, "duration", kLatestTime);
  if (duration <= 0.0) throw table.error(row, "duration is not above 0");
  return duration;
}

std::vector<OdometryIncrement> read_odometry(const std::string& file) {
  const CsvTable table(file, {"t", "vx", "wz"});
  if (table.rows() < 2) throw DriveError(file + ": fewer than two rows");
  std::vector<OdometryIncrement> increments;
  TwistSample before;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const TwistSample now{stamp_in_order(table, i), table.number(i, "vx", kFastest),
                          table.number(i, "wz", kFastest),
                          table.has("vy") ? table.number(i, "vy", kFastest) : 0.0};
    if (const std::optional<double> duration = told_duration(table, i)) {
      increments.push_back(motion_of(now, *duration));
    } else {
      increments.push_back(i == 0 ? motion_of(now, kFirstInterval) : motion_between(before, now));
    }
    before = now;
  }
  return increments;
}

/// The motion by Doppler of a drive without wheel odometry.
std::vector<OdometryIncrement> odometry_by_doppler(const std::vector<RecordedMeasurement>& epochs,
                                                   const std::string& directory,
                                                   std::vector<std::string>& notices) {
  std::vector<PseudorangeEpoch> plain;
  plain.reserve(epochs.size());
  for (const RecordedMeasurement& epoch : epochs)
    plain.push_back(std::get<PseudorangeEpoch>(epoch.measurement));
  const DopplerTrack track = doppler_track(plain);
  if (track.samples.size() < 2)
    throw DriveError(directory + ": neither odometry.csv nor velocity by Doppler");
  notices.emplace_back("no odometry.csv, motion is by Doppler velocity");
  if (track.held > 0) {
    notices.push_back("of " + std::to_string(track.samples.size()) + " epochs " + std::to_string(track.held) +
                      " have no Doppler velocity: the last one is held, for " +
                      std::to_string(std::lround(track.longest_hold)) + " s at the longest");
  }
  return odometry_of(track.samples);
}

double arrival_of(const CsvTable& table, std::size_t row) {
  return table.number(row, table.has("t_arrival") ? "t_arrival" : "t", kLatestTime);
}

/// Lever arm, at the base where the file does not tell.
Eigen::Vector2d antenna_of(const CsvTable& table, std::size_t row) {
  if (!table.has("antenna_x_m")) return Eigen::Vector2d::Zero();
  return {table.number(row, "antenna_x_m", kLongestArm), table.number(row, "antenna_y_m", kLongestArm)};
}

RecordedMeasurement read_fix(const CsvTable& table, std::size_t row, std::size_t receiver,
                             const LocalFrame& map) {
  GnssFix fix;
  fix.receiver = receiver;
  fix.antenna_in_base = antenna_of(table, row);
  fix.stamp = stamp_in_order(table, row);
  fix.position = map.to_map(point(table, row));
  const double east = table.number(row, "cov_ee_m2");
  const double cross = table.number(row, "cov_en_m2");
  const double north = table.number(row, "cov_nn_m2");
  fix.covariance << east, cross, cross, north;
  fix.status = status_of(table, row);
  fix.level = level_of(table, row);
  return {fix, arrival_of(table, row)};
}

/// Empty where there is no such file.
std::vector<RecordedYawRate> read_yaw_rates(const std::string& file) {
  if (!std::filesystem::exists(file)) return {};
  const CsvTable table(file, {"t", "yaw_rate_radps"});
  std::vector<RecordedYawRate> all;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const YawRate yaw_rate{stamp_in_order(table, i), table.number(i, "yaw_rate_radps", kFastest)};
    all.push_back({yaw_rate, arrival_of(table, i)});
  }
  sort_by_arrival(all);
  return all;
}

/// None where there is no such file.
void read_velocities(const std::string& file, std::vector<RecordedMeasurement>& measurements) {
  if (!std::filesystem::exists(file)) return;
  const CsvTable table(file, {"t", "east_mps", "north_mps", "sigma_mps"});
  for (std::size_t i = 0; i < table.rows(); ++i) {
    GnssVelocity velocity;
    velocity.stamp = stamp_in_order(table, i);
    velocity.velocity = {table.number(i, "east_mps", kFastest), table.number(i, "north_mps", kFastest)};
    velocity.covariance = square(table.number(i, "sigma_mps", kFastest)) * Eigen::Matrix2d::Identity();
    measurements.push_back({velocity, arrival_of(table, i)});
  }
}

/// None where there is no such file.
void read_headings(const std::string& file, std::vector<RecordedMeasurement>& measurements) {
  if (!std::filesystem::exists(file)) return;
  const CsvTable table(file, {"t", "yaw_rad", "sigma_rad"});
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const Heading heading{stamp_in_order(table, i), wrap_angle(table.number(i, "yaw_rad", kMostTurned)),
                          square(table.number(i, "sigma_rad", kFastest))};
    measurements.push_back({heading, arrival_of(table, i)});
  }
}

/// The rows of a table that are fixes: all but those that say they are none.
std::vector<std::size_t> rows_of_fixes(const CsvTable& table) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (status_of(table, i) != FixStatus::kNone) rows.push_back(i);
  }
  return rows;
}

TruthSample read_truth_sample(const CsvTable& table, std::size_t row, const LocalFrame& map) {
  TruthSample sample;
  sample.stamp = stamp_in_order(table, row);
  const Eigen::Vector2d position = map.to_map(point(table, row));
  sample.has_yaw = table.has("yaw");
  sample.base_in_map = {position.x(), position.y(),
                        sample.has_yaw ? table.number(row, "yaw", kMostTurned) : 0.0};
  if (table.has("shadow")) sample.shadow = table.number(row, "shadow") != 0.0;
  if (table.has("wheel_fault")) sample.wheel_fault = table.number(row, "wheel_fault") != 0.0;
  return sample;
}

/// Empty where there is no such file.
std::vector<TruthSample> read_truth(const std::string& file, const LocalFrame& map) {
  if (!std::filesystem::exists(file)) return {};
  const CsvTable table(file, {"t", "lat_deg", "lon_deg"});
  std::vector<TruthSample> truth;
  for (std::size_t i = 0; i < table.rows(); ++i) truth.push_back(read_truth_sample(table, i, map));
  return truth;
}

}  // namespace

std::string fix_file_of(std::size_t receiver) {
  return receiver == 0 ? "fix.csv" : "fix_" + std::to_string(receiver + 1) + ".csv";
}

double Drive::start() const {
  double first = odometry.front().stamp - odometry.front().duration;
  if (!truth.empty()) first = std::min(first, truth.front().stamp);
  return first;
}

std::vector<GnssFix> Drive::fixes(std::size_t receiver) const {
  std::vector<GnssFix> all;
  for (const RecordedMeasurement& recorded : measurements) {
    const auto* fix = std::get_if<GnssFix>(&recorded.measurement);
    if (fix != nullptr && fix->receiver == receiver) all.push_back(*fix);
    const auto* two = std::get_if<DualAntennaFix>(&recorded.measurement);
    if (two != nullptr && receiver == 0) all.insert(all.end(), {two->left, two->right});
  }
  return all;
}

std::size_t Drive::receivers() const {
  std::size_t count = 0;
  for (const RecordedMeasurement& recorded : measurements) {
    if (const auto* fix = std::get_if<GnssFix>(&recorded.measurement)) {
      count = std::max(count, fix->receiver + 1);
    }
  }
  return count;
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

namespace {

/// The fixes of one receiver.
struct FixFile {
  FixFile(const std::filesystem::path& path, std::size_t number)
      : name(path.filename().string()), receiver(number), table(path.string(), kFixColumns) {
    rows = rows_of_fixes(table);
    if (rows.empty()) throw DriveError(path.string() + ": no fix");
  }

  void read(const LocalFrame& map, Drive& drive) const {
    for (const std::size_t row : rows) drive.measurements.push_back(read_fix(table, row, receiver, map));
    if (rows.size() == table.rows()) return;
    drive.notices.push_back(name + ": " + std::to_string(table.rows() - rows.size()) +
                            " rows refused: " + std::string(to_string(Reason::kNoFix)));
  }

  std::string name;
  std::size_t receiver;
  CsvTable table;
  std::vector<std::size_t> rows;  ///< those that are fixes
};

/// `fix.csv`, `fix_2.csv`, ... as far as they go on.
std::vector<FixFile> fix_files(const std::filesystem::path& folder) {
  std::vector<FixFile> files;
  for (std::size_t receiver = 0; exists(folder / fix_file_of(receiver)); ++receiver) {
    files.emplace_back(folder / fix_file_of(receiver), receiver);
  }
  return files;
}

}  // namespace

Drive read_drive(const std::string& directory) {
  const std::filesystem::path folder = directory;
  Drive drive;
  drive.name = (folder / "").parent_path().filename().string();

  const std::vector<FixFile> fixes = fix_files(folder);
  std::optional<PseudorangeFile> pseudoranges;
  if (exists(folder / "pseudoranges.csv")) pseudoranges.emplace(folder / "pseudoranges.csv");
  if (fixes.empty() && !pseudoranges) throw DriveError(directory + ": neither fix.csv nor pseudoranges.csv");
  drive.datum =
      fixes.empty() ? pseudoranges->first_position() : point(fixes.front().table, fixes.front().rows.front());
  const LocalFrame map(drive.datum);
  const auto epochs = pseudoranges ? pseudoranges->epochs(map) : std::vector<RecordedMeasurement>();
  drive.odometry = exists(folder / "odometry.csv") ? read_odometry(folder / "odometry.csv")
                                                   : odometry_by_doppler(epochs, directory, drive.notices);
  for (const FixFile& file : fixes) file.read(map, drive);
  drive.measurements.insert(drive.measurements.end(), epochs.begin(), epochs.end());
  read_velocities(folder / "velocity.csv", drive.measurements);
  read_headings(folder / "heading.csv", drive.measurements);
  sort_by_arrival(drive.measurements);
  drive.yaw_rates = read_yaw_rates(folder / "gyro.csv");

  drive.truth = read_truth(folder / "truth.csv", map);
  if (drive.truth.empty()) drive.notices.emplace_back("no truth, nothing is scored");
  return drive;
}

}  // namespace multipath_localization
