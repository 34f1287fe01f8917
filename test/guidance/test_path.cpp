#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/guidance/path.hpp"

namespace multipath_localization {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

const Vertices kCorner = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};

TEST(Path, PassesACornerByTheLargestArcWithinTheRadius) {
  const Path path(kCorner, 1.0);
  const double radius = 1.0 / (std::sqrt(2.0) - 1.0);
  EXPECT_NEAR(path.length(), 20.0 - 2.0 * radius + 0.5 * kPi * radius, 1e-12);
  const PathPoint middle = path.at(path.station(1));
  EXPECT_NEAR((middle.position - kCorner[1]).norm(), 1.0, 1e-12);
  EXPECT_NEAR(middle.heading, 0.25 * kPi, 1e-12);
  EXPECT_NEAR(middle.curvature, 1.0 / radius, 1e-12);
  EXPECT_LT((path.at(path.length()).position - kCorner[2]).norm(), 1e-12);
}

TEST(Path, TakesNoMoreThanHalfOfALegForAnArc) {
  const Path path({{0.0, 0.0}, {10.0, 0.0}, {10.0, 2.0}, {20.0, 2.0}}, 1.0);
  EXPECT_NEAR(path.at(path.station(1)).curvature, 1.0, 1e-12);
  EXPECT_NEAR(path.at(path.station(2)).curvature, -1.0, 1e-12);
}

/// Any two places are as far from each other as the path says, and head along it.
TEST(Path, IsAsLongAsItsPlacesAreApart) {
  const Path path({{0.0, 0.0}, {10.0, 0.0}, {3.0, 6.0}, {9.0, 9.0}, {9.0, 20.0}, {5.0, 5.0}}, 1.5);
  constexpr double kStep = 1e-3;
  for (double s = 0.0; s + kStep < path.length(); s += kStep) {
    const PathPoint here = path.at(s);
    const Eigen::Vector2d way = path.at(s + kStep).position - here.position;
    ASSERT_NEAR(way.norm(), kStep, 1e-6) << s;
    ASSERT_NEAR(way.normalized().dot(Eigen::Vector2d(std::cos(here.heading), std::sin(here.heading))), 1.0,
                1e-5)
        << s;
  }
}

TEST(Path, FindsTheNearestPlaceWithinWhereItIsTold) {
  const Path path(kCorner, 1.0);
  for (double s = 0.5; s < path.length(); s += 0.5) {
    const PathPoint place = path.at(s);
    const Eigen::Vector2d left(-std::sin(place.heading), std::cos(place.heading));
    for (const double aside : {-2.0, 0.0, 1.0}) {
      EXPECT_NEAR(path.nearest(place.position + aside * left, 0.0, path.length()), s, 1e-9);
    }
    EXPECT_NEAR(path.nearest(place.position, 0.0, 0.5 * s), 0.5 * s, 1e-9);
  }
  EXPECT_EQ(path.nearest({-5.0, 0.0}, -1.0, 30.0), 0.0);
  EXPECT_EQ(path.nearest({10.0, 50.0}, 0.0, 100.0), path.length());
}

TEST(Path, TurnsBackInACuspAndCountsTheTurn) {
  const Path path({{0.0, 0.0}, {5.0, 0.0}, {0.0, 0.0}}, 1.0);
  EXPECT_NEAR(path.length(), 10.0, 1e-12);
  EXPECT_NEAR(path.station(1), 5.0, 1e-12);
  EXPECT_NEAR(std::abs(path.mean_curvature(4.5, 5.5)), kPi, 1e-9);
}

TEST(Path, CountsHeadingOnOverFullTurns) {
  Vertices round;
  for (int i = 0; i < 40; ++i) round.emplace_back(10.0 * std::cos(0.5 * i), 10.0 * std::sin(0.5 * i));
  const Path path(round, 1.0);
  EXPECT_NEAR(path.at(path.length()).heading - path.at(0.0).heading, 38 * 0.5, 1e-9);
  EXPECT_NEAR(path.mean_curvature(0.25 * path.length(), 0.75 * path.length()), 0.1, 0.01);
}

TEST(Path, OfATurningCirclesVerticesIsNearlyThatCircle) {
  Vertices dense;
  for (double angle = 0.0; angle < 6.0; angle += 0.01) {
    dense.emplace_back(5.0 * std::cos(angle), 5.0 * std::sin(angle));
  }
  const Path path(dense, 1.0);
  for (double s = 0.0; s < path.length(); s += 0.1) ASSERT_NEAR(path.at(s).position.norm(), 5.0, 0.1);
  for (std::size_t i = 1; i < dense.size(); ++i) ASSERT_GE(path.station(i), path.station(i - 1));
}

TEST(Path, IsProlongedStraight) {
  const Path path(kCorner, 1.0);
  EXPECT_LT((path.at(-3.0).position - Eigen::Vector2d(-3.0, 0.0)).norm(), 1e-12);
  EXPECT_LT((path.at(path.length() + 3.0).position - Eigen::Vector2d(10.0, 13.0)).norm(), 1e-12);
}

TEST(Path, OfOnePlaceHasNoLength) {
  for (const Vertices& place : {Vertices{{1.0, 2.0}}, Vertices{{1.0, 2.0}, {1.0, 2.0}, {1.0, 2.0}}}) {
    const Path path(place, 1.0);
    EXPECT_EQ(path.length(), 0.0);
    EXPECT_EQ(path.nearest({5.0, 5.0}, 0.0, 1.0), 0.0);
    EXPECT_EQ(path.at(0.0).position, Eigen::Vector2d(1.0, 2.0));
    EXPECT_EQ(path.mean_curvature(-1.0, 1.0), 0.0);
  }
}

TEST(Path, TurnsBackAtACuspAlone) {
  const Path path({{0.0, 0.0}, {10.0, 0.0}, {20.0, 0.0}, {5.0, 0.0}, {5.0, 10.0}}, 1.0);
  EXPECT_FALSE(path.turns_back_at(0.0));
  EXPECT_FALSE(path.turns_back_at(path.station(1)));
  EXPECT_TRUE(path.turns_back_at(path.station(2)));
  EXPECT_FALSE(path.turns_back_at(path.station(3)));
  EXPECT_FALSE(path.turns_back_at(path.station(2) + 0.1));
}

TEST(Path, FollowsTheArcsTold) {
  const Path path({{0.0, 0.0}, {4.0, 0.0}, {6.0, 2.0}, {4.0, 4.0}, {0.0, 4.0}}, {0.0, 0.0, 0.5, 0.5, 0.0},
                  1.0);
  EXPECT_NEAR(path.length(), 8.0 + 2.0 * kPi, 1e-9);
  EXPECT_NEAR(path.station(2), 4.0 + kPi, 1e-9);
  EXPECT_NEAR(path.at(path.station(2)).heading, 0.5 * kPi, 1e-9);
  EXPECT_NEAR(path.at(path.length()).heading, kPi, 1e-9);
  EXPECT_NEAR(path.at(path.station(2)).curvature, 0.5, 1e-12);
}

TEST(Path, LeavesOutNoPlaceWhereItHasArcsAndRoundsCornersBetweenLines) {
  const Path path({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {10.0, 10.2}}, {0.0, 0.0, 0.0, 0.0}, 1.0);
  EXPECT_NEAR((path.at(path.station(1)).position - Eigen::Vector2d(10.0, 0.0)).norm(), 1.0, 1e-9);
  EXPECT_NEAR(path.station(3) - path.station(2), 0.2, 1e-9);
}

}  // namespace
}  // namespace multipath_localization
