#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/drive.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "support/csv.hpp"

namespace multipath_localization {

/// The raw measurements of a drive: one line per satellite and epoch, with columns t, sat_id, system (a
/// Constellation's name), elevation_deg, cn0_dbhz, sat_x, sat_y, sat_z (ECEF at transmission, the Earth's
/// rotation not undone), pseudorange_m, std_m; optional range_rate_mps with sat_vx, sat_vy, sat_vz (ECEF),
/// and t_arrival. A blank cn0_dbhz or range_rate_mps is one that was not measured. Epochs are lines of equal
/// t. Refused are satellites that are not 1e7 to 1e8 m from the Earth's centre, ranges over 1e10 m and rates
/// over 1e5 m/s.
class PseudorangeFile {
 public:
  /// Throws DriveError.
  explicit PseudorangeFile(const std::string& file);

  /// Where the plain least-squares solution of the first epoch that has one puts the antenna. Throws
  /// DriveError when none has.
  [[nodiscard]] Geodetic first_position() const;

  /// All epochs with the satellites in `map`, in the order of the file. Throws DriveError.
  [[nodiscard]] std::vector<RecordedMeasurement> epochs(const LocalFrame& map) const;

 private:
  [[nodiscard]] RecordedMeasurement epoch(std::size_t first, std::size_t end, const LocalFrame& map) const;
  [[nodiscard]] SatelliteObservation observation(std::size_t row, const LocalFrame& map) const;

  CsvTable table_;
  std::vector<std::size_t> begins_;  ///< first rows of the epochs, and the number of rows
};

}  // namespace multipath_localization
