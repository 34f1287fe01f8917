#include <gtest/gtest.h>

#include "ros/localization_node/odometry_log.hpp"

namespace multipath_localization {
namespace {

ReadOdometry odometry_at(double stamp) {
  ReadOdometry odometry;
  odometry.message.header.stamp = ros::Time(stamp);
  odometry.base_in_odom.x = stamp;
  return odometry;
}

OdometryLog log_of(std::initializer_list<double> stamps) {
  OdometryLog log;
  for (const double stamp : stamps) {
    log.note(odometry_at(stamp));
    log.await_answer();
  }
  return log;
}

TEST(OdometryLog, KnowsTheFirstEver) {
  OdometryLog log;
  EXPECT_FALSE(log.last());
  EXPECT_EQ(log.stamp(), ros::Time());
  EXPECT_TRUE(log.note(odometry_at(1.0)));
  EXPECT_FALSE(log.note(odometry_at(2.0)));
  log.forget_last();
  EXPECT_FALSE(log.last());
  EXPECT_EQ(log.stamp(), ros::Time());
  EXPECT_FALSE(log.note(odometry_at(3.0))) << "though it is the first since";
}

TEST(OdometryLog, GivesAwayWhatAwaitsAnAnswerOnce) {
  OdometryLog log = log_of({1.0, 2.0});
  log.note(odometry_at(3.0));  // that is answered otherwise
  EXPECT_FALSE(log.answered());
  const auto unanswered = log.take_unanswered();
  ASSERT_EQ(unanswered.size(), 2U);
  EXPECT_EQ(unanswered[0].base_in_odom.x, 1.0);
  EXPECT_EQ(unanswered[1].base_in_odom.x, 2.0);
  EXPECT_TRUE(log.answered());
  EXPECT_EQ(log.stamp(), ros::Time(3.0));
}

TEST(OdometryLog, GivesUpWhatIsOld) {
  OdometryLog log = log_of({1.0, 1.8, 2.0});
  log.give_up_older_than(0.5);
  EXPECT_EQ(log.take_unanswered().size(), 2U);
  log.give_up_older_than(0.5);
  EXPECT_TRUE(log.answered());
}

}  // namespace
}  // namespace multipath_localization
