#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "rinex/gnss_time.hpp"

namespace multipath_localization {

constexpr double kLowestElevation = 3.0 * kPi / 180.0;  ///< lower ones count as this in slant delays [rad]

/// Coefficients of GPS's model of the ionosphere, by powers of semicircles.
struct KlobucharCoefficients {
  Eigen::Vector4d alpha = Eigen::Vector4d::Zero();  ///< of the amplitude [s, ...]
  Eigen::Vector4d beta = Eigen::Vector4d::Zero();   ///< of the period [s, ...]
};

/// Where a satellite stands in the sky of an antenna.
struct Direction {
  double azimuth = 0.0;    ///< from north, clockwise [rad]
  double elevation = 0.0;  ///< above the horizon [rad]
};

/// By its place in the map whose datum the antenna is at: east, north, up.
Direction direction_of(const Eigen::Vector3d& satellite_in_map);

/// Delay of the code by the ionosphere at 1575.42 MHz [m]; at a frequency f it is (1575.42 MHz / f)^2 times
/// that. IS-GPS-200, 20.3.3.5.2.5: takes away half of it or more. `time`: GPS, of reception.
double klobuchar_delay(const KlobucharCoefficients& ionosphere, const Geodetic& antenna,
                       const Direction& satellite, const GnssTime& time);

/// Delay by the troposphere [m], Saastamoinen's model (1972) in a standard atmosphere of 70 % relative
/// humidity; 10 km over the ellipsoid and higher there is none.
double saastamoinen_delay(const Geodetic& antenna, double elevation);

}  // namespace multipath_localization
