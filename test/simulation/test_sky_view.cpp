#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "simulation/sky_view.hpp"

namespace multipath_localization {
namespace {

using Kind = SignalPath::Kind;

constexpr double kDegree = kPi / 180.0;

/// Of length 1, towards an elevation and an azimuth counter-clockwise from east [deg].
Eigen::Vector3d towards(double elevation_deg, double azimuth_deg) {
  const double elevation = elevation_deg * kDegree;
  const double azimuth = azimuth_deg * kDegree;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

BuildingParameters block(double west, double south, double east, double north, double height) {
  return {"block", {west, south, east, south, east, north, west, north}, height};
}

/// East of the antenna, its wall at x = 10 and its roof at 30 m.
const BuildingParameters kEast = block(10, -50, 30, 50, 30);
/// West of the antenna, its wall at x = -20.
const BuildingParameters kWest = block(-40, -500, -20, 500, 1000);

const Eigen::Vector3d kAntenna(0.0, 0.0, 2.0);
const double kEdge = std::atan2(28.0, 10.0) / kDegree;  // elevation of the eastern roof's edge [deg]

std::vector<SignalPath> paths(const std::vector<BuildingParameters>& buildings,
                              const Eigen::Vector3d& direction, const SkyParameters& parameters = {},
                              const Eigen::Vector3d& antenna = kAntenna) {
  return SkyView(parameters, buildings, 1).paths(antenna, direction);
}

SkyParameters no_diffraction() {
  SkyParameters parameters;
  parameters.diffraction_limit_deg = 0.0;
  return parameters;
}

TEST(SkyView, InTheOpenEverySignalComesStraight) {
  for (const double elevation : {5.0, 45.0, 89.0, 90.0}) {
    const auto all = paths({}, towards(elevation, 77.0));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].kind, Kind::kDirect);
    EXPECT_EQ(all[0].delay, 0.0);
    EXPECT_EQ(all[0].loss_db, 0.0);
    EXPECT_EQ(all[0].arrival, towards(elevation, 77.0));
  }
}

TEST(SkyView, AWallHidesWhatIsBelowItsRoof) {
  EXPECT_TRUE(paths({kEast}, towards(kEdge - 0.1, 0.0), no_diffraction()).empty());
  EXPECT_EQ(paths({kEast}, towards(kEdge + 0.1, 0.0), no_diffraction()).front().kind, Kind::kDirect);
  // Aslant the wall is further away and its edge lower.
  const double aslant = std::atan2(28.0, 10.0 / std::cos(60.0 * kDegree)) / kDegree;
  EXPECT_TRUE(paths({kEast}, towards(aslant - 0.1, 60.0), no_diffraction()).empty());
  EXPECT_EQ(paths({kEast}, towards(aslant + 0.1, 60.0), no_diffraction()).front().kind, Kind::kDirect);
}

TEST(SkyView, BesideAndBehindItAWallHidesNothing) {
  const double past_the_corner = std::atan2(50.0, 10.0) / kDegree + 0.1;
  EXPECT_EQ(paths({kEast}, towards(5.0, past_the_corner)).front().kind, Kind::kDirect);
  EXPECT_TRUE(paths({kEast}, towards(5.0, past_the_corner - 0.2)).empty());
  EXPECT_EQ(paths({kEast}, towards(5.0, 180.0)).front().kind, Kind::kDirect);
}

TEST(SkyView, AHigherAntennaSeesMore) {
  EXPECT_TRUE(paths({kEast}, towards(10.0, 0.0), {}, {0.0, 0.0, 2.0}).empty());
  EXPECT_EQ(paths({kEast}, towards(10.0, 0.0), {}, {0.0, 0.0, 29.0}).front().kind, Kind::kDirect);
}

TEST(SkyView, IndoorsThereIsNoSignalAndOnTheRoofThereIs) {
  EXPECT_TRUE(paths({kEast}, towards(90.0, 0.0), {}, {20.0, 0.0, 2.0}).empty());
  EXPECT_EQ(paths({kEast}, towards(5.0, 0.0), {}, {20.0, 0.0, 31.0}).size(), 1U);
}

TEST(SkyView, OverTheEdgeASignalIsBent) {
  const double bend = 2.0;
  const auto all = paths({kEast}, towards(kEdge - bend, 0.0));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, Kind::kDiffracted);
  const Eigen::Vector3d edge(10.0, 0.0, 30.0);
  EXPECT_LT((all[0].arrival - (edge - kAntenna).normalized()).norm(), 1e-9);
  const double length = (edge - kAntenna).norm();
  EXPECT_NEAR(all[0].delay, length - (edge - kAntenna).dot(towards(kEdge - bend, 0.0)), 1e-9);
  const double nu = bend * kDegree * std::sqrt(2.0 * length / 0.19);
  EXPECT_NEAR(all[0].loss_db, 6.9 + 20.0 * std::log10(std::sqrt((nu - 0.1) * (nu - 0.1) + 1.0) + nu - 0.1),
              1e-9);
}

