#include <gtest/gtest.h>

#include <cmath>

#include "broadcast.hpp"
#include "multipath_localization/rinex/line_reader.hpp"
#include "multipath_localization/rinex/observation_file.hpp"

namespace multipath_localization {
namespace {

const std::string kHeader3 =
    header_line("     3.04           OBSERVATION DATA    M", "RINEX VERSION / TYPE") +
    header_line("G    8 C1C L1C D1C S1C C1W D1W S1W C2W", "SYS / # / OBS TYPES") +
    header_line("R    4 C1C L1C D1C S1C", "SYS / # / OBS TYPES") +
    header_line("C    5 C6I C2I L2I D2I S2I", "SYS / # / OBS TYPES") +
    header_line("S    1 C1C", "SYS / # / OBS TYPES") +
    header_line("  2024     6    24     8    20    0.0000000     GPS", "TIME OF FIRST OBS") +
    header_line("", "END OF HEADER");
const std::string kEpoch3 =
    "> 2024 06 24 08 20  0.0000000  0  4\n"
    "G05  20590792.555 7 108205345.40907      -105.331 7        46.938    20590793.111         -105.300      "
    "    45.000\n"
    "G07                                                                  26127502.600\n"
    "C03  37529157.793 7  37529162.330 7 195424197.82907       172.632 7        44.219\n"
    "S29  38000000.000\n";

const std::string kHeader2 =
    header_line("     2.11           OBSERVATION DATA    M: MIXED", "RINEX VERSION / TYPE") +
    header_line("     6    C1    L1    D1    P1    P2    S1", "# / TYPES OF OBSERV") +
    header_line("  2024    06    24    08    20   00.0000000     GPS", "TIME OF FIRST OBS") +
    header_line("", "END OF HEADER");

class ReadObservations : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<RawEpoch> read(const std::string& content) const {
    return read_observations(folder_.write("obs", content)).epochs;
  }

  [[nodiscard]] std::vector<std::string> left_out(const std::string& content) const {
    std::vector<std::string> reasons = read_observations(folder_.write("obs", content)).left_out;
    for (std::string& reason : reasons) reason.erase(0, folder_.path().size() + 5);
    return reasons;
  }

  [[nodiscard]] std::string refusal(const std::string& content) const {
    try {
      (void)read(content);
    } catch (const RinexError& error) {
      return std::string(error.what()).substr(folder_.path().size() + 5);
    }
    return "";
  }

  TemporaryFolder folder_;
};

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
  std::string earlier = kEpoch3;
  std::string later = kEpoch3;
  earlier.replace(earlier.find("08 20"), 5, "08 19");
  later.replace(later.find("08 20"), 5, "08 21");
  const std::string content = kHeader3 + kEpoch3 + kEpoch3 + earlier + later;
  const auto epochs = read(content);
  ASSERT_EQ(epochs.size(), 2u);
  EXPECT_DOUBLE_EQ(epochs[1].time.second, 116460.0);
  EXPECT_EQ(epochs[1].observations.size(), 3u);
  EXPECT_EQ(left_out(content),
            (std::vector<std::string>{"13: time does not increase", "18: time does not increase"}));
}

TEST_F(ReadObservations, RefusesWithLineAndReason) {
  const std::string epoch = "> 2024 06 24 08 20  0.0000000  0  1\n";
  EXPECT_EQ(refusal(kHeader3.substr(0, 300)), "4: the file ends within this line");
  EXPECT_EQ(refusal(kHeader3.substr(0, kHeader3.find("S    1"))), "4: the file ends within its header");
  EXPECT_EQ(refusal(kHeader3 + "G05\n"), "8: no epoch begins here");
  EXPECT_EQ(refusal(kHeader3 + epoch + "E05  20590792.555\n"), "9: 'E05' is of a system without types");
  EXPECT_EQ(refusal(kHeader3 + epoch + "G\n"), "9: 'G' is no satellite");
  EXPECT_EQ(refusal(kHeader3 + epoch + "G-5  20590792.555\n"), "9: 'G-5' is no satellite");
  EXPECT_EQ(refusal(kHeader3 + epoch + "G05  2059x792.555\n"), "9: '2059x792.555' is not a number");
  EXPECT_EQ(refusal(kHeader3 + "> 2024 06 24 08 20  0.0000000  0  2\nR05  20590792.555\nR05  20590792.555\n"),
            "10: a satellite for the second time in an epoch");
  EXPECT_EQ(refusal(kHeader3 + "> 2024 06 24 08 20  0.0000000  0 -1\n"), "8: no such number of satellites");
  EXPECT_EQ(refusal(kHeader3 + "> 2024 06 24 08 20  0.0000000  7  1\n"), "8: no such flag of an epoch");
  EXPECT_EQ(refusal(kHeader3 + "> 2024 06 31 08 20  0.0000000  0  1\n"), "8: no such date and time");
  EXPECT_EQ(refusal(navigation_header()), "1: type 'N' is no observations");
}

TEST_F(ReadObservations, NoTruncationAndNoFlippedByteDoesHarm) {
  const std::string whole2 =
      kHeader2 + " 24 06 24 08 20 00.2500000  0  1G05\n  20590100.555   108205345.40917\n\n";
  for (const std::string& whole : {kHeader3 + kEpoch3, whole2}) {
    for (std::size_t size = 0; size < whole.size(); size += 37) (void)refusal(whole.substr(0, size));
    for (std::size_t place = 0; place < whole.size(); place += 23) {
      for (const char byte : {'\0', '\n', '9', '-', 'E', '\xff'}) {
        std::string broken = whole;
        broken[place] = byte;
        (void)refusal(broken);
      }
    }
  }
}

}  // namespace
}  // namespace multipath_localization
