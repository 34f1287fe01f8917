#include <gtest/gtest.h>

#include <cmath>

#include "observation_texts.hpp"
#include "rinex/observation_file.hpp"

namespace multipath_localization {
namespace {

TEST_F(ReadObservations, TakesTheFirstCodeThatASatelliteHas) {
  const auto epochs = read(kHeader3 + kEpoch3);
  ASSERT_EQ(epochs.size(), 1u);
  EXPECT_EQ(epochs[0].time.week, 2320);
  EXPECT_DOUBLE_EQ(epochs[0].time.second, 116400.0);
  const auto& all = epochs[0].observations;
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].satellite, (SatelliteId{Constellation::kGps, 5}));
  EXPECT_DOUBLE_EQ(all[0].pseudorange, 20590792.555);
  EXPECT_DOUBLE_EQ(all[0].doppler, -105.331);
  EXPECT_DOUBLE_EQ(all[0].cn0, 46.938);
  EXPECT_DOUBLE_EQ(all[1].pseudorange, 26127502.6);
  EXPECT_TRUE(std::isnan(all[1].doppler));
  EXPECT_TRUE(std::isnan(all[1].cn0));
  EXPECT_EQ(all[2].satellite, (SatelliteId{Constellation::kBeidou, 3}));
  EXPECT_DOUBLE_EQ(all[2].pseudorange, 37529162.33);
  EXPECT_DOUBLE_EQ(all[2].doppler, 172.632);
}

TEST_F(ReadObservations, SignalStrengthsDigitStandsInForCn0) {
  const std::string epoch =
      "> 2024 06 24 08 20  0.0000000  0  2\n"
      "R01  20590792.555 7\n"
      "R02  20590792.555   108205345.409 5      -105.331\n";
  const auto all = read(kHeader3 + epoch).at(0).observations;
  EXPECT_DOUBLE_EQ(all[0].cn0, 44.5);
  EXPECT_DOUBLE_EQ(all[1].cn0, 32.5);
}

TEST_F(ReadObservations, AZeroIsNoMeasurement) {
  const std::string epoch =
      "> 2024 06 24 08 20  0.0000000  0  2\n"
      "R01         0.000                        -105.331\n"
      "R02  20590792.555                           0.000           0.000\n";
  const auto all = read(kHeader3 + epoch).at(0).observations;
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].satellite.number, 2);
  EXPECT_TRUE(std::isnan(all[0].doppler));
  EXPECT_TRUE(std::isnan(all[0].cn0));
}

TEST_F(ReadObservations, ScaledNumbersAreDivided) {
  std::string header = kHeader3;
  header.insert(header.find("S    1"), header_line("R 1000  2 C1C D1C", "SYS / SCALE FACTOR"));
  const auto all = read(header +
                        "> 2024 06 24 08 20  0.0000000  0  1\nR01205907925.550                    "
                        "-105331.000          46.000\n")
                       .at(0)
                       .observations;
  EXPECT_DOUBLE_EQ(all[0].pseudorange, 205907.92555);
  EXPECT_DOUBLE_EQ(all[0].doppler, -105.331);
  EXPECT_DOUBLE_EQ(all[0].cn0, 46.0);
}

TEST_F(ReadObservations, TimesOfOtherScalesBecomeGps) {
  std::string glonass = kHeader3;
  glonass.replace(glonass.find("GPS"), 3, "GLO");
  EXPECT_DOUBLE_EQ(read(glonass + kEpoch3).at(0).time.second, 116418.0);
  std::string beidou = kHeader3;
  beidou.replace(beidou.find("GPS"), 3, "BDT");
  EXPECT_DOUBLE_EQ(read(beidou + kEpoch3).at(0).time.second, 116414.0);
}

