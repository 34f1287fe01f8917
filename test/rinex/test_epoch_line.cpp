#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/epoch_line.hpp"

namespace multipath_localization {
namespace {

class ReadEpochLine : public ::testing::Test {
 protected:
  [[nodiscard]] LineReader at(const std::string& lines) const {
    LineReader in(folder_.write("epoch", lines));
    in.next();
    return in;
  }

  const TemporaryFolder folder_;
};

TEST_F(ReadEpochLine, TellsTimeFlagAndCount) {
  for (const bool version_2 : {true, false}) {
    LineReader in =
        at(version_2 ? " 24  6 24  8 20  1.5000000  1  2G05R 7\n" : "> 2024 06 24 08 20  1.5000000  1  2\n");
    ASSERT_TRUE(epoch_begins(in, version_2));
    const EpochLine line = read_epoch_line(in, version_2);
    EXPECT_EQ(line.flag, 1);
    EXPECT_EQ(line.count, 2);
    EXPECT_DOUBLE_EQ(line.time(in, TimeScale::kGps, std::nullopt).second, 116401.5);
    EXPECT_EQ(line.satellites(in),
              version_2 ? (std::vector<std::string>{"G05", "R 7"}) : std::vector<std::string>());
  }
}

TEST_F(ReadEpochLine, DataAreNoEpoch) {
  for (const char* line : {"", "  20590792.555 7 108205345.409 7      -105.331 7", "G05  20590792.555",
                           "  24 06 24 08 20  1.5000000  0  2", "                        46.938"}) {
    EXPECT_FALSE(epoch_begins(at(std::string(line) + "\n"), true)) << line;
    EXPECT_FALSE(epoch_begins(at(std::string(line) + "\n"), false)) << line;
  }
}

TEST_F(ReadEpochLine, WantsAFlagWhereItBelongs) {
  for (const char* line :
       {"> 2024 06 24 08 20  1.5000000", "> 2024 06 24 08 20  1.5000000        2",
        "> 2024 06 24 08 20  1.5000000  8  2", "> 2024 06 24 08 20  1.5000000  0", "> ", ">"}) {
    LineReader in = at(std::string(line) + "\n");
    EXPECT_THROW((void)read_epoch_line(in, false), RinexError) << line;
  }
}

}  // namespace
}  // namespace multipath_localization
