#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "simulation/satellite_receiver.hpp"

namespace multipath_localization {
namespace {

const LocalFrame kMap({35.0, 139.0, 40.0});

SatelliteReceiver receiver(const ReceiverParameters& parameters,
                           const std::vector<BuildingParameters>& buildings = {}) {
  return {parameters, {}, RawReceiver({}, satellites({}, 1), SkyView({}, buildings, 1), kMap, 1), 1};
}

/// A block on all four sides of the origin.
std::vector<BuildingParameters> yard() {
  return {{"east", {15, -60, 40, -60, 40, 60, 15, 60}, 60.0},
          {"west", {-40, -60, -15, -60, -15, 60, -40, 60}, 60.0},
          {"north", {-15, 20, 15, 20, 15, 60, -15, 60}, 60.0},
          {"south", {-15, -60, 15, -60, 15, -20, -15, -20}, 60.0}};
}

Robot robot() {
  RobotParameters parameters;
  parameters.start_yaw = 0.5;
  return {parameters, 1};
}

TEST(SatelliteReceiver, HandsOutEveryEpochAndTheFixOverAllOfIt) {
  ReceiverParameters parameters;
  parameters.rate = 10.0;
  parameters.antenna_x = 1.0;
  SatelliteReceiver satellites = receiver(parameters);
  const auto measured = satellites.step(robot(), 0.1);
  ASSERT_EQ(measured.size(), 2U);
  const auto& epoch = std::get<PseudorangeEpoch>(measured[0]);
  const auto& fix = std::get<GnssFix>(measured[1]);
  EXPECT_EQ(epoch.stamp, 0.1);
  EXPECT_EQ(epoch.antenna_in_base, Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(fix.stamp, 0.1);
  EXPECT_EQ(fix.antenna_in_base, epoch.antenna_in_base);

  const auto& sky = epoch.observations;
  const auto solution = solve_position(sky, declared_weights(sky), Eigen::Vector3d::Zero());
  EXPECT_LT((solution->position.head<2>() - fix.position).norm(), 1e-3);
  EXPECT_TRUE((solution->covariance.topLeftCorner<2, 2>().isApprox(fix.covariance, 1e-6)));

  const Eigen::Vector2d antenna = robot().pose() * Eigen::Vector2d(1.0, 0.0);
  EXPECT_LT((fix.position - antenna).norm(), 4.0);
  EXPECT_LT((satellites.reception().bias - (fix.position - antenna)).norm(), 1e-9);
  EXPECT_FALSE(satellites.reception().in_shadow);
  EXPECT_TRUE(satellites.step(robot(), 0.15).empty());
}

TEST(SatelliteReceiver, ItsAntennaTurnsWithTheRobot) {
  ReceiverParameters parameters;
  parameters.antenna_x = 1.0;
  parameters.antenna_y = 0.5;
  Robot turning = robot();
  turning.step({2.0, 0.4}, 0.1);
  turning.step({2.0, 0.4}, 0.1);
  SatelliteReceiver satellites = receiver(parameters);
  const auto measured = satellites.step(turning, 0.2);
  // The velocity of the antenna by least squares over the range rates, the clock's drift eliminated.
  const auto& sky = std::get<PseudorangeEpoch>(measured[0]).observations;
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const SatelliteObservation& observation : sky) {
    Eigen::Vector4d row;
    const Eigen::Vector3d direction = line_of_sight(observation, Eigen::Vector3d::Zero()).direction;
    row << -direction, 1.0;
    normal += row * row.transpose();
    right += row * (observation.range_rate - direction.dot(observation.velocity));
  }
  const Eigen::Vector2d velocity = normal.ldlt().solve(right).head<2>();
  const Eigen::Vector2d lever = Pose2{0.0, 0.0, turning.pose().yaw} * Eigen::Vector2d(1.0, 0.5);
  const Eigen::Vector2d heading = Pose2{0.0, 0.0, turning.pose().yaw} * Eigen::Vector2d(1.0, 0.0);
  const Eigen::Vector2d expected =
      turning.speed() * heading + turning.yaw_rate() * Eigen::Vector2d(-lever.y(), lever.x());
  EXPECT_GT(turning.yaw_rate(), 0.1);
  EXPECT_LT((velocity - expected).norm(), 0.05);
}

TEST(SatelliteReceiver, AmongHighWallsItIsInShadow) {
  SatelliteReceiver satellites = receiver({}, yard());
  const auto measured = satellites.step(robot(), 0.2);
  EXPECT_TRUE(satellites.reception().in_shadow);
  EXPECT_LT(std::get<PseudorangeEpoch>(measured[0]).observations.size(), 25U);
}

TEST(SatelliteReceiver, IndoorsItHandsOutAnEmptyEpochAndNoFix) {
  SatelliteReceiver satellites = receiver({}, {{"hall", {-10, -10, 10, -10, 10, 10, -10, 10}, 20.0}});
  const auto measured = satellites.step(robot(), 0.2);
  ASSERT_EQ(measured.size(), 1U);
  EXPECT_TRUE(std::get<PseudorangeEpoch>(measured[0]).observations.empty());
  EXPECT_TRUE(satellites.reception().in_shadow);
}

TEST(SatelliteReceiver, DeliversLate) {
  ReceiverParameters parameters;
  parameters.rate = 10.0;
  parameters.latency = 0.15;
  SatelliteReceiver satellites = receiver(parameters);
  EXPECT_TRUE(satellites.step(robot(), 0.1).empty());
  EXPECT_TRUE(satellites.step(robot(), 0.2).empty());
  const auto measured = satellites.step(robot(), 0.25);
  ASSERT_EQ(measured.size(), 2U);
  EXPECT_EQ(stamp_of(measured[0]), 0.1);
}

}  // namespace
}  // namespace multipath_localization
