#pragma once

#include <Eigen/Core>
#include <GeographicLib/LocalCartesian.hpp>

namespace multipath_localization {

constexpr double kSpeedOfLight = 299792458.0;           ///< [m/s]
constexpr double kEarthRotationRate = 7.2921151467e-5;  ///< [rad/s]
constexpr double kEarthGravitation = 3.986004418e14;    ///< GM [m^3/s^2]

constexpr double kHighestAltitude = 100e3;  ///< of a place, above or below the ellipsoid [m]

/// A point on or above the WGS-84 ellipsoid: degrees north, degrees east, metres.
struct Geodetic {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude = 0.0;
};

/// Of a point in the Earth-centred, Earth-fixed frame [m].
Geodetic to_geodetic(const Eigen::Vector3d& ecef);

/// True when |latitude| <= 90, |longitude| <= 180 and |altitude| <= kHighestAltitude or NaN.
bool valid(const Geodetic& point);

/// The map frame: local tangent plane (east, north, up) at a datum, by GeographicLib. No UTM, no zones.
class LocalFrame {
 public:
  /// Throws std::invalid_argument when the datum is not valid. An altitude of NaN counts as 0.
  explicit LocalFrame(const Geodetic& datum);

  /// East and north of a point [m]. An altitude of NaN is taken as the datum's.
  [[nodiscard]] Eigen::Vector2d to_map(const Geodetic& point) const;

  /// The point that lies at east, north and `up` [m].
  [[nodiscard]] Geodetic to_geodetic(const Eigen::Vector2d& position, double up = 0.0) const;

  /// Where a satellite stood at transmission, from its ECEF position at that moment: east, north, up [m]. The
  /// Earth has turned during the flight of the signal to the datum; that is undone (Sagnac), so that the
  /// range to a receiver is the plain distance. Good to 1 cm of range for each kilometre that the receiver is
  /// away from the datum.
  [[nodiscard]] Eigen::Vector3d satellite_to_map(const Eigen::Vector3d& ecef) const;

  /// The way back: ECEF at transmission [m].
  [[nodiscard]] Eigen::Vector3d satellite_to_ecef(const Eigen::Vector3d& in_map) const;

  /// How that position in map moves [m/s], by the satellite's ECEF position and velocity at transmission. The
  /// rotation is undone in it too: a velocity that is only turned to the map's axes would be off by up to
  /// 1 cm/s along the line of sight.
  [[nodiscard]] Eigen::Vector3d satellite_velocity_to_map(const Eigen::Vector3d& ecef,
                                                          const Eigen::Vector3d& velocity) const {
    return satellite_to_map(ecef + velocity) - satellite_to_map(ecef);
  }

  /// The way back: ECEF at transmission [m/s], by position and velocity in map.
  [[nodiscard]] Eigen::Vector3d satellite_velocity_to_ecef(const Eigen::Vector3d& in_map,
                                                           const Eigen::Vector3d& velocity) const {
    return satellite_to_ecef(in_map + velocity) - satellite_to_ecef(in_map);
  }

  /// A vector's components, ECEF to east, north, up.
  [[nodiscard]] Eigen::Vector3d vector_to_map(const Eigen::Vector3d& ecef) const {
    return ecef_by_map_.transpose() * ecef;
  }

  /// A vector's components, east, north, up to ECEF.
  [[nodiscard]] Eigen::Vector3d vector_to_ecef(const Eigen::Vector3d& in_map) const {
    return ecef_by_map_ * in_map;
  }

  [[nodiscard]] const Geodetic& datum() const { return datum_; }
  [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; }  ///< the datum in ECEF [m]

 private:
  Geodetic datum_;
  Eigen::Vector3d origin_;
  Eigen::Matrix3d ecef_by_map_;  ///< turns vectors
  GeographicLib::LocalCartesian cartesian_;
};

}  // namespace multipath_localization
