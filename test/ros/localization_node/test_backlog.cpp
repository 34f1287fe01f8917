#include <gtest/gtest.h>

#include "ros/localization_node/backlog.hpp"

namespace multipath_localization {
namespace {

TEST(Backlog, IsBehindOnceATurnTakesTooLong) {
  Backlog backlog(0.3);
  backlog.begin_turn();
  EXPECT_FALSE(backlog.take(ros::WallTime(100.0)));
  EXPECT_FALSE(backlog.take(ros::WallTime(100.2)));
  EXPECT_TRUE(backlog.take(ros::WallTime(100.4)));
  EXPECT_TRUE(backlog.take(ros::WallTime(100.5)));
}

TEST(Backlog, IsNotBehindInANewTurnHoweverLongItWaitedForAMessage) {
  Backlog backlog(0.3);
  backlog.begin_turn();
  backlog.take(ros::WallTime(100.0));
  ASSERT_TRUE(backlog.take(ros::WallTime(101.0)));
  backlog.begin_turn();
  EXPECT_FALSE(backlog.take(ros::WallTime(105.0)));
}

TEST(Backlog, TellsWhatWasLeftOutOnce) {
  Backlog backlog(0.3);
  backlog.count_merged();
  backlog.count_merged();
  backlog.count_unweighed();
  const Backlog::LeftOut left_out = backlog.take_left_out();
  EXPECT_EQ(left_out.increments, 2U);
  EXPECT_EQ(left_out.measurements, 1U);
  EXPECT_EQ(backlog.take_left_out().increments, 0U);
}

TEST(HeldOdometry, GivesAwayAsOneWhatFollowsDirectly) {
  HeldOdometry held;
  EXPECT_FALSE(held.add({1.0, 0.1, 1.0, 0.0}));
  EXPECT_FALSE(held.add({1.1, 0.1, 3.0, 0.2}));
  EXPECT_NEAR(held.duration(), 0.2, 1e-12);
  const auto both = held.take();
  ASSERT_TRUE(both);
  EXPECT_EQ(both->stamp, 1.1);
  EXPECT_NEAR(both->speed, 2.0, 1e-12);
  EXPECT_NEAR(both->yaw_rate, 0.1, 1e-12);
  EXPECT_FALSE(held.take());
}

TEST(HeldOdometry, DoesNotReachOverAGap) {
  HeldOdometry held;
  held.add({1.0, 0.1, 1.0, 0.0});
  const auto before = held.add({1.5, 0.1, 3.0, 0.0});
  ASSERT_TRUE(before);
  EXPECT_EQ(before->stamp, 1.0);
  EXPECT_EQ(held.take()->stamp, 1.5);
}

}  // namespace
}  // namespace multipath_localization
