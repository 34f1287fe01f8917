#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "../evaluation/temporary_folder.hpp"
#include "rinex/navigation_file.hpp"

namespace multipath_localization {

/// What satellites broadcast on 24 June 2024, as RINEX prints it.
constexpr char kGps5[] =
    "G05 2024 06 24 10 00 00-1.774230040610E-04-1.364242052659E-12 0.000000000000E+00\n"
    "     7.200000000000E+01-9.821875000000E+01 4.293035965037E-09 1.714815412488E+00\n"
    "    -5.291774868965E-06 5.927642923780E-03 1.830980181694E-06 5.153635631561E+03\n"
    "     1.224000000000E+05 3.352761268616E-08 2.520897825810E+00-5.774199962616E-08\n"
    "     9.719266524177E-01 3.536250000000E+02 1.273307347665E+00-8.275344701323E-09\n"
    "    -2.610823036973E-10 1.000000000000E+00 2.320000000000E+03 0.000000000000E+00\n"
    "     2.000000000000E+00 0.000000000000E+00-1.071020960808E-08 7.200000000000E+01\n"
    "     1.152180000000E+05 4.000000000000E+00\n";
constexpr char kGalileo12At8[] =
    "E12 2024 06 24 08 00 00-1.095208630431E-03-1.594457899046E-11 0.000000000000E+00\n"
    "     6.500000000000E+01 1.362187500000E+02 2.714398779890E-09 1.669452918066E+00\n"
    "     6.118789315224E-06 4.234847147018E-04 7.469207048416E-07 5.440608573914E+03\n"
    "     1.152000000000E+05-1.676380634308E-08 1.566563020769E+00 1.117587089539E-08\n"
    "     9.967372778341E-01 3.406562500000E+02 8.148434303224E-01-5.697380175896E-09\n"
    "     8.107480566251E-11 5.170000000000E+02 2.320000000000E+03\n"
    "     3.120000000000E+00 0.000000000000E+00-8.614733815193E-09-8.847564458847E-09\n"
    "     1.158650000000E+05\n";
constexpr char kGalileo12At830[] =
    "E12 2024 06 24 08 30 00-1.095237443224E-03-1.594457899046E-11 0.000000000000E+00\n"
    "     6.800000000000E+01 1.359062500000E+02 2.751543184247E-09 1.892799422716E+00\n"
    "     6.128102540970E-06 4.235870437697E-04 6.891787052155E-07 5.440608325958E+03\n"
    "     1.170000000000E+05-4.470348358154E-08 1.566552840322E+00 0.000000000000E+00\n"
    "     9.967372968521E-01 3.395312500000E+02 8.146526336207E-01-5.718809639948E-09\n"
    "     8.321775206769E-11 5.170000000000E+02 2.320000000000E+03\n"
    "     3.120000000000E+00 0.000000000000E+00-9.546056389809E-09-9.546056389809E-09\n"
    "     1.176650000000E+05\n";
constexpr char kBeidou1[] =
    "C01 2024 06 24 08 00 00 9.039411088452E-04 2.186695269302E-12 0.000000000000E+00\n"
    "     1.000000000000E+00 3.987812500000E+02 1.168655822063E-08-7.785119710056E-01\n"
    "     1.305714249611E-05 2.352053998038E-04-1.721968874335E-05 6.493358730316E+03\n"
    "     1.152000000000E+05 3.771856427193E-08-1.376223151778E+00-3.306195139885E-08\n"
    "     6.493194956776E-02 5.192812500000E+02 5.103894865136E-01-1.047865076358E-08\n"
    "     2.235807416067E-10 0.000000000000E+00 9.640000000000E+02 0.000000000000E+00\n"
    "     2.000000000000E+00 0.000000000000E+00-4.900000000000E-09-1.000000000000E-08\n"
    "     1.152276000000E+05 0.000000000000E+00\n";
constexpr char kGlonass1At815[] =
    "R01 2024 06 24 08 15 00 8.934084326029E-05 9.094947017729E-13 1.152000000000E+05\n"
    "    -1.373688769531E+04-1.554378509521E+00 9.313225746155E-10 0.000000000000E+00\n"
    "    -3.309238281250E+03-2.458472251892E+00 1.862645149231E-09 1.000000000000E+00\n"
    "     2.124241259766E+04-1.386628150940E+00-1.862645149231E-09 0.000000000000E+00\n";
constexpr char kGlonass1At845[] =
    "R01 2024 06 24 08 45 00 8.934363722801E-05 9.094947017729E-13 1.170000000000E+05\n"
    "    -1.662671630859E+04-1.613933563232E+00 9.313225746155E-10 0.000000000000E+00\n"
    "    -7.215297363281E+03-1.857051849365E+00-0.000000000000E+00 1.000000000000E+00\n"
    "     1.795810351563E+04-2.238905906677E+00-2.793967723846E-09 0.000000000000E+00\n";

/// `text` with the first `what` in it replaced.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t place = text.find(what);
  if (place == std::string::npos) throw std::invalid_argument("no '" + what + "' to replace");
  return text.replace(place, what.size(), by);
}

/// `text` and its label at column 60.
inline std::string header_line(std::string text, const std::string& label) {
  text.resize(60, ' ');
  return text + label + "\n";
}

inline std::string navigation_header(const std::string& more = "") {
  return header_line("     3.04           N: GNSS NAV DATA    M: MIXED", "RINEX VERSION / TYPE") + more +
         header_line("", "END OF HEADER");
}

/// Reads a navigation file of that content.
inline Navigation navigation_of(const std::string& content) {
  const TemporaryFolder folder;
  return read_navigation({folder.write("brdc.nav", content)});
}

/// That the satellite's broadcast names its time: week 2320, day 1.
inline GnssTime on_24_june(int hour, int minute, double second = 0.0) {
  return {2320, 86400.0 + 3600.0 * hour + 60.0 * minute + second};
}

/// What a message of the headers above says. The satellite has to be the only one in it.
template <class Orbit>
Orbit orbit_of(const std::string& message, const SatelliteId& satellite, const GnssTime& time) {
  return std::get<Orbit>(*navigation_of(navigation_header() + message).ephemerides.find(satellite, time));
}

/// The velocity that the positions of half a second before and after amount to.
template <class Orbit>
Eigen::Vector3d difference_quotient(const Orbit& orbit, const GnssTime& time) {
  return satellite_state(orbit, time + 0.5).position - satellite_state(orbit, time + -0.5).position;
}

}  // namespace multipath_localization