TEST(SkyView, GrazingTheEdgeCostsSixDecibelsAndTheLimitHolds) {
  EXPECT_NEAR(paths({kEast}, towards(kEdge - 1e-6, 0.0)).front().loss_db, 6.03, 0.01);
  SkyParameters parameters;
  EXPECT_TRUE(paths({kEast}, towards(kEdge - parameters.diffraction_limit_deg - 0.01, 0.0)).empty());
  EXPECT_EQ(paths({kEast}, towards(kEdge - parameters.diffraction_limit_deg + 0.01, 0.0)).size(), 1U);
}

TEST(SkyView, OfSeveralEdgesTheHighestBends) {
  const BuildingParameters behind = block(40, -50, 60, 50, 200);
  const double edge = std::atan2(198.0, 40.0) / kDegree;
  const auto all = paths({kEast, behind}, towards(edge - 1.0, 0.0));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(std::asin(all[0].arrival.z()) / kDegree, edge, 1e-9);
}

/// A single wall without end: the detour is 2 d cos(elevation) cos(azimuth from the wall's normal).
TEST(SkyView, TheDetourOffAWallIsThatOfTheImage) {
  for (const double elevation : {5.0, 30.0, 70.0}) {
    for (const double azimuth : {-60.0, 0.0, 45.0}) {
      const auto all = paths({kWest}, towards(elevation, azimuth));
      ASSERT_EQ(all.size(), 2U) << elevation << " " << azimuth;
      EXPECT_EQ(all[0].kind, Kind::kDirect);
      EXPECT_EQ(all[1].kind, Kind::kReflected);
      EXPECT_NEAR(all[1].delay, 40.0 * std::cos(elevation * kDegree) * std::cos(azimuth * kDegree), 1e-9);
      EXPECT_LT((all[1].arrival - towards(elevation, 180.0 - azimuth)).norm(), 1e-12);
    }
  }
}

TEST(SkyView, FromBehindAWallDoesNotReflect) {
  const BuildingParameters low = block(-40, -500, -20, 500, 3);
  EXPECT_EQ(paths({low}, towards(40.0, 180.0)).size(), 1U);
  EXPECT_EQ(paths({low}, towards(40.0, 0.0), {}, {-50.0, 0.0, 2.0}).size(), 1U);
}

TEST(SkyView, TheMirrorPointMustLieOnTheWall) {
  // To the west at 45 degrees it lies at a height of 22 m.
  EXPECT_EQ(paths({block(-40, -500, -20, 500, 22.1)}, towards(45.0, 0.0)).size(), 2U);
  EXPECT_EQ(paths({block(-40, -500, -20, 500, 21.9)}, towards(45.0, 0.0)).size(), 1U);
  // At 45 degrees in azimuth it lies 20 m to the north.
  EXPECT_EQ(paths({block(-40, 0, -20, 20.1, 100)}, towards(30.0, 45.0)).size(), 2U);
  EXPECT_EQ(paths({block(-40, 0, -20, 19.9, 100)}, towards(30.0, 45.0)).size(), 1U);
}

TEST(SkyView, BehindABuildingTheOppositeWallIsHeard) {
  SkyParameters parameters = no_diffraction();
  parameters.reflection_loss_db = 7.0;
  parameters.reflection_loss_spread_db = 0.0;
  parameters.panel_size = 100.0;
  // Seen from the mirror point the eastern roof, 30 m away, stands lower than from the antenna.
  const double elevation = 65.0;
  const auto all = paths({kEast, kWest}, towards(elevation, 0.0), parameters);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, Kind::kReflected);
  EXPECT_NEAR(all[0].delay, 40.0 * std::cos(elevation * kDegree), 1e-9);
  EXPECT_NEAR(all[0].loss_db, 7.0, 1e-12);
}

