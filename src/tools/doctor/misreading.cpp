#include "tools/doctor/misreading.hpp"

#include <array>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "ros/messages/conversions.hpp"
#include "tools/doctor/shape_fit.hpp"

namespace multipath_localization {

namespace {

/// What a driver does wrong, told by both numbers of a fix.
struct Reading {
  const char* as;
  const char* remedy;
  Geodetic (*read)(const Geodetic& told);  ///< not finite where the numbers cannot come of it
};

Geodetic swapped(const Geodetic& told) { return {told.longitude_deg, told.latitude_deg, told.altitude}; }

Geodetic from_radians(const Geodetic& told) {
  return {told.latitude_deg * 180.0 / kPi, told.longitude_deg * 180.0 / kPi, told.altitude};
}

/// NMEA's ddmm.mmmm, taken for hundredths of degrees: minutes are fewer than 60.
double from_minutes(double told) {
  const double whole = std::trunc(told);
  const double minutes = (told - whole) * 100.0;
  return std::abs(minutes) < 60.0 ? whole + minutes / 60.0 : std::nan("");
}

Geodetic from_minutes(const Geodetic& told) {
  return {from_minutes(told.latitude_deg), from_minutes(told.longitude_deg), told.altitude};
}

constexpr std::array<Reading, 3> kReadings = {
    {{"swapped", "latitude and longitude each in its own field", swapped},
     {"in radians", "degrees: times 180 / pi", from_radians},
     {"in degrees and minutes", "ddmm.mmmm of NMEA is dd + mm.mmmm / 60 degrees", from_minutes}}};

/// The usable fixes alone, read that way; nothing where one cannot be.
std::optional<Observations> read_as(const Reading& reading, const Observations& seen) {
  Observations other;
  other.fix_parameters = seen.fix_parameters;
  other.odometry_parameters = seen.odometry_parameters;
  for (auto arrived : seen.fixes) {
    if (check(arrived.message, seen.fix_parameters) != Reason::kAccepted) continue;
    const Geodetic place = reading.read(to_geodetic(arrived.message));
    if (!std::isfinite(place.latitude_deg) || !valid(place)) return {};
    arrived.message.latitude = place.latitude_deg;
    arrived.message.longitude = place.longitude_deg;
    other.fixes.push_back(arrived);
  }
  return other;
}

}  // namespace

std::optional<Misreading> misreading(const Observations& seen) {
  const Motion motion = motion_of(seen);
  const std::optional<Geodetic> place = place_of_fixes(seen);
  if (!place || fit_shape(motion.fixes, motion.track).fits()) return {};
  for (const Reading& reading : kReadings) {
    const std::optional<Observations> other = read_as(reading, seen);
    if (!other || !fit_shape(motion_of(*other).fixes, motion.track).fits()) continue;
    return Misreading{reading.as, reading.remedy, *place, *place_of_fixes(*other)};
  }
  return {};
}

}  // namespace multipath_localization
