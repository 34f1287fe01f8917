#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/reason_tally.hpp"
#include "support/csv.hpp"

namespace multipath_localization {

/// A measurement and when it came in.
struct RecordedMeasurement {
  Measurement measurement;
  double arrival = 0.0;  ///< on the clock of the stamps [s]
};

/// A yaw rate of a gyro beside the odometry and when it came in.
struct RecordedYawRate {
  YawRate yaw_rate;
  double arrival = 0.0;  ///< on the clock of the stamps [s]
};

/// Sorts what was recorded; what came in at one time keeps its order.
template <class Recorded>
void sort_by_arrival(std::vector<Recorded>& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Recorded& a, const Recorded& b) { return a.arrival < b.arrival; });
}

/// Where the base truly was. For scoring only.
struct TruthSample {
  double stamp = 0.0;  ///< [s]
  Pose2 base_in_map;   ///< yaw counts only when `has_yaw`
  bool has_yaw = false;
  std::optional<bool> shadow;  ///< whether fixes are biased here, where the recording says so
  std::optional<bool> wheel_fault = std::nullopt;  ///< whether the wheels slip, lock or say nothing, likewise
};

/// A recording: what a robot's sensors said and where it truly was, in one ENU map frame.
struct Drive {
  std::string name;
  Geodetic datum;                                 ///< origin of the map frame
  std::vector<OdometryIncrement> odometry;        ///< by stamp
  std::vector<RecordedYawRate> yaw_rates;         ///< by arrival; empty where there is no gyro
  std::vector<RecordedMeasurement> measurements;  ///< by arrival
  std::vector<TruthSample> truth;                 ///< by stamp; empty when there is none
  std::vector<std::string> notices;               ///< what the reader had to assume or to leave out
  /// Stamps of odometry that came after one was missed for so long that the localization starts afresh [s].
  std::vector<double> restarts;
  std::array<ReasonTally, std::variant_size_v<Measurement>> left_out;  ///< measurements, by kind

  /// Stamp of the first thing recorded, from which times are counted [s].
  [[nodiscard]] double start() const;

  /// The fixes of a receiver among the measurements, of the first one also those of two antennas one by one,
  /// in their order.
  [[nodiscard]] std::vector<GnssFix> fixes(std::size_t receiver = 0) const;
  /// How many receivers there are fixes of, by the highest number.
  [[nodiscard]] std::size_t receivers() const;
};

/// Truth at `stamp`, linear between its neighbours, with the shadow flag of the earlier one. Nothing outside
/// the truth's span.
std::optional<TruthSample> truth_at(const std::vector<TruthSample>& truth, double stamp);

/// Where an antenna truly was, or the base itself where truth has no heading [m].
Eigen::Vector2d antenna_in_map(const TruthSample& truth, const Eigen::Vector2d& antenna_in_base);

/// Name of the file of a drive directory that has the fixes of a receiver: "fix.csv", "fix_2.csv", ...
std::string fix_file_of(std::size_t receiver);

/// Reads `odometry.csv` (t, vx, wz; optional vy, duration), `truth.csv` (t, lat_deg, lon_deg; optional alt_m,
/// yaw, shadow, wheel_fault) and `fix.csv` (t, lat_deg, lon_deg, cov_ee_m2, cov_en_m2, cov_nn_m2; optional
/// alt_m, t_arrival, status as of NavSatStatus, whose -1 is refused as no fix, level as of FixLevel,
/// antenna_x_m with antenna_y_m, the lever arm) with the like `fix_2.csv`, `fix_3.csv`, ... of further
/// receivers, or `pseudoranges.csv` (PseudorangeFile) or both of a directory, and where they are there
/// `gyro.csv` (t, yaw_rate_radps; optional t_arrival), `velocity.csv` (t, east_mps, north_mps, sigma_mps;
/// optional t_arrival) of the antenna and `heading.csv` (t, yaw_rad, sigma_rad; optional t_arrival) of the
/// base; other columns are left alone. Times are seconds up to kLatestTime, wheels turn at up to 1e3 m/s and
/// rad/s. The motion between two rows is `motion_between` them, and the first row stands for kFirstInterval;
/// with a `duration` [s] a row is the mean over it, up to t. The map's datum is the first fix, without fixes
/// the solution of the first epoch: truth decides nothing but the score, and without `truth.csv` there is
/// none. Without `odometry.csv` the motion is that by the Doppler shifts of `pseudoranges.csv`
/// (doppler_odometry.hpp). The drive's notices say so. Throws DriveError.
Drive read_drive(const std::string& directory);

}  // namespace multipath_localization
