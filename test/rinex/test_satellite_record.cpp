#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/satellite_record.hpp"

namespace multipath_localization {
namespace {

class Record : public ::testing::Test {
 protected:
  Record() : in_(folder_.write("header", header_line("C    5 C5P C1P D1P C2I D2I", "SYS / # / OBS TYPES"))) {
    in_.next();
    header_.read_line(in_);
  }

  [[nodiscard]] SatelliteRecord record(const std::string& text) const { return {in_, header_, 'C', text}; }

  const SatelliteId satellite_{Constellation::kBeidou, 20};
  const TemporaryFolder folder_;
  LineReader in_;
  ObservationHeader header_{{3.04, 'O', 'M'}};
};

TEST_F(Record, BeidouIsReadOnB1cToo) {
  const std::string b1c = "                  22000000.123 8       100.250";
  const auto taken = record(b1c).observation(satellite_);
  ASSERT_TRUE(taken);
  EXPECT_TRUE(taken->b1c);
  EXPECT_DOUBLE_EQ(taken->pseudorange, 22000000.123);
  EXPECT_DOUBLE_EQ(taken->doppler, 100.25);
  EXPECT_DOUBLE_EQ(taken->cn0, 50.5);
  const std::string both = b1c + "    22000003.000";
  EXPECT_FALSE(record(both).observation(satellite_)->b1c) << "B1I is taken before";
}

TEST_F(Record, NamesPseudorangesThatAreNotRead) {
  const std::string b2a = "  22000000.123";
  EXPECT_FALSE(record(b2a).observation(satellite_));
  EXPECT_EQ(record(b2a).pseudoranges(), std::vector<std::string>{"C5P"});
  EXPECT_TRUE(record("").pseudoranges().empty());
}

TEST_F(Record, RefusesANumberThatIsCutOff) {
  for (const char* cut : {"22000", "22000000.", "22000000.1"}) {
    const std::string text = std::string(16, ' ') + "  " + cut;
    EXPECT_THROW((void)record(text).observation(satellite_), RinexError) << cut;
  }
}

}  // namespace
}  // namespace multipath_localization
