#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "rinex/line_reader.hpp"
#include "rinex/point_positioning.hpp"

namespace multipath_localization {

/// Where a drive comes from; written to `drive.yaml`.
struct DriveSource {
  std::string observations;
  std::vector<std::string> navigation;
  GnssTime start;  ///< t = 0, the first epoch of the observations
  double elevation_mask_deg = 0.0;
  bool ionosphere_removed = false;
};

/// Writes a directory that `evaluate --drive` reads: `pseudoranges.csv` (PseudorangeFile's columns with range
/// rates), `fix.csv` (plain least squares), `robust_fix.csv` (the same columns) and `drive.yaml`. t counts
/// from the start of the source. Columns of the fixes: t, lat_deg, lon_deg, alt_m (over the ellipsoid),
/// cov_ee_m2, cov_en_m2, cov_nn_m2, cov_uu_m2 (formal), num_sat, clock_m (receiver - GPS), isb_glo_m,
/// isb_gal_m, isb_bds_m, isb_qzs_m (what each system's clock is more than GPS's), wrss, dof, status (as of
/// NavSatStatus: 0, and -1, none, where the antenna cannot have been by `on_its_way`); a clock that is not
/// known is blank.
class DriveWriter {
 public:
  /// Makes the directory where there is none. Throws RinexError when one of the files exists, unless
  /// `overwrite`, or cannot be written.
  DriveWriter(const std::string& directory, const DriveSource& source, bool overwrite);

  void add(const CorrectedEpoch& epoch);

  /// Writes the fixes, which are held against each other. Throws RinexError when anything could not be
  /// written.
  void close();

  /// Times of the fixes of `robust_fix.csv`, once it is closed, that have the status -1 [s].
  [[nodiscard]] const std::vector<double>& off_the_way() const { return off_the_way_; }

 private:
  struct Row {
    double t;
    double speed;  ///< by Doppler [m/s]; NaN: not known
    PointFix fix;
  };
  /// Returns the times of those whose status is -1.
  static std::vector<double> write(const std::vector<Row>& rows, std::ostream& out);

  std::string directory_;
  GnssTime start_;
  std::ofstream pseudoranges_;
  std::ofstream plain_;
  std::ofstream robust_;
  std::vector<Row> plain_rows_;
  std::vector<Row> robust_rows_;
  std::vector<double> off_the_way_;
};

}  // namespace multipath_localization
