#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "observation_texts.hpp"
#include "rinex/observation_file.hpp"

namespace multipath_localization {
namespace {

/// The same epoch `seconds` later.
std::string later(const std::string& epoch, int seconds) {
  return replaced(epoch, "20  0.0", "20  " + std::to_string(seconds) + ".0");
}

TEST_F(ReadObservations, ABadRecordIsLeftOutAlone) {
  const std::map<std::string, std::string> bad = {{"G05", "a satellite for the second time in an epoch"},
                                                  {"G00", "'G00' is no satellite"},
                                                  {"G", "'G' is no satellite"},
                                                  {"G-5", "'G-5' is no satellite"},
                                                  {"X05", "'X05' is of no known satellite system"},
                                                  {"E05", "'E05' is of a system without types"}};
  for (const auto& [name, reason] : bad) {
    const std::string content = kHeader3 + replaced(kEpoch3,
                                                    "G07                                                  "
                                                    "                26127502.600",
                                                    name == "G" ? name : name + "  20590792.555");
    ASSERT_EQ(read(content).size(), 1u) << name;
    EXPECT_EQ(read(content)[0].observations.size(), 2u) << name;
    EXPECT_EQ(left_out(content), std::vector<std::string>{"10: " + reason});
  }
}

TEST_F(ReadObservations, ANumberThatIsNoneCostsItsRecord) {
  for (const char* number : {"          nan", "*************", "  2059x792.555", "          inf"}) {
    const std::string text = std::string(number).substr(0, 13);
    const auto epochs = read(kHeader3 + replaced(kEpoch3, " 20590792.555", text));
    ASSERT_EQ(epochs.size(), 1u) << number;
    EXPECT_EQ(epochs[0].observations.size(), 2u) << number;
  }
  // The last digits of a pseudorange are missing: it would be kilometres off.
  const std::string cut = kHeader3 + replaced(kEpoch3, "26127502.600", "26127");
  EXPECT_EQ(read(cut)[0].observations.size(), 2u);
  EXPECT_NE(left_out(cut).at(0).find("26127' is cut off"), std::string::npos);
}

TEST_F(ReadObservations, ABadEpochsLineCostsThatEpoch) {
  const std::map<std::string, std::string> bad = {
      {"> 2024 06 31 08 20  1.0000000  0  4", "no such date and time"},
      {"> 2024 06 24 08 20  1.0000000  7  4", "no such flag of an epoch"},
      {"> 2024 06 24 08 20  1.0000000  0 -4", "no such number of satellites"},
      {"> 2024 06 24 08 20  1.0000000", "no flag of the epoch in column 32"},
      {"> 2024 0x 24 08 20  1.0000000  0  4", "'0x' is not a number"},
      {"garbage", "no epoch begins here"}};
  for (const auto& [line, reason] : bad) {
    const std::string content = kHeader3 + kEpoch3 +
                                replaced(kEpoch3, "> 2024 06 24 08 20  0.0000000  0  4", line) +
                                later(kEpoch3, 2);
    const auto epochs = read(content);
    ASSERT_EQ(epochs.size(), 2u) << line;
    EXPECT_DOUBLE_EQ(epochs[1].time.second, 116402.0);
    EXPECT_EQ(epochs[1].observations.size(), 3u);
    EXPECT_EQ(left_out(content), std::vector<std::string>{"13: " + reason}) << line;
  }
}

TEST_F(ReadObservations, AnEpochOfFewerOrMoreRecordsHarmsNoOther) {
  const std::string fewer = kHeader3 + replaced(kEpoch3, "0  4\n", "0  9\n") + later(kEpoch3, 1);
  EXPECT_EQ(read(fewer).at(0).observations.size(), 3u);
  EXPECT_EQ(read(fewer).at(1).observations.size(), 3u);
  EXPECT_EQ(left_out(fewer), std::vector<std::string>{"8: an epoch of 9 satellites that ends after 4"});
  const std::string more = kHeader3 + replaced(kEpoch3, "0  4\n", "0  2\n") + later(kEpoch3, 1);
  EXPECT_EQ(read(more).at(0).observations.size(), 2u);
  EXPECT_EQ(read(more).at(1).observations.size(), 3u);
  EXPECT_EQ(left_out(more), std::vector<std::string>{"11: no epoch begins here"});
}

TEST_F(ReadObservations, InVersion2AnEpochOfOtherLinesIsLeftOut) {
  const auto epoch = [](int second, const std::string& lines) {
    return " 24 06 24 08 20 0" + std::to_string(second) + ".0000000  0  2G05G07\n" + lines;
  };
  const std::string good = "  20590100.555\n\n  21590100.555\n\n";
  const std::string missing = "  20590100.555\n\n  21590100.555\n";
  const std::string doubled =
      "  20590100.555\n        46.938\n  20590100.555\n  21590100.555\n        46.938\n";
  for (const std::string& lines : {missing, doubled}) {
    const std::string content = kHeader2 + epoch(0, good) + epoch(1, lines) + epoch(2, good);
    const auto epochs = read(content);
    ASSERT_EQ(epochs.size(), 2u) << "which line is whose cannot be told";
    EXPECT_DOUBLE_EQ(epochs[1].time.second, 116402.0);
    EXPECT_EQ(epochs[1].observations.size(), 2u);
    EXPECT_NE(left_out(content).at(0).find("an epoch of "), std::string::npos) << left_out(content)[0];
  }
}

TEST_F(ReadObservations, AMissingListOfSatellitesCostsItsEpoch) {
  std::string epoch = " 24 06 24 08 20 00.0000000  0 13G01G02G03G04G05G06G07G08G09G10G11G12\n";
  for (int i = 0; i < 13; ++i) epoch += "  20590100.555\n\n";
  const std::string next = " 24 06 24 08 20 01.0000000  0  1G05\n  20590100.555\n\n";
  ASSERT_EQ(read(kHeader2 + epoch + next).size(), 1u);
  EXPECT_EQ(left_out(kHeader2 + epoch + next),
            std::vector<std::string>{"5: an epoch of 13 satellites that lists 12"});
}

TEST_F(ReadObservations, ColumnsOfAnEpochsLineMayBeMoved) {
  const std::string epoch2 = " 24 06 24 08 20 00.2500000  0  1G05\n  20590100.555\n\n";
  for (const std::string& content :
       {kHeader3 + replaced(kEpoch3, "0.0000000  0  4", "0.0000000 0  4"),
        kHeader3 + replaced(kEpoch3, "> 2024", ">2024"), kHeader3 + replaced(kEpoch3, "> 2024", ">  2024"),
        kHeader2 + replaced(epoch2, "0  0  1", "0 0  1"),
        kHeader2 + replaced(epoch2, "0  0  1", "0   0  1")}) {
    ASSERT_EQ(read(content).size(), 1u) << content;
    EXPECT_EQ(read(content)[0].observations[0].satellite.number, 5);
    EXPECT_TRUE(left_out(content).empty());
  }
}

TEST_F(ReadObservations, FilesMayBeJoined) {
  const std::string other =
      replaced(kHeader3, "C1C L1C D1C S1C C1W D1W S1W C2W", "C1W L1C D1C S1C C1C D1W S1W C2W");
  const auto epochs = read(kHeader3 + kEpoch3 + "\xef\xbb\xbf" + other + later(kEpoch3, 1) + "\x1a");
  ASSERT_EQ(epochs.size(), 2u);
  EXPECT_DOUBLE_EQ(epochs[0].observations[0].pseudorange, 20590792.555);
  EXPECT_DOUBLE_EQ(epochs[1].observations[0].pseudorange, 20590793.111) << "by the second header";
  EXPECT_EQ(read(kHeader3 + later(kEpoch3, 1) + kHeader3 + kEpoch3).size(), 2u) << "the later one first";
  // A header that cannot be used costs what is under it.
  const std::string broken = header_line("     9.00           OBSERVATION DATA    M", "RINEX VERSION / TYPE");
  const std::string content = kHeader3 + kEpoch3 + broken + later(kEpoch3, 1) + kHeader3 + later(kEpoch3, 2);
  EXPECT_EQ(read(content).size(), 2u);
  EXPECT_EQ(left_out(content).size(), 1u);
}

TEST_F(ReadObservations, OneWrongDateCostsItsEpoch) {
  const std::string wrong = replaced(later(kEpoch3, 1), "2024", "2034");
  const std::string content = kHeader3 + kEpoch3 + wrong + later(kEpoch3, 2) + later(kEpoch3, 3);
  EXPECT_EQ(read(content).size(), 3u);
  EXPECT_EQ(left_out(content), std::vector<std::string>{"13: time does not increase"});
}

TEST_F(ReadObservations, HeadersMayBeCutOffAndLackTheirEnd) {
  std::string cut;
  std::istringstream lines(kHeader3);
  for (std::string line; std::getline(lines, line);) cut += line.substr(0, 72) + "\n";
  EXPECT_EQ(read(cut + kEpoch3).at(0).observations.size(), 3u);
  const std::string endless = replaced(kHeader3, header_line("", "END OF HEADER"), "");
  EXPECT_EQ(read(endless + kEpoch3).at(0).observations.size(), 3u);
}

TEST_F(ReadObservations, ABadLineOfTheHeaderIsNoticed) {
  std::string header = kHeader3;
  header.insert(header.find("S    1"), header_line("  xx", "LEAP SECONDS"));
  const ObservationLog log = read_observations(folder_.write("obs", header + kEpoch3));
  EXPECT_EQ(log.epochs.size(), 1u);
  ASSERT_EQ(log.notices.size(), 1u);
  EXPECT_NE(log.notices[0].find("5: 'xx' is not a number"), std::string::npos);
}

TEST_F(ReadObservations, WhatIsNotReadIsCounted) {
  const std::string content = kHeader3 + replaced(kEpoch3, "C03  37529157.793 7  37529162.330 7",
                                                  "C03  37529157.793 7                 ");
  const ObservationLog log = read_observations(folder_.write("obs", content));
  EXPECT_EQ(log.unread, (std::map<std::string, std::size_t>{{"BEIDOU C6I", 1}, {"SBAS C1C", 1}}));
}

TEST_F(ReadObservations, EventsWithoutTimeOrCountArePassedOver) {
  const std::string marks =
      "> 2024 06 24 08 20  0.4232250  5\n> 2024 06 24 08 20  0.5000000  5  0\n"
      ">                              2  0\n>                              4  1\n" +
      header_line("A SPLICE", "COMMENT");
  EXPECT_EQ(read(kHeader3 + kEpoch3 + marks + later(kEpoch3, 1)).size(), 2u);
  const std::string epoch = " 24 06 24 08 20 00.0000000  0  1G05\n  20590100.555\n\n";
  const std::string marks2 = "\n                            4  1\n" + header_line("A SPLICE", "COMMENT") +
                             " 24 06 24 08 20 00.4232250  5  0\n";
  const std::string content = kHeader2 + epoch + marks2 + replaced(epoch, "00.0", "01.0");
  EXPECT_EQ(read(content).size(), 2u);
  EXPECT_TRUE(left_out(content).empty());
}

TEST_F(ReadObservations, RefusesAFileThatIsNone) {
  EXPECT_EQ(refusal(kHeader3.substr(0, 300)), "4: the file ends within this line");
  EXPECT_EQ(refusal(kHeader3.substr(0, kHeader3.find("S    1"))), "4: the file ends within its header");
  EXPECT_EQ(refusal(navigation_header()), "1: type 'N' is no observations");
  EXPECT_EQ(refusal("hello\n"), "1: not a RINEX file");
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
