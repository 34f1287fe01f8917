#include <gtest/gtest.h>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/guidance/path_progress.hpp"

namespace multipath_localization {
namespace {

const PassingRule kStop{1.0, 5.0, true, 1.4, false};

TEST(PathProgress, PassesAWaypointByRadiusByItsLineAndBeyondItAlongThePath) {
  const std::vector<Eigen::Vector2d> line = {{0.0, 0.0}, {20.0, 0.0}, {40.0, 0.0}};
  PathProgress far(line, 1, kStop, {0.0, 0.0});
  EXPECT_FALSE(far.passes({18.9, 0.0, 0.0}));
  EXPECT_TRUE(far.passes({19.1, 0.0, 0.0}));
  PathProgress aside(line, 1, kStop, {0.0, 0.0});
  EXPECT_FALSE(aside.passes({19.9, 3.0, 0.0}));
  EXPECT_FALSE(aside.passes({20.1, 6.0, 0.0}));
  EXPECT_TRUE(aside.passes({20.1, 3.0, 0.0}));
  PathProgress cut({{0.0, 0.0}, {20.0, 0.0}, {20.0, 20.0}}, 1, kStop, {0.0, 0.0});
  EXPECT_FALSE(cut.passes({16.0, 0.0, 1.6}));
  EXPECT_TRUE(cut.passes({19.5, 3.0, 1.6}));
}

TEST(PathProgress, StopsAtTheLastWaypointAndNotWhereItIsNear) {
  PathProgress progress({{0.0, 0.0}, {10.0, 0.0}}, 1, kStop, {0.0, 0.0});
  EXPECT_FALSE(progress.passes({9.5, 0.0, 0.0}));
  EXPECT_FALSE(progress.passes({9.9, 0.2, 0.0}));
  EXPECT_TRUE(progress.passes({9.98, 0.2, 0.0}));
  progress.pass_next();
  EXPECT_TRUE(progress.done());
  EXPECT_FALSE(progress.passes({9.98, 0.2, 0.0}));
}

TEST(PathProgress, HasArrivedWhereTheGoalIsNearAndNoLongerAhead) {
  PathProgress beside({{0.0, 0.0}, {-0.5, 0.0}}, 1, kStop, {0.0, 0.0});
  EXPECT_TRUE(beside.passes({0.0, 0.0, 0.0}));
  PathProgress before({{0.0, 0.0}, {-0.5, 0.0}}, 1, kStop, {0.0, 0.0});
  EXPECT_FALSE(before.passes({0.0, 0.0, kPi}));
}

TEST(PathProgress, StaysOnTheWayOutWhereThatAndTheWayBackAreOne) {
  PathProgress progress({{0.0, 0.0}, {10.0, 0.0}, {0.0, 0.0}}, 1, kStop, {0.0, 0.0});
  for (double x = 0.0; x < 8.9; x += 0.05) {
    ASSERT_FALSE(progress.passes({x, 0.01, 0.0}));
    ASSERT_NEAR(progress.station(), x, 1e-9);
  }
  ASSERT_TRUE(progress.passes({9.1, 0.0, 0.0}));
  progress.pass_next();
  EXPECT_GE(progress.station(), 10.0);
  progress.passes({9.0, 0.0, kPi});
  EXPECT_NEAR(progress.station(), 11.0, 1.0);
  for (double x = 9.0; x > 5.0; x -= 0.05) progress.passes({x, 0.01, kPi});
  EXPECT_NEAR(progress.station(), 15.0, 0.1);
}

TEST(PathProgress, TellsTheDeviationAlsoBeyondTheEnd) {
  PathProgress progress({{0.0, 0.0}, {10.0, 0.0}}, 1, kStop, {0.0, 0.0});
  progress.passes({4.0, -2.0, 0.0});
  EXPECT_NEAR(progress.deviation({4.0, -2.0}), 2.0, 1e-9);
  progress.passes({14.0, 7.0, 0.0});
  EXPECT_NEAR(progress.deviation({14.0, 7.0}), 7.0, 1e-9);
}

TEST(PathProgress, KeepsThePlacesBehindThatBendThePath) {
  PathProgress progress({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {10.2, 10.2}, {20.0, 20.0}}, 1, kStop,
                        {0.0, 0.0});
  EXPECT_EQ(progress.behind().size(), 1U);
  progress.pass_next();
  EXPECT_EQ(progress.behind().back(), Eigen::Vector2d(10.0, 0.0));
  progress.pass_next();
  progress.pass_next();
  EXPECT_EQ(progress.left(), 1U);
  EXPECT_EQ(progress.behind().back(), Eigen::Vector2d(10.2, 10.2));
  EXPECT_EQ(progress.behind().front(), Eigen::Vector2d(10.0, 0.0));
  progress.pass_next();
  EXPECT_EQ(progress.behind().back(), Eigen::Vector2d(20.0, 20.0));
}

TEST(PathProgress, IsNotCarriedAheadByAWaypointPassedOnAStraightLine) {
  PathProgress progress({{0.0, 0.0}, {20.0, 0.0}, {40.0, 0.0}}, 1, kStop, {19.0, 0.0});
  EXPECT_TRUE(progress.passes({19.1, 0.3, 0.0}));
  progress.pass_next();
  EXPECT_NEAR(progress.station(), 19.1, 1e-9);
  EXPECT_NEAR(progress.deviation({19.1, 0.3}), 0.3, 1e-9);
  EXPECT_NEAR(progress.station_ahead(0), 40.0, 1e-9);
}

}  // namespace
}  // namespace multipath_localization
