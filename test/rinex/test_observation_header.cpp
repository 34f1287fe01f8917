#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/observation_header.hpp"

namespace multipath_localization {
namespace {

class ReadHeader : public ::testing::Test {
 protected:
  [[nodiscard]] ObservationHeader header(const FileKind& kind, const std::string& lines) const {
    LineReader in(folder_.write("header", lines));
    ObservationHeader all(kind);
    while (in.next()) all.read_line(in);
    notices_ = all.check(in);
    return all;
  }

  TemporaryFolder folder_;
  mutable std::vector<std::string> notices_;
  const FileKind version_3_{3.04, 'O', 'M'};
  const FileKind version_2_{2.11, 'O', 'G'};
};

TEST_F(ReadHeader, TypesGoOnOverLinesForEachSystem) {
  const ObservationHeader all = header(
      version_3_,
      header_line("G   14 C1C L1C D1C S1C C2W L2W D2W S2W C2L L2L D2L S2L C5Q", "SYS / # / OBS TYPES") +
          header_line("       L5Q", "SYS / # / OBS TYPES") +
          header_line("R    1 C1P", "SYS / # / OBS TYPES"));
  ASSERT_EQ(all.types('G').size(), 14u);
  EXPECT_EQ(all.types('G')[0], "C1C");
  EXPECT_EQ(all.types('G')[13], "L5Q");
  EXPECT_EQ(all.types('R'), std::vector<std::string>{"C1P"});
  EXPECT_TRUE(all.types('E').empty());
}

TEST_F(ReadHeader, Version2HasOneListForAll) {
  const ObservationHeader all = header(
      version_2_,
      header_line("    10    C1    L1    D1    S1    P2    L2    D2    S2    C2", "# / TYPES OF OBSERV") +
          header_line("          C5", "# / TYPES OF OBSERV"));
  ASSERT_EQ(all.types('G').size(), 10u);
  EXPECT_EQ(all.types('R')[9], "C5");
}

TEST_F(ReadHeader, ScalesAreOneUnlessSaid) {
  const ObservationHeader all =
      header(version_3_, header_line("G    1 C1C", "SYS / # / OBS TYPES") +
                             header_line("G  100  2 L1C L2W", "SYS / SCALE FACTOR") +
                             header_line("R   10", "SYS / SCALE FACTOR"));
  EXPECT_EQ(all.scale('G', "L2W"), 100.0);
  EXPECT_EQ(all.scale('G', "C1C"), 1.0);
  EXPECT_EQ(all.scale('R', "C1C"), 10.0);
  EXPECT_EQ(all.scale('E', "C1C"), 1.0);
}

TEST_F(ReadHeader, ScalesGoOnOverLines) {
  const char* const label = "SYS / SCALE FACTOR";
  const ObservationHeader all =
      header(version_3_, header_line("G    1 C1C", "SYS / # / OBS TYPES") +
                             header_line("G  100 13 C1C L1C D1C S1C C2W L2W D2W S2W C2L L2L D2L S2L", label) +
                             header_line("          C5Q", label) + header_line("E   10", label));
  EXPECT_EQ(all.scale('G', "C1C"), 100.0);
  EXPECT_EQ(all.scale('G', "C5Q"), 100.0);
  EXPECT_EQ(all.scale('G', "L5Q"), 1.0);
  EXPECT_EQ(all.scale('E', "C5Q"), 10.0);
  EXPECT_THROW((void)header(version_3_, header_line("G    1 C1C", "SYS / # / OBS TYPES") +
                                            header_line("          C5Q", label)),
               RinexError);
}

TEST_F(ReadHeader, TimeScaleIsThatOfTheFirstObservationElseTheSystems) {
  const std::string types = header_line("R    1 C1C", "SYS / # / OBS TYPES");
  EXPECT_EQ(header({3.04, 'O', 'R'}, types).time_scale(), TimeScale::kUtc);
  EXPECT_EQ(header({3.04, 'O', 'C'}, types).time_scale(), TimeScale::kBeidou);
  EXPECT_EQ(header(version_3_, types).time_scale(), TimeScale::kGps);
  std::string first = "  2024     6    24     8    20    0.0000000     GPS";
  EXPECT_EQ(header({3.04, 'O', 'R'}, types + header_line(first, "TIME OF FIRST OBS")).time_scale(),
            TimeScale::kGps);
  EXPECT_EQ(header(version_3_, types + header_line("    17", "LEAP SECONDS")).leap_seconds(),
            std::optional<int>(17));
}

TEST_F(ReadHeader, WhereCountsAreWrongTheNamesCount) {
  const char* const label = "SYS / # / OBS TYPES";
  EXPECT_EQ(header(version_3_, header_line("G    2 C1C L1C", label)).types('G').size(), 2u);
  EXPECT_TRUE(notices_.empty());
  for (const char* count : {"  1", "  3", " -1", "   ", " x "}) {
    const auto all = header(version_3_, header_line("G  " + std::string(count) + " C1C L1C", label));
    EXPECT_EQ(all.types('G'), (std::vector<std::string>{"C1C", "L1C"})) << count;
    ASSERT_EQ(notices_.size(), 1u) << count;
    EXPECT_NE(notices_[0].find("names 2 types of observations of G"), std::string::npos) << notices_[0];
  }
  const auto old = header(version_2_, header_line("     1    C1    L1", "# / TYPES OF OBSERV"));
  EXPECT_EQ(old.types('G').size(), 2u);
  EXPECT_EQ(notices_.size(), 1u);
}

TEST_F(ReadHeader, RefusesWhatNamesNoTypes) {
  const char* const label = "SYS / # / OBS TYPES";
  EXPECT_THROW((void)header(version_3_, ""), RinexError);
  EXPECT_THROW((void)header(version_3_, header_line("G    0", label)), RinexError);
  EXPECT_THROW((void)header(version_3_, header_line("       C1C", label)), RinexError);
  EXPECT_THROW((void)header(version_3_,
                            header_line("G    1 C1C", label) + header_line("G    0", "SYS / SCALE FACTOR")),
               RinexError);
}

}  // namespace
}  // namespace multipath_localization
