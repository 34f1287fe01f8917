#include "rinex/navigation_message.hpp"

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

/// Some writers print a channel below zero as the byte that holds it.
int channel_of(double number) {
  const int channel = static_cast<int>(std::clamp(number, -1000.0, 1000.0));
  return channel > 128 ? channel - 256 : channel;
}

/// How long after the reference, at `reference` on the same scale, a message left. Writers that do not know
/// print 0.9999e9 [s].
std::optional<double> sent_after(std::optional<double> transmission, double reference, double period) {
  if (!transmission || std::abs(*transmission) > 2.0 * kSecondsOfWeek) return std::nullopt;
  return std::remainder(*transmission - reference, period);
}

/// Galileo's data sources, by their bits.
constexpr int kINav = 0b101;          // of E1-B and E5b-I
constexpr int kFNav = 0b10;           // of E5a-I
constexpr int kClockOfFNav = 1 << 8;  // of E1 with E5a, without it with E5b

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
  if (lines_ == kMostLines) throw in.error("a message of over " + std::to_string(kMostLines) + " lines");
  const std::size_t indentation = version_2_ ? 3 : 4;
  for (std::size_t i = lines_ == 0 ? 1 : 0; i < 4; ++i) {
    numbers_.at(lines_)[i] = in.number(indentation + kNumberWidth * i, kNumberWidth);
  }
  ++lines_;
}

std::optional<Ephemeris> NavigationMessage::ephemeris(const LineReader& in,
                                                      std::optional<int> leap_seconds) const {
  const bool glonass = satellite_.constellation == Constellation::kGlonass;
  const bool complete =
      glonass ? lines_ == kGlonassLines || lines_ == kGlonassLines + 1 : lines_ == kMostLines;
  if (!complete) throw in.error("the message that ends here has " + std::to_string(lines_) + " lines");
  if (glonass) return glonass_orbit(in, leap_seconds);
  const bool of_e5a_alone = (data_sources() & (kINav | kFNav)) == kFNav;
  if (satellite_.constellation == Constellation::kGalileo && of_e5a_alone) return std::nullopt;
  return broadcast_orbit(in);
}

int NavigationMessage::data_sources() const { return flags(numbers_[5][1].value_or(0.0)); }

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
  orbit.channel = channel_of(at(in, 2, 3));
  // The second of the day in version 2, of the week in version 3.
  orbit.sent = sent_after(numbers_[0][3], gps_time(time_, TimeScale::kGps)->second, kSecondsOfDay);
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
  const bool galileo = satellite_.constellation == Constellation::kGalileo;
  orbit.group_delay = get(6, galileo && (data_sources() & kClockOfFNav) == 0 ? 3 : 2);
  orbit.sent = sent_after(numbers_[7][0], orbit.toe, kSecondsOfWeek);
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
    case Constellation::kGalileo: return (health & 7) == 0 && at(in, 6, 0) >= 0.0;  // I/NAV's E1-B; accuracy
    case Constellation::kQzss: return (health & 0x3e) == 0;  // all but L1C/B, the lowest bit
    default: return health == 0;
  }
}

}  // namespace multipath_localization
