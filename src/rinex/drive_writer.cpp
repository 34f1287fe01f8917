#include "rinex/drive_writer.hpp"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/pseudorange/doppler_velocity.hpp"
#include "rinex/fix_chain.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::array<const char*, 4> kFiles = {"pseudoranges.csv", "fix.csv", "robust_fix.csv", "drive.yaml"};
constexpr std::string_view kPseudorangeColumns =
    "t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m,range_rate_mps,"
    "sat_vx,sat_vy,sat_vz\n";
constexpr std::string_view kFixColumns =
    "t,lat_deg,lon_deg,alt_m,cov_ee_m2,cov_en_m2,cov_nn_m2,cov_uu_m2,num_sat,clock_m,isb_glo_m,isb_gal_m,"
    "isb_bds_m,isb_qzs_m,wrss,dof,status\n";

std::string known_number(double value, int digits) {
  return std::isfinite(value) ? fixed_text(value, digits) : "";
}

void write_vector(std::ostream& out, const Eigen::Vector3d& vector, int digits) {
  out << "," << fixed_text(vector.x(), digits) << "," << fixed_text(vector.y(), digits) << ","
      << fixed_text(vector.z(), digits);
}

void write_satellite(std::ostream& out, double t, const TrackedSatellite& tracked,
                     const SatelliteObservation& seen) {
  out << fixed_text(t, 7) << "," << seen.satellite << "," << to_string(seen.constellation) << ","
      << fixed_text(seen.elevation * 180.0 / kPi, 4) << "," << known_number(seen.cn0, 3);
  write_vector(out, tracked.at_transmission.position, 4);
  out << "," << fixed_text(seen.pseudorange, 4) << "," << fixed_text(seen.sigma, 3);
  if (seen.has_doppler()) {
    out << "," << fixed_text(seen.range_rate, 5);
    write_vector(out, tracked.at_transmission.velocity, 6);
  } else {
    out << ",,,,";
  }
  out << "\n";
}

void write_fix(std::ostream& out, double t, const PointFix& fix, int status) {
  const PseudorangeSolution& solution = fix.solution;
  const Eigen::Matrix3d& P = solution.covariance;
  out << fixed_text(t, 7) << "," << fixed_text(fix.antenna.latitude_deg, 9) << ","
      << fixed_text(fix.antenna.longitude_deg, 9) << "," << fixed_text(fix.antenna.altitude, 4);
  for (const double variance : {P(0, 0), P(0, 1), P(1, 1), P(2, 2)}) out << "," << plain_text(variance);
  const auto clock = [&](Constellation of) { return solution.clock.at(static_cast<std::size_t>(of)); };
  const double gps = clock(Constellation::kGps);
  out << "," << solution.used << "," << known_number(gps, 4);
  for (const Constellation other :
       {Constellation::kGlonass, Constellation::kGalileo, Constellation::kBeidou, Constellation::kQzss}) {
    out << "," << known_number(clock(other) - gps, 4);
  }
  out << "," << plain_text(solution.weighted_square_sum) << "," << solution.degrees_of_freedom << ","
      << status << "\n";
}

std::string description(const DriveSource& source) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "gps_week" << YAML::Value << std::to_string(source.start.week);
  yaml << YAML::Key << "seconds_of_week" << YAML::Value << fixed_text(source.start.second, 7)
       << YAML::Comment("GPS time of t = 0");
  yaml << YAML::Key << "observations" << YAML::Value << source.observations;
  yaml << YAML::Key << "navigation" << YAML::Value << YAML::Flow << source.navigation;
  yaml << YAML::Key << "elevation_mask_deg" << YAML::Value << plain_text(source.elevation_mask_deg);
  yaml << YAML::Key << "ionosphere" << YAML::Value << (source.ionosphere_removed ? "klobuchar" : "none");
  yaml << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace

DriveWriter::DriveWriter(const std::string& directory, const DriveSource& source, bool overwrite)
    : directory_(directory), start_(source.start) {
  const std::filesystem::path folder = directory;
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  for (const char* file : kFiles) {
    if (!overwrite && std::filesystem::exists(folder / file, failure)) {
      throw RinexError((folder / file).string() + " exists already");
    }
  }
  pseudoranges_.open(folder / "pseudoranges.csv");
  plain_.open(folder / "fix.csv");
  robust_.open(folder / "robust_fix.csv");
  std::ofstream yaml(folder / "drive.yaml");
  for (std::ofstream* file : {&pseudoranges_, &plain_, &robust_}) file->imbue(std::locale::classic());
  pseudoranges_ << kPseudorangeColumns;
  plain_ << kFixColumns;
  robust_ << kFixColumns;
  yaml << description(source);
  if (!pseudoranges_ || !plain_ || !robust_ || !yaml.flush())
    throw RinexError(directory + ": cannot be written");
}

void DriveWriter::add(const CorrectedEpoch& epoch) {
  const double t = epoch.time - start_;
  for (std::size_t i = 0; i < epoch.satellites.size(); ++i) {
    write_satellite(pseudoranges_, t, epoch.satellites[i], epoch.observations[i]);
  }
  if (!epoch.plain && !epoch.robust) return;
  const PointFix& best = epoch.robust ? *epoch.robust : *epoch.plain;
  const auto velocity = doppler_velocity(epoch.observations, best.solution.position);
  const double speed = velocity ? velocity->velocity.norm() : SatelliteObservation::kUnknown;
  if (epoch.plain) plain_rows_.push_back({t, speed, *epoch.plain});
  if (epoch.robust) robust_rows_.push_back({t, speed, *epoch.robust});
}

std::vector<double> DriveWriter::write(const std::vector<Row>& rows, std::ostream& out) {
  std::vector<ChainLink> links;
  links.reserve(rows.size());
  for (const Row& row : rows) {
    links.push_back(
        {row.t, LocalFrame(row.fix.antenna).origin(), row.speed, row.fix.solution.degrees_of_freedom});
  }
  const std::vector<bool> on_it = on_its_way(links);
  std::vector<double> off;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    write_fix(out, rows[i].t, rows[i].fix, on_it[i] ? 0 : -1);
    if (!on_it[i]) off.push_back(rows[i].t);
  }
  return off;
}

void DriveWriter::close() {
  write(plain_rows_, plain_);
  off_the_way_ = write(robust_rows_, robust_);
  for (std::ofstream* file : {&pseudoranges_, &plain_, &robust_}) file->close();
  if (!pseudoranges_ || !plain_ || !robust_)
    throw RinexError(directory_ + ": could not be written to its end");
}

}  // namespace multipath_localization
