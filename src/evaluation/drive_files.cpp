#include "evaluation/drive_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <locale>
#include <optional>
#include <vector>

#include "multipath_localization/core/covariance.hpp"

namespace multipath_localization {

namespace {

namespace fs = std::filesystem;

/// A file that takes numbers without loss.
class CsvFile {
 public:
  CsvFile(const fs::path& file, const std::string& header) : file_(file), out_(file) {
    out_.imbue(std::locale::classic());
    out_ << std::setprecision(17) << header << "\n";
  }

  template <class... Numbers>
  void row(double first, const Numbers&... others) {
    out_ << first;
    ((out_ << ',' << others), ...);
    out_ << "\n";
  }

  void row(double first, const std::vector<double>& others) {
    out_ << first;
    for (const double other : others) out_ << ',' << other;
    out_ << "\n";
  }

  void close() {
    if (!out_.flush()) throw DriveError("cannot write " + file_.string());
  }

 private:
  fs::path file_;
  std::ofstream out_;
};

void write_odometry(const Drive& drive, const fs::path& folder) {
  CsvFile file(folder / "odometry.csv", "t,vx,wz,vy,duration");
  for (const OdometryIncrement& u : drive.odometry) {
    file.row(u.stamp, u.speed, u.yaw_rate, u.lateral_speed, u.duration);
  }
  file.close();
}

void write_fixes(const Drive& drive, std::size_t receiver, const LocalFrame& map, const fs::path& folder) {
  CsvFile file(folder / fix_file_of(receiver),
               "t,lat_deg,lon_deg,cov_ee_m2,cov_en_m2,cov_nn_m2,status,level,antenna_x_m,antenna_y_m");
  for (const GnssFix& fix : drive.fixes(receiver)) {
    const Geodetic point = map.to_geodetic(fix.position);
    const Eigen::Matrix2d& covariance = fix.covariance;
    file.row(fix.stamp, point.latitude_deg, point.longitude_deg, covariance(0, 0), covariance(0, 1),
             covariance(1, 1), static_cast<int>(fix.status), static_cast<int>(fix.level),
             fix.antenna_in_base.x(), fix.antenna_in_base.y());
  }
  file.close();
}

/// A column of truth, where the recording has it.
void add_flag(const std::optional<bool>& told, const std::optional<bool>& flag, std::vector<double>& row) {
  if (told) row.push_back(flag.value_or(false) ? 1.0 : 0.0);
}

void write_truth(const Drive& drive, const LocalFrame& map, const fs::path& folder) {
  const TruthSample first = drive.truth.empty() ? TruthSample() : drive.truth.front();
  std::string header = "t,lat_deg,lon_deg,yaw";
  if (first.shadow) header += ",shadow";
  if (first.wheel_fault) header += ",wheel_fault";
  CsvFile file(folder / "truth.csv", header);
  for (const TruthSample& sample : drive.truth) {
    const Geodetic point = map.to_geodetic(sample.base_in_map.position());
    std::vector<double> row = {point.latitude_deg, point.longitude_deg, sample.base_in_map.yaw};
    add_flag(first.shadow, sample.shadow, row);
    add_flag(first.wheel_fault, sample.wheel_fault, row);
    file.row(sample.stamp, row);
  }
  file.close();
}

void write_yaw_rates(const Drive& drive, const fs::path& folder) {
  if (drive.yaw_rates.empty()) return;
  CsvFile file(folder / "gyro.csv", "t,yaw_rate_radps,t_arrival");
  for (const auto& [yaw_rate, arrival] : drive.yaw_rates) file.row(yaw_rate.stamp, yaw_rate.rate, arrival);
  file.close();
}

/// Writes measurements of one kind, where there are any; `write_row` writes one with its time of arrival.
template <class Kind, class WriteRow>
void write_kind(const Drive& drive, const fs::path& path, const std::string& header, WriteRow write_row) {
  std::optional<CsvFile> file;
  for (const auto& [measurement, arrival] : drive.measurements) {
    const auto* made = std::get_if<Kind>(&measurement);
    if (made == nullptr) continue;
    if (!file) file.emplace(path, header);
    write_row(*file, *made, arrival);
  }
  if (file) file->close();
}

void write_velocities(const Drive& drive, const fs::path& folder) {
  write_kind<GnssVelocity>(drive, folder / "velocity.csv", "t,east_mps,north_mps,sigma_mps,t_arrival",
                           [](CsvFile& file, const GnssVelocity& made, double arrival) {
                             file.row(made.stamp, made.velocity.x(), made.velocity.y(),
                                      mean_sigma(made.covariance), arrival);
                           });
}

void write_headings(const Drive& drive, const fs::path& folder) {
  write_kind<Heading>(drive, folder / "heading.csv", "t,yaw_rad,sigma_rad,t_arrival",
                      [](CsvFile& file, const Heading& made, double arrival) {
                        file.row(made.stamp, made.yaw, std::sqrt(made.variance), arrival);
                      });
}

/// Why a directory is no drive to be run, or nothing.
std::string what_is_missing(const fs::path& folder) {
  for (const char* file : {"truth.csv", "fix.csv", "odometry.csv"}) {
    if (!exists(folder / file)) return std::string("no ") + file;
  }
  return "";
}

Drive without_epochs(Drive drive) {
  const auto is_epoch = [](const RecordedMeasurement& recorded) {
    return std::holds_alternative<PseudorangeEpoch>(recorded.measurement);
  };
  drive.measurements.erase(std::remove_if(drive.measurements.begin(), drive.measurements.end(), is_epoch),
                           drive.measurements.end());
  return drive;
}

}  // namespace

void write_drive(const Drive& drive, const std::string& directory) {
  const fs::path folder = directory;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw DriveError("cannot make " + directory + ": " + failed.message());
  const LocalFrame map(drive.datum);
  write_odometry(drive, folder);
  write_fixes(drive, 0, map, folder);
  for (std::size_t k = 1; k < drive.receivers(); ++k) write_fixes(drive, k, map, folder);
  write_truth(drive, map, folder);
  write_yaw_rates(drive, folder);
  write_velocities(drive, folder);
  write_headings(drive, folder);
}

namespace {

/// Adds the drive of a folder, or why it is none.
void add_drive(const fs::path& folder, double score_from, FoundDrives& found) {
  std::string reason = what_is_missing(folder);
  try {
    if (reason.empty()) {
      Drive drive = without_epochs(read_drive(folder.string()));
      if (drive.truth.back().stamp > drive.start() + score_from) {
        found.drives.push_back(std::move(drive));
        return;
      }
      reason = "ends before what is scored";
    }
  } catch (const DriveError& error) {
    reason = error.what();
  }
  found.left_out.push_back(folder.filename().string() + ": " + reason);
}

}  // namespace

FoundDrives read_drives(const std::string& directory, double score_from) {
  if (!fs::is_directory(directory)) throw DriveError(directory + " is not a directory");
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  FoundDrives found;
  for (const fs::path& folder : folders) add_drive(folder, score_from, found);
  if (found.drives.empty()) throw DriveError(directory + ": no drive in it");
  return found;
}

}  // namespace multipath_localization