TEST(SkyView, AReflectedRayMustItselfBeFree) {
  const BuildingParameters screen = block(-12, -5, -10, 5, 10);
  EXPECT_NEAR(paths({kWest}, towards(20.0, 0.0)).back().delay, 40.0 * std::cos(20.0 * kDegree), 1e-9);
  const auto screened = paths({kWest, screen}, towards(20.0, 0.0));  // between antenna and wall
  ASSERT_EQ(screened.size(), 2U);
  EXPECT_NEAR(screened.back().delay, 20.0 * std::cos(20.0 * kDegree), 1e-9);
  const BuildingParameters tower = block(10, -50, 30, 50, 60);
  EXPECT_TRUE(paths({kWest, tower}, towards(20.0, 0.0)).empty());  // between wall and satellite
}

/// Between two parallel walls the second image is twice the width of the street away.
TEST(SkyView, TwiceReflectedSignalsComeWhereNothingElseDoes) {
  const SkyParameters parameters = no_diffraction();
  // From the west the roof of the east is cleared above 29 degrees, by way of the east and the west above 22.
  for (const double azimuth : {0.0, 20.0}) {
    const auto all = paths({kEast, kWest}, towards(25.0, azimuth), parameters);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].kind, Kind::kReflected);
    EXPECT_NEAR(all[0].delay, 60.0 * std::cos(25.0 * kDegree) * std::cos(azimuth * kDegree), 1e-9);
    EXPECT_LT((all[0].arrival - towards(25.0, azimuth)).norm(), 1e-12);
  }
  EXPECT_TRUE(paths({kEast, kWest}, towards(20.0, 0.0), parameters).empty());
  SkyParameters fewer = parameters;
  fewer.reflections = 1;
  EXPECT_TRUE(paths({kEast, kWest}, towards(25.0, 0.0), fewer).empty());
  EXPECT_EQ(paths({kEast, kWest}, towards(35.0, 0.0), fewer).size(), 1U);
  fewer.reflections = 0;
  EXPECT_TRUE(paths({kEast, kWest}, towards(35.0, 0.0), fewer).empty());
}

TEST(SkyView, SmallPanelsLoseWithDistance) {
  SkyParameters parameters;
  parameters.reflection_loss_spread_db = 0.0;
  parameters.panel_size = 1.0;
  const auto loss = [&](double distance) {
    const BuildingParameters wall = block(-distance - 10, -500, -distance, 500, 1000);
    return paths({wall}, towards(0.1, 0.0), parameters).back().loss_db;
  };
  EXPECT_NEAR(loss(4.0), parameters.reflection_loss_db, 1e-9);
  EXPECT_NEAR(loss(80.0) - loss(40.0), 20.0 * std::log10(2.0), 1e-9);
}

TEST(SkyView, TheStrongestComesFirst) {
  const BuildingParameters south = block(-500, -40, 500, -10, 1000);
  const auto all = paths({kWest, south}, towards(30.0, 45.0));
  ASSERT_GE(all.size(), 3U);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i - 1].loss_db, all[i].loss_db);
}

TEST(SkyView, TheSeedChoosesWhatWallsLose) {
  const auto loss = [](std::uint64_t seed) {
    return SkyView({}, {kWest}, seed).paths(kAntenna, towards(30.0, 0.0)).back().loss_db;
  };
  EXPECT_EQ(loss(1), loss(1));
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 0; seed < 400; ++seed) {
    const double value = loss(static_cast<std::uint64_t>(seed));
    EXPECT_GE(value, 3.0);
    sum += value / 400;
    squares += value * value / 400;
  }
  EXPECT_NEAR(sum, 6.25, 0.6);  // below 3 dB counts as 3 dB
  EXPECT_GT(squares - sum * sum, 4.0);
}

TEST(SkyView, RefusesABuildingWithoutCorners) {
  EXPECT_THROW(SkyView({}, {BuildingParameters{}}, 1), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
