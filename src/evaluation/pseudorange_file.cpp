#include "evaluation/pseudorange_file.hpp"

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"

namespace multipath_localization {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kLargestNumber = 65535.0;  ///< of a satellite
constexpr double kFurthestRange = 1e10;     ///< clock of the receiver included [m]

int number_of_satellite(const CsvTable& table, std::size_t row) {
  const double number = table.number(row, "sat_id", kLargestNumber);
  if (number < 0.0 || number != std::floor(number)) throw table.error(row, "sat_id is not a whole number");
  return static_cast<int>(number);
}

Eigen::Vector3d position_of_satellite(const CsvTable& table, std::size_t row) {
  const auto coordinate = [&](const char* name) { return table.number(row, name, kHighestOrbit); };
  const Eigen::Vector3d ecef(coordinate("sat_x"), coordinate("sat_y"), coordinate("sat_z"));
  if (ecef.norm() >= kLowestOrbit && ecef.norm() <= kHighestOrbit) return ecef;
  throw table.error(row, "no satellite's orbit is at sat_x, sat_y, sat_z");
}

Eigen::Vector3d velocity_of_satellite(const CsvTable& table, std::size_t row) {
  const auto component = [&](const char* name) { return table.number(row, name, kFastestRangeRate); };
  return {component("sat_vx"), component("sat_vy"), component("sat_vz")};
}

}  // namespace

PseudorangeFile::PseudorangeFile(const std::string& file)
    : table_(file, {"t", "sat_id", "system", "elevation_deg", "cn0_dbhz", "sat_x", "sat_y", "sat_z",
                    "pseudorange_m", "std_m"}) {
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    const double step = row == 0 ? 1.0 : table_.number(row, "t", kLatestTime) - table_.number(row - 1, "t");
    if (step < 0.0) throw table_.error(row, "t decreases");
    if (step > 0.0) begins_.push_back(row);
  }
  begins_.push_back(table_.rows());
}

SatelliteObservation PseudorangeFile::observation(std::size_t row, const LocalFrame& map) const {
  SatelliteObservation observation;
  const auto constellation = constellation_of(table_.text(row, "system"));
  if (!constellation) throw table_.error(row, "unknown system '" + table_.text(row, "system") + "'");
  observation.constellation = *constellation;
  observation.satellite = number_of_satellite(table_, row);
  observation.pseudorange = table_.number(row, "pseudorange_m", kFurthestRange);
  if (!table_.text(row, "cn0_dbhz").empty()) observation.cn0 = table_.number(row, "cn0_dbhz");
  observation.elevation = table_.number(row, "elevation_deg", 90.0) * kDegree;
  observation.sigma = table_.number(row, "std_m");
  if (!(observation.sigma > 0.0)) throw table_.error(row, "std_m is not above 0");
  const Eigen::Vector3d ecef = position_of_satellite(table_, row);
  observation.position = map.satellite_to_map(ecef);
  if (table_.has("range_rate_mps") && !table_.text(row, "range_rate_mps").empty()) {
    observation.range_rate = table_.number(row, "range_rate_mps", kFastestRangeRate);
    observation.velocity = map.satellite_velocity_to_map(ecef, velocity_of_satellite(table_, row));
  }
  return observation;
}

RecordedMeasurement PseudorangeFile::epoch(std::size_t first, std::size_t end, const LocalFrame& map) const {
  PseudorangeEpoch epoch;
  epoch.stamp = table_.number(first, "t");
  for (std::size_t row = first; row < end; ++row) epoch.observations.push_back(observation(row, map));
  return {epoch, table_.has("t_arrival") ? table_.number(first, "t_arrival", kLatestTime) : epoch.stamp};
}

std::vector<RecordedMeasurement> PseudorangeFile::epochs(const LocalFrame& map) const {
  std::vector<RecordedMeasurement> all;
  for (std::size_t i = 0; i + 1 < begins_.size(); ++i) {
    all.push_back(epoch(begins_[i], begins_[i + 1], map));
  }
  return all;
}

Geodetic PseudorangeFile::first_position() const {
  const LocalFrame anywhere(Geodetic{});
  for (std::size_t i = 0; i + 1 < begins_.size(); ++i) {
    const Measurement measurement = epoch(begins_[i], begins_[i + 1], anywhere).measurement;
    const auto position = solve_geodetic(std::get<PseudorangeEpoch>(measurement).observations, anywhere);
    if (position) return *position;
  }
  throw DriveError("no epoch has enough satellites for a position");
}

}  // namespace multipath_localization