TEST_F(ReadObservations, EventsMayChangeTheTypesAndSlipsArePassedOver) {
  const std::string more =
      "> 2024 06 24 08 20  0.5000000  6  1\n"
      "G05                        1.000\n"
      ">                              4  1\n" +
      header_line("R    2 D1C C1C", "SYS / # / OBS TYPES") +
      "> 2024 06 24 08 20  1.0000000  0  1\n"
      "R01      -105.331    20590792.555\n";
  const auto epochs = read(kHeader3 + kEpoch3 + more);
  ASSERT_EQ(epochs.size(), 2u);
  ASSERT_EQ(epochs[1].observations.size(), 1u);
  EXPECT_DOUBLE_EQ(epochs[1].observations[0].pseudorange, 20590792.555);
  EXPECT_DOUBLE_EQ(epochs[1].observations[0].doppler, -105.331);
}

TEST_F(ReadObservations, Version2HasFiveObservationsALineAndTwelveSatellites) {
  std::string epoch =
      " 24 06 24 08 20 00.2500000  0 13G05R01G07G08G09G10G11G12G13G14G15G16\n"
      "                                 17\n";
  for (int i = 0; i < 13; ++i) {
    const std::string tenths = std::to_string(100 + i);
    epoch += i == 1 ? "                 108205345.40917      -105.331    20590" + tenths + ".555 8\n\n"
                    : "  20590" + tenths + ".555   108205345.40917      -105.331\n        46.938\n";
  }
  const auto epochs = read(kHeader2 + epoch);
  ASSERT_EQ(epochs.size(), 1u);
  EXPECT_DOUBLE_EQ(epochs[0].time.second, 116400.25);
  const auto& all = epochs[0].observations;
  ASSERT_EQ(all.size(), 13u);
  EXPECT_DOUBLE_EQ(all[0].pseudorange, 20590100.555);
  EXPECT_DOUBLE_EQ(all[0].doppler, -105.331);
  EXPECT_DOUBLE_EQ(all[0].cn0, 46.938);
  EXPECT_EQ(all[1].satellite, (SatelliteId{Constellation::kGlonass, 1}));
  EXPECT_DOUBLE_EQ(all[1].pseudorange, 20590101.555);
  EXPECT_DOUBLE_EQ(all[1].cn0, 50.5);
  EXPECT_EQ(all[12].satellite, (SatelliteId{Constellation::kGps, 17}));
  EXPECT_DOUBLE_EQ(all[12].pseudorange, 20590112.555);
}

TEST_F(ReadObservations, AnEpochThatTheFileBreaksOffInIsLeftOut) {
  using Reasons = std::vector<std::string>;
  std::string next = kEpoch3;
  next.replace(next.find("20  0.0"), 7, "20  1.0");
  const std::string whole = kHeader3 + kEpoch3 + next;
  EXPECT_EQ(left_out(whole), Reasons());
  const std::size_t begin = whole.size() - next.size();
  EXPECT_EQ(left_out(whole.substr(0, begin + next.find("G07"))),
            Reasons{"14: the file ends within an epoch"});
  for (std::size_t size = begin + 1; size < whole.size(); size += 13) {
    EXPECT_EQ(read(whole.substr(0, size)).size(), 1u) << size;
    EXPECT_EQ(left_out(whole.substr(0, size)).size(), 1u) << size;
  }
  // A number whose last digits are missing is no measurement.
  EXPECT_EQ(left_out(whole.substr(0, whole.size() - 3)), Reasons{"17: the file ends within this line"});
}

TEST_F(ReadObservations, AnEpochThatIsNoLaterIsLeftOut) {
  const std::string content = kHeader3 + kEpoch3 + kEpoch3 + replaced(kEpoch3, "08 20", "08 19") +
                              replaced(kEpoch3, "08 20", "08 21");
  const auto epochs = read(content);
  ASSERT_EQ(epochs.size(), 2u);
  EXPECT_DOUBLE_EQ(epochs[1].time.second, 116460.0);
  EXPECT_EQ(epochs[1].observations.size(), 3u);
  EXPECT_EQ(left_out(content),
            (std::vector<std::string>{"13: time does not increase", "18: time does not increase"}));
}

}  // namespace
}  // namespace multipath_localization
