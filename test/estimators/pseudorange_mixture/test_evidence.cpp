#include <gtest/gtest.h>

#include <limits>

#include "estimators/pseudorange_mixture/evidence.hpp"

namespace multipath_localization {
namespace {

TEST(Evidence, IsWorthTheTimeOverWhichItWasGathered) {
  EXPECT_DOUBLE_EQ(evidence_share(0.2, 0.0, 30.0), 0.2 / 30.0);
  EXPECT_DOUBLE_EQ(evidence_share(100.0, 0.0, 30.0), 1.0) << "no range counts more than once";
}

TEST(Evidence, OfASatelliteThatComesIntoViewCountsAtOnce) {
  EXPECT_DOUBLE_EQ(evidence_share(0.2, std::numeric_limits<double>::infinity(), 30.0), 1.0);
  EXPECT_DOUBLE_EQ(evidence_share(0.2, 15.0, 30.0), 0.5);
  EXPECT_DOUBLE_EQ(evidence_share(0.2, 0.1, 30.0), evidence_share(0.2, 0.0, 30.0));
}

TEST(Evidence, PlacesAreLessProbableTheFurtherTheyAreFromWhereTheOthersAre) {
  EXPECT_DOUBLE_EQ(log_probability_of_place(9.0, 5.0, 40.0), 0.0);
  EXPECT_DOUBLE_EQ(log_probability_of_place(90.0, 5.0, 40.0), -2.0);
  EXPECT_DOUBLE_EQ(log_probability_of_place(90.0, 50.0, 40.0), 0.0) << "who knows little does not judge";
}

}  // namespace
}  // namespace multipath_localization
