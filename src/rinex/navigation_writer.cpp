#include "rinex/navigation_writer.hpp"

#include <initializer_list>
#include <iomanip>

#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kBeidouSeconds = 14.0;    // GPS time - BeiDou time
constexpr double kUnknownTime = 0.9999e9;  // of transmission, as RINEX prints it
constexpr double kUnhealthy = 2.0;         // what no system takes for healthy
constexpr double kKilometre = 1e3;
constexpr double kINavOfE1AndE5b = 517.0;  // Galileo's data source and clock
constexpr double kAccuracy = 2.0;          // that every system may declare [m]

std::string header_line(std::string text, const std::string& label) {
  text.resize(60, ' ');
  return text + label + "\n";
}

std::string scientific(double value, int width, int digits) {
  PlainStream out;
  out << std::uppercase << std::scientific << std::setprecision(digits) << std::setw(width) << value;
  return out.str();
}

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += scientific(value, 19, 12);
  return text;
}

std::string line(std::initializer_list<double> values) { return "    " + numbers(values) + "\n"; }

/// "G05 2024 06 24 10 00 00", by the calendar that the time is on.
std::string head(const SatelliteId& satellite, const GnssTime& time) {
  std::string date = to_text(time);
  for (char& c : date) c = c == '-' || c == ':' ? ' ' : c;
  const std::string number = std::to_string(satellite.number);
  return letter_of(satellite.constellation) + (number.size() < 2 ? "0" + number : number) + " " + date;
}

std::string text_of(const BroadcastOrbit& orbit) {
  const Constellation constellation = orbit.satellite.constellation;
  const bool galileo = constellation == Constellation::kGalileo;
  const bool beidou = constellation == Constellation::kBeidou;
  const GnssTime clock_reference = orbit.clock_reference + (beidou ? -kBeidouSeconds : 0.0);
  const Eigen::Vector3d& a = orbit.clock_polynomial;
  const double health = orbit.healthy ? 0.0 : kUnhealthy;
  const double sent = orbit.sent ? orbit.toe + *orbit.sent : kUnknownTime;
  return head(orbit.satellite, clock_reference) + numbers({a(0), a(1), a(2)}) + "\n" +
         line({0.0, orbit.radius_correction.x(), orbit.mean_motion_difference, orbit.mean_anomaly}) +
         line({orbit.latitude_correction.y(), orbit.eccentricity, orbit.latitude_correction.x(),
               orbit.root_axis}) +
         line({orbit.toe, orbit.inclination_correction.y(), orbit.node, orbit.inclination_correction.x()}) +
         line({orbit.inclination, orbit.radius_correction.y(), orbit.perigee, orbit.node_rate}) +
         line({orbit.inclination_rate, galileo ? kINavOfE1AndE5b : 0.0,
               static_cast<double>(orbit.reference.week), 0.0}) +
         line({kAccuracy, health, galileo ? 0.0 : orbit.group_delay, galileo ? orbit.group_delay : 0.0}) +
         line({sent, 0.0});
}

std::string text_of(const GlonassOrbit& orbit) {
  const GnssTime utc = orbit.reference + -leap_seconds_at(orbit.reference);
  const double sent = orbit.sent ? utc.second + *orbit.sent : kUnknownTime;
  const Eigen::Vector3d p = orbit.position / kKilometre;
  const Eigen::Vector3d v = orbit.velocity / kKilometre;
  const Eigen::Vector3d a = orbit.acceleration / kKilometre;
  return head(orbit.satellite, utc) + numbers({orbit.clock, orbit.clock_drift, sent}) + "\n" +
         line({p.x(), v.x(), a.x(), orbit.healthy ? 0.0 : kUnhealthy}) +
         line({p.y(), v.y(), a.y(), static_cast<double>(orbit.channel)}) + line({p.z(), v.z(), a.z(), 0.0});
}

std::string ionosphere_line(const char* name, const Eigen::Vector4d& coefficients) {
  std::string text = std::string(name) + " ";
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) text += scientific(coefficients(i), 12, 4);
  return header_line(text, "IONOSPHERIC CORR");
}

}  // namespace

std::string navigation_text(const Navigation& navigation) {
  std::string text = header_line("     3.04           N: GNSS NAV DATA    M: MIXED", "RINEX VERSION / TYPE");
  if (navigation.ionosphere) {
    text += ionosphere_line("GPSA", navigation.ionosphere->alpha);
    text += ionosphere_line("GPSB", navigation.ionosphere->beta);
  }
  text += header_line("", "END OF HEADER");
  for (const Ephemeris& ephemeris : navigation.ephemerides.all()) {
    text += std::visit([](const auto& orbit) { return text_of(orbit); }, ephemeris);
  }
  return text;
}

}  // namespace multipath_localization
