#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "multipath_localization/guidance/route.hpp"

namespace multipath_localization {
namespace {

const std::vector<Eigen::Vector2d> kLine = {{0.0, 0.0}, {10.0, 0.0}, {20.0, 5.0}};

TEST(Route, CountsWaypointsRoundAndRound) {
  Route route(kLine);
  EXPECT_FALSE(route.passed_all());
  for (int i = 0; i < 4; ++i) route.pass();
  EXPECT_EQ(route.target(), 1U);
  EXPECT_EQ(route.rounds(), 1);
  EXPECT_DOUBLE_EQ(route.progress(), 4.0 / 3.0);
  EXPECT_EQ(route.waypoint(0), kLine[1]);
  EXPECT_EQ(route.waypoint(2), kLine[0]);
  route.set_passed(3);
  EXPECT_TRUE(route.passed_all());
  EXPECT_DOUBLE_EQ(route.extent(), kLine[2].norm());
}

TEST(Route, OfNoWaypointsIsNeverPassed) {
  const Route route;
  EXPECT_TRUE(route.empty());
  EXPECT_EQ(route.target(), 0U);
  EXPECT_EQ(route.progress(), 0.0);
  EXPECT_FALSE(route.passed_all());
}

TEST(Route, StopsWhereItWaitsAndWhereItTurnsToTheOtherDirection) {
  RouteTasks tasks;
  tasks.at = {{}, {}, {}};
  tasks.at[0].wait = 3.0;
  tasks.at[2].reverse = true;
  const Route route(kLine, tasks);
  EXPECT_TRUE(route.stops(0));
  EXPECT_TRUE(route.stops(1));
  EXPECT_TRUE(route.stops(2));  // the first is driven to forwards again
  EXPECT_FALSE(Route(kLine).stops(0));
}

TEST(Route, RefusesWhatIsNotFiniteAndTasksOfOtherWaypoints) {
  EXPECT_THROW(Route({{0.0, NAN}}), std::invalid_argument);
  EXPECT_THROW(Route(kLine, {{{}, {}}}), std::invalid_argument);
  Route route(kLine);
  EXPECT_THROW(route.move({{0.0, 0.0}}), std::invalid_argument);
  route.move({{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}});
  EXPECT_EQ(route.extent(), 2.0);
}

}  // namespace
}  // namespace multipath_localization
