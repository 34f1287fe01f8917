#include <gtest/gtest.h>

#include "evaluation/fix_claims.hpp"
#include "temporary_folder.hpp"

namespace multipath_localization {
namespace {

class FixClaims : public testing::Test {
 protected:
  CsvTable table(const std::string& bytes) {
    folder_.write("fix.csv", bytes);
    return CsvTable(folder_.path() + "/fix.csv", {"t"});
  }

  TemporaryFolder folder_;
};

TEST_F(FixClaims, AreReadWhereTheyAreThere) {
  const CsvTable told = table("t,status,level\n1,2,4\n2,-1,0\n");
  EXPECT_EQ(status_of(told, 0), FixStatus::kGroundBased);
  EXPECT_EQ(level_of(told, 0), FixLevel::kFixed);
  EXPECT_EQ(status_of(told, 1), FixStatus::kNone);
  EXPECT_EQ(level_of(told, 1), FixLevel::kUntold);
  const CsvTable bare = table("t\n1\n");
  EXPECT_EQ(status_of(bare, 0), FixStatus::kSingle);
  EXPECT_EQ(level_of(bare, 0), FixLevel::kUntold);
}

TEST_F(FixClaims, AreRefusedWhereTheyAreNone) {
  const CsvTable wrong = table("t,status,level\n1,3,5\n2,0.5,-1\n");
  for (const std::size_t row : {0U, 1U}) {
    EXPECT_THROW(status_of(wrong, row), DriveError);
    EXPECT_THROW(level_of(wrong, row), DriveError);
  }
}

}  // namespace
}  // namespace multipath_localization
