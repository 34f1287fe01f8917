#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "multipath_localization/models/pseudorange/inter_system_bias.hpp"

namespace multipath_localization {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

PseudorangeSolution solution_with(double gps, double glonass, double galileo) {
  PseudorangeSolution solution;
  solution.clock = {gps, glonass, galileo, kNan, kNan};
  return solution;
}

TEST(InterSystemBias, KnowsNothingAtFirst) {
  const InterSystemBias bias(10.0);
  EXPECT_FALSE(bias.reference());
  EXPECT_TRUE(std::isinf(bias.variance(Constellation::kGps)));
}

TEST(InterSystemBias, TakesDifferencesToTheFirstConstellationOnce) {
  InterSystemBias bias(10.0);
  bias.adopt(solution_with(1000.0, 993.0, kNan));
  bias.adopt(solution_with(2000.0, 2050.0, 2004.0));
  EXPECT_EQ(bias.reference(), Constellation::kGps);
  EXPECT_EQ(bias.variance(Constellation::kGps), 0.0);
  EXPECT_EQ(bias.mean(Constellation::kGlonass), -7.0);
  EXPECT_EQ(bias.variance(Constellation::kGlonass), 100.0);
  EXPECT_EQ(bias.mean(Constellation::kGalileo), 4.0);
  EXPECT_TRUE(std::isinf(bias.variance(Constellation::kBeidou)));
}

TEST(InterSystemBias, RunsWithoutGps) {
  InterSystemBias bias(10.0);
  bias.adopt(solution_with(kNan, 5.0, 8.0));
  EXPECT_EQ(bias.reference(), Constellation::kGlonass);
  EXPECT_EQ(bias.mean(Constellation::kGalileo), 3.0);
}

TEST(InterSystemBias, AveragesWhatItSees) {
  InterSystemBias bias(10.0);
  bias.adopt(solution_with(0.0, 0.0, kNan));
  for (int i = 0; i < 20; ++i) {
    const double noise = i % 2 == 0 ? 4.0 : -4.0;
    bias.correct(Constellation::kGlonass, -7.0 + noise - bias.mean(Constellation::kGlonass), 16.0);
  }
  EXPECT_NEAR(bias.mean(Constellation::kGlonass), -7.0, 0.4);
  EXPECT_NEAR(bias.variance(Constellation::kGlonass), 1.0 / (1.0 / 100.0 + 20.0 / 16.0), 1e-9);
}

TEST(InterSystemBias, WandersAndForgets) {
  InterSystemBias bias(10.0);
  bias.adopt(solution_with(0.0, 6.0, kNan));
  bias.wander(100.0);
  EXPECT_GT(bias.variance(Constellation::kGlonass), 100.0);
  EXPECT_EQ(bias.variance(Constellation::kGps), 0.0);
  bias.forget();
  EXPECT_FALSE(bias.reference());
}

TEST(InterSystemBias, IgnoresWhatIsNotFinite) {
  InterSystemBias bias(10.0);
  bias.adopt(solution_with(0.0, 6.0, kNan));
  bias.correct(Constellation::kGlonass, kNan, 4.0);
  bias.correct(Constellation::kGlonass, 4.0, 0.0);
  bias.correct(Constellation::kBeidou, 4.0, 1.0);
  EXPECT_EQ(bias.mean(Constellation::kGlonass), 6.0);
  EXPECT_EQ(bias.mean(Constellation::kBeidou), 0.0);
}

TEST(InterSystemBias, OfInfiniteSigmaLeavesAllClocksFree) {
  InterSystemBias bias(std::numeric_limits<double>::infinity());
  bias.adopt(solution_with(0.0, 6.0, kNan));
  EXPECT_FALSE(bias.reference());
  EXPECT_TRUE(std::isinf(bias.variance(Constellation::kGps)));
  EXPECT_EQ(bias.mean(Constellation::kGlonass), 0.0);
}

}  // namespace
}  // namespace multipath_localization
