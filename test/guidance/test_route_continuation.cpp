#include <gtest/gtest.h>

#include <limits>

#include "guidance/route_continuation.hpp"

namespace multipath_localization {
namespace {

using Route = std::vector<Eigen::Vector2d>;

const Route kRoute = {{10.0, 0.0}, {20.0, 0.0}, {30.0, 0.0}, {40.0, 0.0}};
const Route kThereAndBack = {{0.0, 0.0}, {9.0, 0.0}, {0.0, 0.0}, {9.0, 0.0}, {0.0, 0.0}, {9.0, 0.0}};

/// Without its first `front` waypoints, and with `more` behind its last.
Route changed(Route route, std::size_t front, const Route& more = {}) {
  route.erase(route.begin(), route.begin() + static_cast<std::ptrdiff_t>(front));
  route.insert(route.end(), more.begin(), more.end());
  return route;
}

Route shifted(Route route, double by) {
  for (Eigen::Vector2d& waypoint : route) waypoint.y() += by;
  return route;
}

TEST(SameRoute, IsOneToAFewCentimetres) {
  EXPECT_TRUE(same_route(kRoute, shifted(kRoute, 1e-7)));
  EXPECT_TRUE(same_route(kRoute, shifted(kRoute, 0.9 * kSameWaypoint)));
  EXPECT_FALSE(same_route(kRoute, shifted(kRoute, 1.1 * kSameWaypoint)));
  EXPECT_FALSE(same_route(kRoute, changed(kRoute, 1)));
  EXPECT_FALSE(same_route(kRoute, changed(kRoute, 0, {{50.0, 0.0}})));
  EXPECT_FALSE(same_route(kRoute, shifted(kRoute, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(same_route({}, {}));
}

TEST(RouteContinuation, OfTheSameOrAGrownRouteKeepsTheTarget) {
  for (std::size_t passed = 0; passed < kRoute.size(); ++passed) {
    EXPECT_EQ(target_in_continuation(kRoute, passed, shifted(kRoute, 0.01)), passed);
    EXPECT_EQ(target_in_continuation(kRoute, passed, changed(kRoute, 0, {{50.0, 0.0}})), passed);
  }
}

TEST(RouteContinuation, OfTheRemainingWayFindsTheTargetFurtherInFront) {
  for (std::size_t passed = 0; passed < kRoute.size(); ++passed) {
    for (std::size_t front = 0; front <= passed; ++front) {
      EXPECT_EQ(target_in_continuation(kRoute, passed, changed(kRoute, front)), passed - front);
      EXPECT_EQ(target_in_continuation(kRoute, passed, changed(kRoute, front, {{50.0, 0.0}})),
                passed - front);
    }
  }
}

TEST(RouteContinuation, MayTakeAnotherWayBeyondTheTarget) {
  EXPECT_EQ(target_in_continuation(kRoute, 1, {{10.0, 0.0}, {20.0, 0.0}, {20.0, 9.0}}), 1U);
  EXPECT_EQ(target_in_continuation(kRoute, 1, {{10.0, 0.0}, {20.0, 0.0}}), 1U);
  EXPECT_EQ(target_in_continuation(kRoute, 1, {{20.0, 0.0}, {20.0, 9.0}}), 0U);
}

TEST(RouteContinuation, IsNoRouteThatOnlyComesByTheTarget) {
  EXPECT_FALSE(target_in_continuation(kRoute, 1, {{0.0, 9.0}, {20.0, 0.0}, {30.0, 0.0}}));
  EXPECT_FALSE(target_in_continuation(kRoute, 1, shifted(kRoute, 1.0)));
  EXPECT_FALSE(target_in_continuation(kRoute, 1, {{10.0, 0.0}}));
  EXPECT_FALSE(target_in_continuation(kRoute, 1, {}));
  EXPECT_FALSE(target_in_continuation({}, 0, kRoute));
}

TEST(RouteContinuation, OfWaypointsThatRecurHasAsManyLeft) {
  for (std::size_t passed = 0; passed < kThereAndBack.size(); ++passed) {
    for (std::size_t front = 0; front <= passed; ++front) {
      EXPECT_EQ(target_in_continuation(kThereAndBack, passed, changed(kThereAndBack, front)), passed - front);
    }
  }
}

TEST(RouteContinuation, OfAFinishedRouteHasMoreBehindAllOfIt) {
  EXPECT_EQ(target_in_continuation(kRoute, kRoute.size(), changed(kRoute, 0, {{50.0, 0.0}})), kRoute.size());
  EXPECT_FALSE(target_in_continuation(kRoute, kRoute.size(), kRoute));
  EXPECT_FALSE(target_in_continuation(kRoute, kRoute.size(), changed(kRoute, 1)));
  EXPECT_FALSE(target_in_continuation(kRoute, kRoute.size(), changed(kRoute, 1, {{50.0, 0.0}, {60.0, 0.0}})));
}

}  // namespace
}  // namespace multipath_localization
