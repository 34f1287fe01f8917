#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "multipath_localization/core/constellation.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Who tells how far the base has turned.
enum class TurnSource {
  kWheels,  ///< odometry
  kGyro,    ///< an inertial sensor beside it
};

/// Motion that wheel odometry saw over one interval, constant velocity in the base and yaw rate within it.
struct OdometryIncrement {
  double stamp = 0.0;          ///< end of the interval [s]
  double duration = 0.0;       ///< length of the interval [s], > 0
  double speed = 0.0;          ///< along x of the base, negative in reverse [m/s]
  double yaw_rate = 0.0;       ///< counter-clockwise [rad/s]
  double lateral_speed = 0.0;  ///< along y of the base, to the left; 0 but for omnidirectional bases [m/s]
  /// Made of the range rates of epochs, for want of wheels: nothing new to who uses those themselves.
  bool from_range_rates = false;
  TurnSource turn_source = TurnSource::kWheels;  ///< of `yaw_rate`
  /// What the gyro says of a base that stands, whose `yaw_rate` is 0 [rad/s]; NaN: it stands not, or no gyro.
  double rate_at_rest = std::numeric_limits<double>::quiet_NaN();
};

/// What a gyro measured at one instant of the turn about the vertical.
struct YawRate {
  double stamp = 0.0;  ///< [s]
  double rate = 0.0;   ///< counter-clockwise [rad/s]
};

/// Speed over ground, whatever its direction [m/s].
double ground_speed(const OdometryIncrement& increment);

/// Motion of the base over the increment, in the base frame at its start: an arc in chord form, exact and
/// without the singularity of Eq. (3) of [NIS] at zero yaw rate.
Pose2 displacement(const OdometryIncrement& increment);

/// Two increments that follow each other as one of the same duration, way and turn. Its end lies off theirs
/// by no more than the length of the path times the turn.
OdometryIncrement joined(const OdometryIncrement& first, const OdometryIncrement& second);

/// How a receiver says it came to a fix, as sensor_msgs/NavSatStatus has it.
enum class FixStatus {
  kNone = -1,           ///< no fix
  kSingle = 0,          ///< unaugmented, or not told
  kSatelliteBased = 1,  ///< SBAS
  kGroundBased = 2,     ///< differential or RTK
};

/// How well a receiver has solved a fix, by its own word: which of its error laws holds.
enum class FixLevel {
  kUntold,
  kSingle,        ///< without corrections
  kDifferential,  ///< by corrected code
  kFloat,         ///< by carrier phase, ambiguities as they come out
  kFixed,  ///< by carrier phase, ambiguities whole numbers: centimetres, or wrong by decimetres and more
};

/// A position from a GNSS receiver, in the ENU map frame.
struct GnssFix {
  double stamp = 0.0;                                         ///< time of measurement [s]
  Eigen::Vector2d position = Eigen::Vector2d::Zero();         ///< antenna in map: east, north [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();   ///< as declared by the receiver [m^2]
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();  ///< lever arm [m]
  FixStatus status = FixStatus::kSingle;                      ///< as claimed by the receiver
  FixLevel level = FixLevel::kUntold;                         ///< the same, where it tells more
  std::size_t receiver = 0;                                   ///< whose fix it is, where a robot has several
};

/// Two fixes of about one instant, each with its own stamp, from antennas on one base; their lever arms tell
/// which is where, Fig. 1 of [KAM].
struct DualAntennaFix {
  double stamp = 0.0;  ///< the later one's [s]
  GnssFix left;
  GnssFix right;
};

/// What a receiver measured of one satellite.
struct SatelliteObservation {
  Constellation constellation = Constellation::kGps;
  int satellite = 0;         ///< number within the constellation
  double pseudorange = 0.0;  ///< without satellite clock, ionosphere and troposphere, Eq. (3) of [SUZ] [m]
  double range_rate = kUnknown;  ///< by Doppler, without satellite clock drift [m/s]; NaN: not measured
  double cn0 = kUnknown;         ///< carrier to noise density ratio [dB-Hz]; NaN: not told
  double elevation = 0.0;        ///< above the horizon [rad]
  double sigma = 5.0;            ///< of the pseudorange, as declared [m]
  /// Satellite at transmission, in map, the Earth's rotation during the flight undone (LocalFrame), so that
  /// the range is the plain distance: C x of Eq. (4) of [SUZ]. East, north, up [m].
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Constant(kUnknown);  ///< in map [m/s]; NaN: not known

  /// Whether range rate and velocity are there.
  [[nodiscard]] bool has_doppler() const { return std::isfinite(range_rate) && velocity.allFinite(); }

  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
};

/// All that a receiver measured at one instant.
struct PseudorangeEpoch {
  double stamp = 0.0;  ///< time of measurement [s]
  std::vector<SatelliteObservation> observations;
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();  ///< lever arm [m]
};

/// Velocity over ground of a GNSS receiver's antenna by Doppler, in the ENU map frame.
struct GnssVelocity {
  double stamp = 0.0;                                         ///< time of measurement [s]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();         ///< east, north [m/s]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();   ///< as declared by the receiver [m^2/s^2]
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();  ///< lever arm [m]
};

/// Where the base points, by a compass or the baseline of a receiver's two antennas.
struct Heading {
  double stamp = 0.0;     ///< time of measurement [s]
  double yaw = 0.0;       ///< of the base in map, counter-clockwise from east [rad]
  double variance = 0.0;  ///< as declared [rad^2]
  double turn = 0.0;      ///< of the base since the stamp, counter-clockwise [rad]
};

/// What an estimator can be updated with.
using Measurement = std::variant<GnssFix, DualAntennaFix, PseudorangeEpoch, GnssVelocity, Heading>;

/// Index of each kind in Measurement.
constexpr std::size_t kFixKind = 0, kDualKind = 1, kEpochKind = 2, kVelocityKind = 3, kHeadingKind = 4;

double stamp_of(const Measurement& measurement);

/// Where the base was at a stamp [s], in the base of now; nothing where that is not known.
using BaseThen = std::function<std::optional<Pose2>(double stamp)>;

/// The measurement as if its antennas sat on the base of now, the lever arm of each carried back to where it
/// was at its stamp: what was measured then constrains the pose of now. A velocity stays what it was at its
/// stamp, and so does a heading, beside which the turn since then is noted. Nothing where `base_then` knows
/// none.
std::optional<Measurement> carried_back(Measurement measurement, const BaseThen& base_then);

}  // namespace multipath_localization
