#include "multipath_localization/core/geodesy.hpp"

#include <Eigen/Geometry>
#include <GeographicLib/Geocentric.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace multipath_localization {

namespace {

Geodetic checked(Geodetic datum) {
  if (!valid(datum))
    throw std::invalid_argument(
        "datum is not a latitude and longitude in degrees and an altitude within 100 km");
  if (!std::isfinite(datum.altitude)) datum.altitude = 0.0;
  return datum;
}

/// Turns a vector with the Earth during the flight of a signal over `range` [m].
Eigen::Vector3d turned_with_earth(const Eigen::Vector3d& ecef, double range) {
  const double angle = kEarthRotationRate * range / kSpeedOfLight;
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * ecef;
}

}  // namespace

Geodetic to_geodetic(const Eigen::Vector3d& ecef) {
  Geodetic point;
  GeographicLib::Geocentric::WGS84().Reverse(ecef.x(), ecef.y(), ecef.z(), point.latitude_deg,
                                             point.longitude_deg, point.altitude);
  return point;
}

bool valid(const Geodetic& point) {
  return std::abs(point.latitude_deg) <= 90.0 && std::abs(point.longitude_deg) <= 180.0 &&
         !(std::abs(point.altitude) > kHighestAltitude);
}

LocalFrame::LocalFrame(const Geodetic& datum)
    : datum_(checked(datum)), cartesian_(datum_.latitude_deg, datum_.longitude_deg, datum_.altitude) {
  std::vector<double> turn(9);
  GeographicLib::Geocentric::WGS84().Forward(datum_.latitude_deg, datum_.longitude_deg, datum_.altitude,
                                             origin_.x(), origin_.y(), origin_.z(), turn);
  ecef_by_map_ = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(turn.data());
}

Eigen::Vector2d LocalFrame::to_map(const Geodetic& point) const {
  const double altitude = std::isfinite(point.altitude) ? point.altitude : datum_.altitude;
  double east = 0.0;
  double north = 0.0;
  double up = 0.0;
  cartesian_.Forward(point.latitude_deg, point.longitude_deg, altitude, east, north, up);
  return {east, north};
}

Geodetic LocalFrame::to_geodetic(const Eigen::Vector2d& position, double up) const {
  Geodetic point;
  cartesian_.Reverse(position.x(), position.y(), up, point.latitude_deg, point.longitude_deg, point.altitude);
  return point;
}

Eigen::Vector3d LocalFrame::satellite_to_map(const Eigen::Vector3d& ecef) const {
  // Turning changes the range, by metres; and those turn by nothing that counts.
  const double range = (turned_with_earth(ecef, -(ecef - origin_).norm()) - origin_).norm();
  return vector_to_map(turned_with_earth(ecef, -range) - origin_);
}

Eigen::Vector3d LocalFrame::satellite_to_ecef(const Eigen::Vector3d& in_map) const {
  return turned_with_earth(vector_to_ecef(in_map) + origin_, in_map.norm());
}

}  // namespace multipath_localization
