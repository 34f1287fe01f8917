#include "multipath_localization/core/geodesy.hpp"

#include <cmath>
#include <stdexcept>

namespace multipath_localization {

namespace {

Geodetic checked(Geodetic datum) {
  if (!valid(datum)) throw std::invalid_argument("datum is not a latitude and longitude in degrees");
  if (!std::isfinite(datum.altitude)) datum.altitude = 0.0;
  return datum;
}

}  // namespace

bool valid(const Geodetic& point) {
  return std::abs(point.latitude_deg) <= 90.0 && std::abs(point.longitude_deg) <= 180.0;
}

LocalFrame::LocalFrame(const Geodetic& datum)
    : datum_(checked(datum)), cartesian_(datum_.latitude_deg, datum_.longitude_deg, datum_.altitude) {}

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

}  // namespace multipath_localization
