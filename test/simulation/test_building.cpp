#include <gtest/gtest.h>

#include "simulation/building.hpp"

namespace multipath_localization {
namespace {

BuildingParameters building(const std::vector<double>& corners) { return {"hall", corners, 12.0}; }

TEST(Walls, LookOutwardsWhateverTheSenseOfRotation) {
  for (const auto& corners :
       {std::vector<double>{0, 0, 20, 0, 20, 10, 0, 10}, std::vector<double>{0, 0, 0, 10, 20, 10, 20, 0}}) {
    const std::vector<Wall> faces = walls(building(corners));
    ASSERT_EQ(faces.size(), 4U);
    for (const Wall& wall : faces) {
      const Eigen::Vector2d middle = wall.start + 0.5 * wall.length * wall.along;
      EXPECT_GT((middle - Eigen::Vector2d(10.0, 5.0)).dot(wall.outward), 0.0);
      EXPECT_NEAR(wall.along.dot(wall.outward), 0.0, 1e-12);
      EXPECT_NEAR(wall.outward.norm(), 1.0, 1e-12);
      EXPECT_EQ(wall.height, 12.0);
    }
  }
}

TEST(Walls, ReachFromCornerToCorner) {
  const std::vector<Wall> faces = walls(building({0, 0, 20, 0, 20, 10}));
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_EQ(faces[1].start, Eigen::Vector2d(20.0, 0.0));
  EXPECT_EQ(faces[1].length, 10.0);
  EXPECT_EQ(faces[1].outward, Eigen::Vector2d(1.0, 0.0));
}

TEST(Walls, ACornerGivenTwiceMakesNoWall) {
  EXPECT_EQ(walls(building({0, 0, 20, 0, 20, 0, 20, 10})).size(), 3U);
}

TEST(Walls, NeedThreeCorners) {
  EXPECT_THROW(walls(building({0, 0, 20, 0})), ParameterError);
  EXPECT_THROW(walls(building({})), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
