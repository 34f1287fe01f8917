#include <gtest/gtest.h>

#include "ros/steering_node/command_stream.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.1;  // between commands [s]

const FollowerOutput kDrive{{1.0, 0.1}, "driving"};
const FollowerOutput kStand{{}, "stopped"};

/// A stream whose clock goes on by kStep with each call.
class CommandStreamTest : public testing::Test {
 protected:
  Moment next() {
    time_ += kStep;
    return {ros::Time(100.0 + time_), ros::SteadyTime(50.0 + time_)};
  }

  void bring_to_speed() {
    for (int i = 0; i < 20; ++i) stream_.towards(kDrive, false, next());
    ASSERT_EQ(stream_.limiter().last().speed, 1.0);
  }

  CommandStream stream_{WaypointFollowerParameters{}};
  double time_ = 0.0;
};

TEST_F(CommandStreamTest, SpeedsUpByTheTimeBetweenCommands) {
  EXPECT_NE(stream_.towards(kDrive, false, next()), std::nullopt);
  const double before = stream_.limiter().last().speed;
  EXPECT_NEAR(stream_.towards(kDrive, false, next())->speed - before, kStep, 1e-6);
}

TEST_F(CommandStreamTest, BrakesToAStandWithoutFurtherPoses) {
  bring_to_speed();
  EXPECT_EQ(stream_.braked(next()), std::nullopt);
  EXPECT_NEAR(stream_.towards(kStand, false, next())->speed, 1.0 - 2.0 * kStep, 1e-6);
  int commands = 0;
  while (stream_.braked(next())) ++commands;
  EXPECT_NEAR(commands, 8, 1);
  EXPECT_TRUE(stream_.limiter().at_rest());
}

TEST_F(CommandStreamTest, GoesOnBrakingAsUrgentlyAsItBegan) {
  bring_to_speed();
  stream_.towards({{}, "stopped: localisation lost", true}, false, next());
  EXPECT_NEAR(stream_.braked(next())->speed, 1.0 - 2.0 * 2.0 * kStep, 1e-6);
}

TEST_F(CommandStreamTest, BrakesBesideAClockThatStandsStill) {
  bring_to_speed();
  const Moment stood = next();
  stream_.towards(kStand, false, stood);
  const double before = stream_.limiter().last().speed;
  const Moment later{stood.stamp, stood.steady + ros::WallDuration(kStep)};
  EXPECT_NEAR(stream_.braked(later)->speed, before - kStep, 1e-6);
}

TEST_F(CommandStreamTest, LeavesARobotThatStandsByOrderToOthersAfterASecond) {
  for (int i = 0; i < 10; ++i) EXPECT_NE(stream_.towards(kStand, true, next()), std::nullopt) << i;
  next();
  EXPECT_EQ(stream_.towards(kStand, true, next()), std::nullopt);
  stream_.speak_again();
  EXPECT_NE(stream_.towards(kStand, true, next()), std::nullopt);
  EXPECT_NE(stream_.towards(kDrive, false, next()), std::nullopt);
}

TEST_F(CommandStreamTest, ARobotThatStandsByReasonIsToldSoForEver) {
  for (int i = 0; i < 50; ++i) EXPECT_NE(stream_.towards(kStand, false, next()), std::nullopt);
}

TEST_F(CommandStreamTest, HaltsAtOnce) {
  bring_to_speed();
  EXPECT_EQ(stream_.halted().speed, 0.0);
  EXPECT_TRUE(stream_.limiter().at_rest());
}

}  // namespace
}  // namespace multipath_localization
