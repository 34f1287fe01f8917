#include <gtest/gtest.h>

#include "estimators/multipath/wheel_watch.hpp"

namespace multipath_localization::multipath {
namespace {

class WheelWatchTest : public ::testing::Test {
 protected:
  WheelWatch watch{OdometryJumpParameters{2.5, 8.0, 0.5}, OdometryNoise{}};
  double now = 0.0;

  void drive(double speed, double duration) {
    for (double t = 0.0; t < duration - 1e-9; t += 0.02) watch.add({now += 0.02, 0.02, speed, 0.0});
  }
};

TEST_F(WheelWatchTest, KnowsHowFastTheRobotDrivesAsARule) {
  for (int i = 0; i < 60; ++i) {
    drive(2.0, 1.0);
    EXPECT_FALSE(watch.standing(1.0));
    EXPECT_NEAR(watch.way(), 2.0, 1e-9);
    watch.look_back(1.0, 0.0);
  }
  EXPECT_NEAR(watch.usual_speed(), 2.0, 0.05);
  drive(0.0, 1.0);
  EXPECT_TRUE(watch.standing(1.0));
  watch.look_back(1.0, 0.0);
  EXPECT_NEAR(watch.usual_speed(), 2.0, 0.05) << "standing does not count";
}

TEST_F(WheelWatchTest, TakesNoRobotForStandingWhoseTicksAreFewerThanIncrements) {
  for (int i = 0; i < 10; ++i) {
    watch.add({now += 0.02, 0.02, 1.0, 0.0});
    for (int k = 0; k < 4; ++k) watch.add({now += 0.02, 0.02, 0.0, 0.0});
  }
  EXPECT_FALSE(watch.standing(1.0));
  EXPECT_NEAR(watch.way(), 0.2, 1e-9);
}

TEST_F(WheelWatchTest, SuspectsTheWheelsWhereTheOdometryJumps) {
  drive(2.0, 5.0);
  watch.look_back(5.0, 0.0);
  EXPECT_EQ(watch.fault_probability(1.0), 0.0);
  drive(0.0, 1.0);
  watch.look_back(1.0, 0.0);
  EXPECT_GT(watch.fault_probability(1.0), 0.0);
  for (int i = 0; i < 3; ++i) watch.look_back(1.0, 0.0);
  EXPECT_EQ(watch.fault_probability(1.0), 0.0);
}

TEST_F(WheelWatchTest, GetsUsedToARobotThatBrakesHard) {
  const auto suspicion = [&](double fault) {
    drive(2.0, 5.0);
    watch.look_back(3.0, 0.0);
    drive(0.0, 1.0);
    watch.look_back(1.0, 0.0);
    const double probability = watch.fault_probability(1.0);
    for (int i = 0; i < 3; ++i) watch.look_back(1.0, fault);
    return probability;
  };
  const double first = suspicion(1.0);
  EXPECT_EQ(suspicion(0.0), first) << "the wheels did fail";
  EXPECT_NEAR(suspicion(0.0), first / 2.0, 1e-12);
  EXPECT_NEAR(suspicion(0.0), first / 3.0, 1e-12);
}

TEST_F(WheelWatchTest, TellsOfAJumpOnce) {
  drive(2.0, 5.0);
  drive(0.0, 1.0);
  EXPECT_NEAR(watch.take_suspicion(), 0.015, 1e-12);
  EXPECT_EQ(watch.take_suspicion(), 0.0);
}

}  // namespace
}  // namespace multipath_localization::multipath
