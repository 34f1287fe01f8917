#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/line_reader.hpp"
#include "rinex/navigation_file.hpp"

namespace multipath_localization {
namespace {

const SatelliteId kG05{Constellation::kGps, 5};
const SatelliteId kR01{Constellation::kGlonass, 1};
const std::string kIonosphere =
    header_line("GPSA   1.8626E-08  2.2352E-08 -1.1921E-07 -5.9605E-08", "IONOSPHERIC CORR") +
    header_line("GPSB   1.2902E+05  1.6384E+05 -1.9661E+05 -2.6214E+05", "IONOSPHERIC CORR");

TEST(ReadNavigation, TakesAllSystemsOfAMixedFile) {
  const std::string sbas =
      "S29 2024 06 24 08 15 12 0.0                0.0                1.15215E+05\n"
      "     4.200000000000E+04 0.000000000000E+00 0.000000000000E+00 0.000000000000E+00\n"
      "     4.200000000000E+04 0.000000000000E+00 0.000000000000E+00 0.000000000000E+00\n"
      "     4.200000000000E+04 0.000000000000E+00 0.000000000000E+00 0.000000000000E+00\n";
  const Navigation all = navigation_of(navigation_header() + kGps5 + sbas + kGlonass1At815 + kGlonass1At845 +
                                       kBeidou1 + "\n" + kGalileo12At8);
  EXPECT_NE(all.ephemerides.find(kG05, on_24_june(9, 0)), nullptr);
  EXPECT_NE(all.ephemerides.find({Constellation::kGalileo, 12}, on_24_june(9, 0)), nullptr);
  EXPECT_NE(all.ephemerides.find({Constellation::kBeidou, 1}, on_24_june(9, 0)), nullptr);
  const Ephemeris* late = all.ephemerides.find(kR01, on_24_june(8, 40));
  ASSERT_NE(late, nullptr);
  EXPECT_DOUBLE_EQ(std::get<GlonassOrbit>(*late).clock, 8.934363722801e-05);
  EXPECT_FALSE(all.ionosphere);
}

TEST(ReadNavigation, TakesTheIonosphereOfGpsAndElseOfQzss) {
  std::string qzss = kIonosphere;
  for (std::size_t at = qzss.find("GPS"); at != std::string::npos; at = qzss.find("GPS"))
    qzss.replace(at, 3, "QZS");
  qzss.replace(qzss.find("1.8626"), 6, "7.7777");
  const auto first_alpha = [](const std::string& lines) {
    return navigation_of(navigation_header(lines) + kGps5).ionosphere->alpha(0);
  };
  EXPECT_DOUBLE_EQ(first_alpha(kIonosphere), 1.8626e-8);
  EXPECT_DOUBLE_EQ(first_alpha(qzss), 7.7777e-8);
  EXPECT_DOUBLE_EQ(first_alpha(qzss + kIonosphere), 1.8626e-8);
  const Navigation both = navigation_of(navigation_header(kIonosphere) + kGps5);
  EXPECT_DOUBLE_EQ(both.ionosphere->alpha(3), -5.9605e-8);
  EXPECT_DOUBLE_EQ(both.ionosphere->beta(3), -2.6214e5);
}

TEST(ReadNavigation, ZerosOrHalfOfTheCoefficientsAreNone) {
  const std::string zeros =
      header_line("GPSA   0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00", "IONOSPHERIC CORR") +
      header_line("GPSB   0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00", "IONOSPHERIC CORR");
  EXPECT_FALSE(navigation_of(navigation_header(zeros) + kGps5).ionosphere);
  EXPECT_FALSE(
      navigation_of(navigation_header(kIonosphere.substr(0, kIonosphere.find('\n') + 1)) + kGps5).ionosphere);
}

TEST(ReadNavigation, AnIonosphereGivenTwiceIsTheLast) {
  const Navigation all =
      navigation_of(navigation_header(replaced(kIonosphere, "1.8626", "7.7777") + kIonosphere) + kGps5);
  ASSERT_TRUE(all.ionosphere);
  EXPECT_DOUBLE_EQ(all.ionosphere->alpha(0), 1.8626e-8);
}

TEST(ReadNavigation, LeapSecondsAreThoseOfTheHeaderUnlessBeidous) {
  const auto reference = [](const std::string& lines) {
    const Navigation all = navigation_of(navigation_header(lines) + kGlonass1At815);
    return std::get<GlonassOrbit>(*all.ephemerides.find(kR01, on_24_june(8, 15))).reference.second;
  };
  EXPECT_DOUBLE_EQ(reference(""), 116118.0);
  EXPECT_DOUBLE_EQ(reference(header_line("    19", "LEAP SECONDS")), 116119.0);
  EXPECT_DOUBLE_EQ(reference(header_line("     4    18   929     7BDS", "LEAP SECONDS")), 116118.0);
}

TEST(ReadNavigation, TakesGpsAndGlonassOfVersion2FromTheirOwnFiles) {
  const TemporaryFolder folder;
  const std::string gps = folder.write(
      "brdc.24n", header_line("     2.11           N: GPS NAV DATA", "RINEX VERSION / TYPE") +
                      header_line("    0.1863D-07  0.2235D-07 -0.1192D-06 -0.5961D-07", "ION ALPHA") +
                      header_line("    0.1290D+06  0.1638D+06 -0.1966D+06 -0.2621D+06", "ION BETA") +
                      header_line("", "END OF HEADER") +
                      " 5 24  6 24 10  0  0.0 -.177423004061D-03 -.136424205266D-11  .000000000000D+00\n"
                      "     .720000000000D+02 -.982187500000D+02  .429303596504D-08  .171481541249D+01\n"
                      "    -.529177486896D-05  .592764292378D-02  .183098018169D-05  .515363563156D+04\n"
                      "     .122400000000D+06  .335276126862D-07  .252089782581D+01 -.577419996262D-07\n"
                      "     .971926652418D+00  .353625000000D+03  .127330734767D+01 -.827534470132D-08\n"
                      "    -.261082303697D-09  .100000000000D+01  .232000000000D+04  .000000000000D+00\n"
                      "     .200000000000D+01  .000000000000D+00 -.107102096081D-07  .720000000000D+02\n"
                      "     .115218000000D+06  .400000000000D+01\n");
  const std::string glonass = folder.write(
      "brdc.24g", header_line("     2.11           GLONASS NAV DATA", "RINEX VERSION / TYPE") +
                      header_line("", "END OF HEADER") +
                      " 1 24 06 24 08 15 00.0  .893408432603D-04  .909494701773D-12  .288000000000D+05\n"
                      "    -.137368876953D+05 -.155437850952D+01  .931322574616D-09  .000000000000D+00\n"
                      "    -.330923828125D+04 -.245847225189D+01  .186264514923D-08  .100000000000D+01\n"
                      "     .212424125977D+05 -.138662815094D+01 -.186264514923D-08  .000000000000D+00\n");
  const Navigation all = read_navigation({gps, glonass});
  EXPECT_DOUBLE_EQ(all.ionosphere->alpha(1), 0.2235e-7);
  const GnssTime time = on_24_june(8, 20);
  const SatelliteState of_version_3 = satellite_state(orbit_of<BroadcastOrbit>(kGps5, kG05, time), time);
  const Ephemeris* satellite = all.ephemerides.find(kG05, time);
  ASSERT_NE(satellite, nullptr);
  EXPECT_LT((satellite_state(*satellite, time).position - of_version_3.position).norm(), 0.01);
  satellite = all.ephemerides.find(kR01, time);
  ASSERT_NE(satellite, nullptr);
  EXPECT_LT(
      (std::get<GlonassOrbit>(*satellite).position - Eigen::Vector3d(-13736887.7, -3309238.3, 21242412.6))
          .norm(),
      0.1);
}

std::string refusal(const std::string& content) {
  const TemporaryFolder folder;
  try {
    (void)read_navigation({folder.write("nav", content)});
  } catch (const RinexError& error) {
    return std::string(error.what()).substr(folder.path().size() + 5);
  }
  return "";
}

TEST(ReadNavigation, RefusesWithLineAndReason) {
  EXPECT_EQ(refusal(header_line("     3.04           OBSERVATION DATA    M", "RINEX VERSION / TYPE")),
            "1: type 'O' is no navigation that is read");
  EXPECT_EQ(refusal(header_line("     2.11           H: GEO NAV DATA", "RINEX VERSION / TYPE")),
            "1: type 'H' is no navigation that is read");
  EXPECT_EQ(refusal(header_line("     3.04           N: GNSS NAV DATA    M", "RINEX VERSION / TYPE")),
            "1: the file ends within its header");
}

/// What is left out of `messages`, by line and reason, when E12's stands behind them and is read.
std::vector<std::string> left_out_of(const std::string& messages) {
  const TemporaryFolder folder;
  Navigation all = read_navigation({folder.write("nav", navigation_header() + messages + kGalileo12At8)});
  EXPECT_NE(all.ephemerides.find({Constellation::kGalileo, 12}, on_24_june(9, 0)), nullptr);
  for (std::string& reason : all.left_out) reason.erase(0, folder.path().size() + 5);
  return all.left_out;
}

TEST(ReadNavigation, LeavesOutAMessageThatCannotBeUsedAndReadsOn) {
  using Reasons = std::vector<std::string>;
  const std::string gps = kGps5;
  EXPECT_EQ(left_out_of(gps), Reasons());
  EXPECT_EQ(left_out_of(gps.substr(0, 81 * 6)), Reasons{"8: the message that ends here has 6 lines"});
  EXPECT_EQ(left_out_of(gps.substr(81)), Reasons{"3: no message of a known satellite system begins here"});
  EXPECT_EQ(left_out_of(gps + gps.substr(81, 81)), Reasons{"11: a message of over 8 lines"});
  EXPECT_EQ(left_out_of(replaced(gps, "5.927642923780E-03", "5.92764292378OE-03")),
            Reasons{"5: '5.92764292378OE-03' is not a number"});
  EXPECT_EQ(left_out_of(replaced(gps, "2024 06 24", "2024 02 30") + replaced(gps, "G05", "Q05")),
            (Reasons{"10: the message that ends here has an impossible date",
                     "11: no message of a known satellite system begins here"}));
}

TEST(ReadNavigation, FilesMayBeJoined) {
  const Navigation all = navigation_of(navigation_header() + kGps5 + "\xef\xbb\xbf" +
                                       navigation_header(kIonosphere) + kGalileo12At8 + "\x1a");
  EXPECT_TRUE(all.left_out.empty());
  EXPECT_TRUE(all.ionosphere);
  EXPECT_NE(all.ephemerides.find(kG05, on_24_june(9, 0)), nullptr);
  EXPECT_NE(all.ephemerides.find({Constellation::kGalileo, 12}, on_24_june(9, 0)), nullptr);
  const std::string unknown =
      header_line("     9.00           N: GNSS NAV DATA    M", "RINEX VERSION / TYPE");
  const Navigation without =
      navigation_of(navigation_header() + kGps5 + unknown + kBeidou1 + navigation_header() + kGalileo12At8);
  EXPECT_EQ(without.left_out.size(), 1u);
  EXPECT_EQ(without.ephemerides.find({Constellation::kBeidou, 1}, on_24_june(8, 0)), nullptr);
  EXPECT_NE(without.ephemerides.find({Constellation::kGalileo, 12}, on_24_june(9, 0)), nullptr);
}

TEST(ReadNavigation, AMessageThatNamesItsSystemIsOfVersion3) {
  const Navigation all = navigation_of(
      header_line("     2.11           N: GNSS NAV DATA    M: MIXED", "RINEX VERSION / TYPE") +
      header_line("  xx", "LEAP SECONDS") + header_line("", "END OF HEADE") + kGps5 + kGalileo12At8);
  EXPECT_EQ(all.left_out.size(), 1u) << "the leap seconds";
  EXPECT_NE(all.ephemerides.find(kG05, on_24_june(9, 0)), nullptr);
  EXPECT_NE(all.ephemerides.find({Constellation::kGalileo, 12}, on_24_june(9, 0)), nullptr);
}

TEST(ReadNavigation, LeavesOutTheMessageThatTheFileBreaksOffIn) {
  const std::string whole = navigation_header() + kGalileo12At8 + kGps5;
  for (const std::size_t missing : {1, 10, 100, 600}) {
    const Navigation all = navigation_of(whole.substr(0, whole.size() - missing));
    EXPECT_NE(all.ephemerides.find({Constellation::kGalileo, 12}, on_24_june(9, 0)), nullptr);
    EXPECT_EQ(all.ephemerides.find(kG05, on_24_june(9, 0)), nullptr);
    EXPECT_EQ(all.left_out.size(), 1u) << missing;
  }
}

TEST(ReadNavigation, NoTruncationAndNoFlippedByteDoesHarm) {
  const std::string whole = navigation_header(kIonosphere) + kGps5 + kGlonass1At815 + kBeidou1;
  for (std::size_t size = 0; size < whole.size(); size += 61) (void)refusal(whole.substr(0, size));
  for (std::size_t place = 0; place < whole.size(); place += 31) {
    for (const char byte : {'\0', '\n', '9', '-', 'E', '\xff'}) {
      std::string broken = whole;
      broken[place] = byte;
      (void)refusal(broken);
    }
  }
}

}  // namespace
}  // namespace multipath_localization
