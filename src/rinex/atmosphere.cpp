#include "rinex/atmosphere.hpp"

#include <algorithm>
#include <cmath>

#include "models/pseudorange/ionospheric_slant.hpp"

namespace multipath_localization {

namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kRelativeHumidity = 0.7;
constexpr double kTopOfModel = 1e4;      // [m]
constexpr double kBottomOfModel = -1e3;  // [m], below any ground

double polynomial(const Eigen::Vector4d& coefficients, double x) {
  return coefficients(0) + x * (coefficients(1) + x * (coefficients(2) + x * coefficients(3)));
}

}  // namespace

Direction direction_of(const Eigen::Vector3d& satellite_in_map) {
  return {std::atan2(satellite_in_map.x(), satellite_in_map.y()),
          std::asin(satellite_in_map.z() / satellite_in_map.norm())};
}

double klobuchar_delay(const KlobucharCoefficients& ionosphere, const Geodetic& antenna,
                       const Direction& satellite, const GnssTime& time) {
  // All angles in semicircles, as the source has them.
  const double E = std::max(satellite.elevation, 0.0) / kPi;
  const double psi = 0.0137 / (E + 0.11) - 0.022;
  const double phi =
      std::clamp(antenna.latitude_deg / 180.0 + psi * std::cos(satellite.azimuth), -0.416, 0.416);
  const double lambda =
      antenna.longitude_deg / 180.0 + psi * std::sin(satellite.azimuth) / std::cos(phi * kPi);
  const double geomagnetic = phi + 0.064 * std::cos((lambda - 1.617) * kPi);
  const double local = 43200.0 * lambda + time.second;
  const double local_time = local - kSecondsOfDay * std::floor(local / kSecondsOfDay);
  const double amplitude = std::max(polynomial(ionosphere.alpha, geomagnetic), 0.0);
  const double period = std::max(polynomial(ionosphere.beta, geomagnetic), 72000.0);
  const double x = 2.0 * kPi * (local_time - 50400.0) / period;
  const double day = std::abs(x) < 1.57 ? amplitude * (1.0 - x * x / 2.0 + x * x * x * x / 24.0) : 0.0;
  return kSpeedOfLight * ionospheric_slant(satellite.elevation) * (5e-9 + day);
}

double saastamoinen_delay(const Geodetic& antenna, double elevation) {
  if (!(antenna.altitude < kTopOfModel)) return 0.0;
  const double height = std::max(antenna.altitude, kBottomOfModel);
  const double pressure = 1013.25 * std::pow(1.0 - 2.2557e-5 * height, 5.2568);  // [hPa]
  const double temperature = 288.16 - 6.5e-3 * height;                           // [K]
  const double vapour =
      6.108 * kRelativeHumidity * std::exp((17.15 * temperature - 4684.0) / (temperature - 38.45));
  const double dry = 0.0022768 * pressure /
                     (1.0 - 0.00266 * std::cos(2.0 * antenna.latitude_deg * kDegree) - 2.8e-7 * height);
  const double wet = 0.002277 * (1255.0 / temperature + 0.05) * vapour;
  return (dry + wet) / std::sin(std::max(elevation, kLowestElevation));
}

}  // namespace multipath_localization
