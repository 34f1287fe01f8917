#pragma once

#include <Eigen/Core>
#include <GeographicLib/LocalCartesian.hpp>

namespace multipath_localization {

/// A point on or above the WGS-84 ellipsoid: degrees north, degrees east, metres.
struct Geodetic {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude = 0.0;
};

/// True when the coordinates are finite and |latitude| <= 90, |longitude| <= 180. Altitude may be NaN.
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

  [[nodiscard]] const Geodetic& datum() const { return datum_; }

 private:
  Geodetic datum_;
  GeographicLib::LocalCartesian cartesian_;
};

}  // namespace multipath_localization
