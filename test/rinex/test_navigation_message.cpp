#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/navigation_message.hpp"

namespace multipath_localization {
namespace {

class ReadMessage : public ::testing::Test {
 protected:
  /// Of RINEX 3.
  [[nodiscard]] std::optional<Ephemeris> read(const std::string& lines,
                                              std::optional<int> leap_seconds = 18) const {
    LineReader in(folder_.write("nav", lines));
    in.require_next("the test");
    NavigationMessage message(in, std::nullopt);
    while (in.next()) message.add_line(in);
    return message.ephemeris(in, leap_seconds);
  }

  [[nodiscard]] Ephemeris ephemeris(const std::string& lines, std::optional<int> leap_seconds = 18) const {
    return read(lines, leap_seconds).value();
  }

  [[nodiscard]] std::string refusal(const std::string& lines) const {
    try {
      (void)ephemeris(lines);
    } catch (const RinexError& error) {
      return std::string(error.what()).substr(folder_.path().size() + 5);
    }
    return "";
  }

  [[nodiscard]] bool healthy(const std::string& lines) const {
    return std::get<BroadcastOrbit>(ephemeris(lines)).healthy;
  }

  TemporaryFolder folder_;
};

TEST_F(ReadMessage, GpsGivesKeplersElementsAndItsClock) {
  const auto orbit = std::get<BroadcastOrbit>(ephemeris(kGps5));
  EXPECT_EQ(orbit.satellite, (SatelliteId{Constellation::kGps, 5}));
  EXPECT_TRUE(orbit.healthy);
  EXPECT_EQ(orbit.reference.week, 2320);
  EXPECT_DOUBLE_EQ(orbit.reference.second, 122400.0);
  EXPECT_DOUBLE_EQ(orbit.clock_reference.second, 122400.0);
  EXPECT_DOUBLE_EQ(orbit.clock_polynomial(0), -1.774230040610e-04);
  EXPECT_DOUBLE_EQ(orbit.clock_polynomial(1), -1.364242052659e-12);
  EXPECT_DOUBLE_EQ(orbit.root_axis, 5153.635631561);
  EXPECT_DOUBLE_EQ(orbit.eccentricity, 5.927642923780e-03);
  EXPECT_DOUBLE_EQ(orbit.mean_anomaly, 1.714815412488);
  EXPECT_DOUBLE_EQ(orbit.mean_motion_difference, 4.293035965037e-09);
  EXPECT_DOUBLE_EQ(orbit.inclination, 9.719266524177e-01);
  EXPECT_DOUBLE_EQ(orbit.inclination_rate, -2.610823036973e-10);
  EXPECT_DOUBLE_EQ(orbit.node, 2.520897825810);
  EXPECT_DOUBLE_EQ(orbit.node_rate, -8.275344701323e-09);
  EXPECT_DOUBLE_EQ(orbit.perigee, 1.273307347665);
  EXPECT_EQ(orbit.latitude_correction, Eigen::Vector2d(1.830980181694e-06, -5.291774868965e-06));
  EXPECT_EQ(orbit.radius_correction, Eigen::Vector2d(-98.21875, 353.625));
  EXPECT_EQ(orbit.inclination_correction, Eigen::Vector2d(-5.774199962616e-08, 3.352761268616e-08));
  EXPECT_DOUBLE_EQ(orbit.group_delay, -1.071020960808e-08);
}

TEST_F(ReadMessage, BeidousSecondsAreFourteenLaterThanTheyRead) {
  const auto orbit = std::get<BroadcastOrbit>(ephemeris(kBeidou1));
  EXPECT_DOUBLE_EQ(orbit.toe, 115200.0);
  EXPECT_DOUBLE_EQ(orbit.reference.second, 115214.0);
  EXPECT_EQ(orbit.reference.week, 2320);
  EXPECT_DOUBLE_EQ(orbit.group_delay, -4.9e-9);
}

const std::string kGalileosHealth = " 3.120000000000E+00 0.000000000000E+00-8.61";

/// kGalileo12At8 of other data sources and another health.
std::string galileo(const std::string& sources, const std::string& health) {
  const std::string by_sources = replaced(kGalileo12At8, " 5.170000000000E+02", sources);
  return replaced(by_sources, kGalileosHealth, " 3.120000000000E+00" + health + "-8.61");
}

TEST_F(ReadMessage, GalileosGroupDelayIsThatOfItsClock) {
  EXPECT_DOUBLE_EQ(std::get<BroadcastOrbit>(ephemeris(kGalileo12At8)).group_delay, -8.847564458847e-09);
  const std::string with_e5a = galileo(" 2.590000000000E+02", " 0.000000000000E+00");
  EXPECT_DOUBLE_EQ(std::get<BroadcastOrbit>(ephemeris(with_e5a)).group_delay, -8.614733815193e-09);
}

/// As E18 was on that day, in an orbit that is none for navigation: 130 in I/NAV, E1-B and E5b out of
/// service, and 16 in F/NAV, E5a likewise.
TEST_F(ReadMessage, GalileosFNavDoesNotSpeakForE1) {
  EXPECT_FALSE(healthy(galileo(" 5.170000000000E+02", " 1.300000000000E+02")));
  EXPECT_FALSE(read(galileo(" 2.580000000000E+02", " 1.600000000000E+01")));
  EXPECT_FALSE(read(galileo(" 2.580000000000E+02", " 0.000000000000E+00")));
  EXPECT_TRUE(healthy(galileo(" 0.000000000000E+00", " 0.000000000000E+00")));
}

TEST_F(ReadMessage, WhenItWasSentCountsFromTheReference) {
  EXPECT_EQ(std::get<BroadcastOrbit>(ephemeris(kGps5)).sent, std::optional<double>(115218.0 - 122400.0));
  EXPECT_EQ(std::get<BroadcastOrbit>(ephemeris(kGalileo12At8)).sent, std::optional<double>(665.0));
  EXPECT_NEAR(std::get<BroadcastOrbit>(ephemeris(kBeidou1)).sent.value(), 27.6, 1e-9);
  EXPECT_EQ(std::get<GlonassOrbit>(ephemeris(kGlonass1At815)).sent, std::optional<double>(-900.0));
  const std::string of_version_2 = replaced(kGlonass1At815, " 1.152000000000E+05", " 2.880000000000E+04");
  EXPECT_EQ(std::get<GlonassOrbit>(ephemeris(of_version_2)).sent, std::optional<double>(-900.0));
  std::string over_the_weeks_end = replaced(kGps5, "2024 06 24 10 00 00", "2024 06 22 23 59 44");
  over_the_weeks_end = replaced(over_the_weeks_end, "1.224000000000E+05", "0.000000000000E+00");
  over_the_weeks_end = replaced(over_the_weeks_end, "1.152180000000E+05", "6.047900000000E+05");
  EXPECT_EQ(std::get<BroadcastOrbit>(ephemeris(over_the_weeks_end)).sent, std::optional<double>(-10.0));
  for (const char* unknown : {"0.999900000000E+09", "                  "}) {
    EXPECT_FALSE(std::get<BroadcastOrbit>(ephemeris(replaced(kGps5, "1.152180000000E+05", unknown))).sent);
  }
}

TEST_F(ReadMessage, GlonasssChannelBelowZeroMayBePrintedAsAByte) {
  const auto channel = [&](const std::string& printed) {
    const std::string first = " 1.862645149231E-09";
    return std::get<GlonassOrbit>(
               ephemeris(replaced(kGlonass1At815, first + " 1.000000000000E+00", first + printed)))
        .channel;
  };
  EXPECT_EQ(channel("-7.000000000000E+00"), -7);
  EXPECT_EQ(channel(" 2.490000000000E+02"), -7);
  EXPECT_EQ(channel(" 2.550000000000E+02"), -1);
}

TEST_F(ReadMessage, TheReferenceIsTheOneNearTheClocksEvenOverTheEndOfAWeek) {
  std::string late = replaced(kGps5, "2024 06 24 10 00 00", "2024 06 22 23 59 44");
  late = replaced(late, " 1.224000000000E+05", " 0.000000000000E+00");
  const auto orbit = std::get<BroadcastOrbit>(ephemeris(late));
  EXPECT_EQ(orbit.clock_reference.week, 2319);
  EXPECT_EQ(orbit.reference.week, 2320);
  EXPECT_DOUBLE_EQ(orbit.reference.second, 0.0);
}

TEST_F(ReadMessage, GlonassGivesAStateInMetresAtUtc) {
  const auto orbit = std::get<GlonassOrbit>(ephemeris(kGlonass1At815));
  EXPECT_EQ(orbit.satellite, (SatelliteId{Constellation::kGlonass, 1}));
  EXPECT_TRUE(orbit.healthy);
  EXPECT_DOUBLE_EQ(orbit.reference.second, 116118.0);
  EXPECT_LT((orbit.position - Eigen::Vector3d(-13736887.69531, -3309238.28125, 21242412.59766)).norm(), 1e-4);
  EXPECT_LT((orbit.velocity - Eigen::Vector3d(-1554.378509521, -2458.472251892, -1386.628150940)).norm(),
            1e-8);
  EXPECT_LT((orbit.acceleration - Eigen::Vector3d(9.313225746e-7, 1.862645149e-6, -1.862645149e-6)).norm(),
            1e-14);
  EXPECT_DOUBLE_EQ(orbit.clock, 8.934084326029e-05);
  EXPECT_DOUBLE_EQ(orbit.clock_drift, 9.094947017729e-13);
  EXPECT_EQ(orbit.channel, 1);
  EXPECT_DOUBLE_EQ(std::get<GlonassOrbit>(ephemeris(kGlonass1At815, 19)).reference.second, 116119.0);
  EXPECT_DOUBLE_EQ(std::get<GlonassOrbit>(ephemeris(kGlonass1At815, std::nullopt)).reference.second,
                   116118.0);
}

TEST_F(ReadMessage, Rinex305HasOneMoreLineOfGlonass) {
  const std::string line =
      "     0.000000000000E+00 0.000000000000E+00 0.000000000000E+00 0.000000000000E+00\n";
  EXPECT_EQ(std::get<GlonassOrbit>(ephemeris(kGlonass1At815 + line)).channel, 1);
  EXPECT_NE(refusal(kGlonass1At815 + line + line), "");
}

TEST_F(ReadMessage, HealthIsThatOfTheSignalUsed) {
  const std::string gps = " 2.000000000000E+00 0.000000000000E+00-1.0710";
  const auto with_health = [&](const std::string& health) {
    return replaced(kGps5, gps, " 2.000000000000E+00" + health + "-1.0710");
  };
  EXPECT_TRUE(healthy(with_health(" 0.000000000000E+00")));
  EXPECT_FALSE(healthy(with_health(" 6.300000000000E+01")));
  EXPECT_FALSE(healthy(with_health(" 1.000000000000E+00")));
  EXPECT_FALSE(healthy(with_health(" 1.000000000000E+80")));
  EXPECT_TRUE(healthy(replaced(with_health(" 1.000000000000E+00"), "G05", "J05")));
  EXPECT_FALSE(healthy(replaced(with_health(" 3.200000000000E+01"), "G05", "J05")));

  EXPECT_FALSE(healthy(galileo(" 5.170000000000E+02", " 1.000000000000E+00")));
  EXPECT_TRUE(healthy(galileo(" 5.170000000000E+02", " 8.000000000000E+00")));
  EXPECT_FALSE(
      healthy(replaced(kGalileo12At8, kGalileosHealth, "-1.000000000000E+00 0.000000000000E+00-8.61")));
  EXPECT_FALSE(std::get<GlonassOrbit>(
                   ephemeris(replaced(kGlonass1At815, "9.313225746155E-10 0.0", "9.313225746155E-10 1.0")))
                   .healthy);
}

TEST_F(ReadMessage, RefusesWhatIsNoOrbit) {
  const std::string not_an_orbit = ": the message that ends here is of no navigation satellite's orbit";
  EXPECT_EQ(refusal(replaced(kGps5, "5.927642923780E-03", "1.500000000000E+00")), "8" + not_an_orbit);
  EXPECT_EQ(refusal(replaced(kGps5, "5.153635631561E+03", "0.000000000000E+00")), "8" + not_an_orbit);
  EXPECT_EQ(refusal(replaced(kGps5, "-1.774230040610E-04", "-1.774230040610E-01")), "8" + not_an_orbit);
  EXPECT_EQ(refusal(replaced(kGps5, "2024 06 24", "2024 06 22")), "8" + not_an_orbit);
  EXPECT_EQ(refusal(replaced(kGlonass1At815, "-1.373688769531E+04", "-1.373688769531E+14")),
            "4: the message that ends here is of no orbit of GLONASS");
  EXPECT_EQ(refusal(replaced(kGps5, "5.927642923780E-03", "                  ")),
            "8: the message that ends here lacks a number in line 3");
  EXPECT_EQ(refusal(replaced(kGps5, "2024 06 24", "2024 02 30")),
            "8: the message that ends here has an impossible date");
  EXPECT_EQ(refusal(replaced(kGps5, "5.927642923780E-03", "5.92764292378OE-03")),
            "3: '5.92764292378OE-03' is not a number");
  EXPECT_EQ(refusal(std::string(kGps5).substr(0, 81 * 5)), "5: the message that ends here has 5 lines");
  EXPECT_EQ(refusal(replaced(kGps5, "G05", "X05")), "1: no message of a known satellite system begins here");
}

}  // namespace
}  // namespace multipath_localization
