#include "multipath_localization/rinex/navigation_message.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kKilometre = 1e3;
constexpr std::size_t kNumberWidth = 19;
constexpr std::size_t kGlonassLines = 4;  // from version 3.05 on one more

using Eigen::Vector3d;

/// A word of flags that RINEX prints as a number.
int flags(double number) { return std::abs(number) < 1e6 ? static_cast<int>(number) : -1; }

bool within(double value, double low, double high) { return value >= low && value <= high; }

/// What no satellite's message holds, and what keeps everything computed from it finite.
bool possible(const BroadcastOrbit& orbit) {
  return within(orbit.eccentricity, 0.0, 0.5) && within(orbit.root_axis, 4000.0, 8000.0) &&
         within(orbit.toe, 0.0, kSecondsOfWeek) && orbit.clock_polynomial.cwiseAbs().maxCoeff() < 1.0 &&
         std::abs(orbit.mean_motion_difference) < 1e-3 && std::abs(orbit.group_delay) < 1e-3;
}

bool possible(const GlonassOrbit& orbit) {
  return within(orbit.position.norm(), 2e7, 3e7) && orbit.velocity.norm() < 1e4 &&
         orbit.acceleration.norm() < 1e-3 && std::abs(orbit.clock) < 1.0 &&
         std::abs(orbit.clock_drift) < 1e-3 && within(orbit.channel, -7, 13);
}

}  // namespace

NavigationMessage::NavigationMessage(const LineReader& in, std::optional<Constellation> constellation)
    : version_2_(constellation.has_value()) {
  if (!constellation) constellation = constellation_of_letter(in.columns(0, 1).front());
  if (!constellation) throw in.error("no message of a known satellite system begins here");
  satellite_ = {*constellation, version_2_ ? in.integer(0, 2) : in.integer(1, 2)};
  time_ = version_2_ ? calendar_time(in, 3, 2, 5) : calendar_time(in, 4, 4, 3);
  add_line(in);
}

void NavigationMessage::add_line(const LineReader& in) {
  const std::size_t indentation = version_2_ ? 3 : 4;
  for (std::size_t i = lines_ == 0 ? 1 : 0; i < 4; ++i) {
    numbers_.at(lines_)[i] = in.number(indentation + kNumberWidth * i, kNumberWidth);
  }
  ++lines_;
}

Ephemeris NavigationMessage::ephemeris(const LineReader& in, std::optional<int> leap_seconds) const {
  const bool glonass = satellite_.constellation == Constellation::kGlonass;
  const bool complete =
      glonass ? lines_ == kGlonassLines || lines_ == kGlonassLines + 1 : lines_ == kMostLines;
  if (!complete) throw in.error("the message that ends here has " + std::to_string(lines_) + " lines");
  if (glonass) return glonass_orbit(in, leap_seconds);
  return broadcast_orbit(in);
}

GlonassOrbit NavigationMessage::glonass_orbit(const LineReader& in, std::optional<int> leap_seconds) const {
  const auto reference = gps_time(time_, TimeScale::kUtc, leap_seconds);
  if (!reference) throw in.error("the message that ends here has an impossible date");
  const auto vector = [&](std::size_t place) {
    return Vector3d(kKilometre * Vector3d(at(in, 1, place), at(in, 2, place), at(in, 3, place)));
  };
  GlonassOrbit orbit;
  orbit.satellite = satellite_;
  orbit.reference = *reference;
  orbit.clock = at(in, 0, 1);
  orbit.clock_drift = at(in, 0, 2);
  orbit.position = vector(0);
  orbit.velocity = vector(1);
  orbit.acceleration = vector(2);
  orbit.healthy = at(in, 1, 3) == 0.0;
  orbit.channel = static_cast<int>(std::clamp(at(in, 2, 3), -100.0, 100.0));
  if (!possible(orbit)) throw in.error("the message that ends here is of no orbit of GLONASS");
  return orbit;
}

BroadcastOrbit NavigationMessage::broadcast_orbit(const LineReader& in) const {
  const bool beidou = satellite_.constellation == Constellation::kBeidou;
  const auto as_printed = gps_time(time_, TimeScale::kGps);
  const auto clock_reference = gps_time(time_, beidou ? TimeScale::kBeidou : TimeScale::kGps);
  if (!as_printed || !clock_reference) throw in.error("the message that ends here has an impossible date");
  const auto get = [&](std::size_t line, std::size_t place) { return at(in, line, place); };

  BroadcastOrbit orbit;
  orbit.satellite = satellite_;
  orbit.healthy = healthy(in);
  orbit.clock_reference = *clock_reference;
  orbit.clock_polynomial = {get(0, 1), get(0, 2), get(0, 3)};
  orbit.toe = get(3, 0);
  // The second of the week alone tells it: writers disagree on which week they print beside.
  const double later = std::remainder(orbit.toe - as_printed->second, kSecondsOfWeek);
  orbit.reference = orbit.clock_reference + later;
  orbit.radius_correction = {get(1, 1), get(4, 1)};
  orbit.mean_motion_difference = get(1, 2);
  orbit.mean_anomaly = get(1, 3);
  orbit.latitude_correction = {get(2, 2), get(2, 0)};
  orbit.eccentricity = get(2, 1);
  orbit.root_axis = get(2, 3);
  orbit.inclination_correction = {get(3, 3), get(3, 1)};
  orbit.node = get(3, 2);
  orbit.inclination = get(4, 0);
  orbit.perigee = get(4, 2);
  orbit.node_rate = get(4, 3);
  orbit.inclination_rate = get(5, 0);
  // Galileo: F/NAV's clock (bit 1 of the data sources) is that of E5a and E1, I/NAV's that of E5b and E1.
  const bool galileo = satellite_.constellation == Constellation::kGalileo;
  const bool i_nav = galileo && (flags(numbers_[5][1].value_or(0.0)) & 2) == 0;
  orbit.group_delay = get(6, i_nav ? 3 : 2);
  if (!possible(orbit)) throw in.error("the message that ends here is of no navigation satellite's orbit");
  return orbit;
}

double NavigationMessage::at(const LineReader& in, std::size_t line, std::size_t place) const {
  const std::optional<double>& number = numbers_.at(line).at(place);
  if (!number)
    throw in.error("the message that ends here lacks a number in line " + std::to_string(line + 1));
  return *number;
}

bool NavigationMessage::healthy(const LineReader& in) const {
  const int health = flags(at(in, 6, 1));
  switch (satellite_.constellation) {
    case Constellation::kGalileo: return (health & 7) == 0 && at(in, 6, 0) >= 0.0;  // E1-B's; accuracy
    case Constellation::kQzss: return (health & 0x3e) == 0;  // all but L1C/B, the lowest bit
    default: return health == 0;
  }
}

}  // namespace multipath_localization
