#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "good_fix.hpp"
#include "ros/map/datum_search.hpp"

namespace multipath_localization {
namespace {

constexpr double kMaxSpeed = 50.0;

/// A fix at a point of the map of Berlin.
GnssMessage fix(double stamp, double east, double north, double sigma = 1.0) {
  GnssFix in_map;
  in_map.position = {east, north};
  in_map.covariance *= sigma * sigma;
  std_msgs::Header header;
  header.stamp = ros::Time(stamp);
  header.frame_id = "gps";
  return to_message(in_map, berlin(), header);
}

/// What becomes of each message, in order: a accepted, c contradicted, n not started; waiting ones are not
/// told.
class Judged {
 public:
  explicit Judged(double averaging = 0.0) : search({}, kMaxSpeed, averaging) {}

  void add(const GnssMessage& message) {
    for (const auto& [decided, reason] : search.add(message)) {
      fates += reason == Reason::kAccepted ? "a" : reason == Reason::kInvalidPosition ? "c" : "n";
      EXPECT_GE(header_of(decided).stamp.toSec(), last_) << "in order";
      last_ = header_of(decided).stamp.toSec();
    }
  }
  [[nodiscard]] Eigen::Vector2d place() const {
    return search.place() ? berlin().to_map(*search.place()) : Eigen::Vector2d(NAN, NAN);
  }

  DatumSearch search;
  std::string fates;

 private:
  double last_ = 0.0;
};

TEST(DatumSearch, ThreeThatAgreeAreEnoughAndNoneOfThemIsLost) {
  for (const double interval : {0.05, 1.0}) {
    for (const double speed : {0.0, 25.0}) {
      Judged judged;
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(judged.fates, "");
        judged.add(fix(100.0 + i * interval, 7.0 + speed * interval * i, 0.0));
      }
      EXPECT_EQ(judged.fates, "aaa") << interval << " s, " << speed << " m/s";
      EXPECT_NEAR(judged.place().x(), 7.0, 0.01) << "the first is the origin";
    }
  }
}

TEST(DatumSearch, AnOutlierDecidesNothing) {
  Judged judged;
  judged.add(fix(100.0, 50e3, 0.0));
  judged.add(fix(100.2, 0.0, 0.0));
  judged.add(fix(100.4, 0.3, 0.0));
  judged.add(fix(100.6, 300.0, 0.0));
  judged.add(fix(100.8, 0.6, 0.0));
  EXPECT_EQ(judged.fates, "caaca");
  EXPECT_LT(judged.place().norm(), 1.0);
}

TEST(DatumSearch, AForeignReceiverOnTheTopicDecidesNothing) {
  Judged judged;
  for (int i = 0; i < 5; ++i) {
    judged.add(fix(100.0 + i, 0.5 * i, 0.0));
    judged.add(fix(100.5 + i, 1e6 + 1e5 * i, 0.0));
  }
  EXPECT_EQ(judged.fates.substr(0, 5), "acaca");
  EXPECT_LT(judged.place().norm(), 1.0);
}

TEST(DatumSearch, APlaceThatWasNotDrivenFromIsLeftForOneThatHolds) {
  Judged judged;
  for (int i = 0; i < 10; ++i) judged.add(fix(100.0 + i, 30e3, 0.0));
  EXPECT_NEAR(judged.place().x(), 30e3, 100.0) << "where the receiver was switched off";
  for (int i = 0; i < 9; ++i) judged.add(fix(110.0 + i, 0.0, 0.0));
  EXPECT_NEAR(judged.place().x(), 30e3, 100.0) << "as many as told the first";
  judged.add(fix(119.0, 0.0, 0.0));
  EXPECT_LT(judged.place().norm(), 1.0);
  EXPECT_FALSE(judged.search.proven());
}

TEST(DatumSearch, APlaceDrivenFromStays) {
  Judged judged;
  for (int i = 0; i < 20; ++i) judged.add(fix(100.0 + i, 2.0 * i, 0.0));
  EXPECT_TRUE(judged.search.proven());
  for (int i = 0; i < 100; ++i) judged.add(fix(120.0 + i, 1e6, 0.0));
  EXPECT_LT(judged.place().norm(), 1.0);
  EXPECT_EQ(judged.fates, std::string(120, 'a')) << "from then on the localizer judges";
}

TEST(DatumSearch, ScatterAndReflectionsDelayNoStart) {
  Judged judged;
  for (int i = 0; i < 40; ++i) {
    judged.add(fix(100.0 + 0.2 * i, 8.0 * std::sin(2.0 * i), 8.0 * std::cos(3.0 * i), 0.02));
  }
  EXPECT_EQ(judged.fates, std::string(40, 'a'));
}

TEST(DatumSearch, WhatDeclaresNoCovarianceAgreesToo) {
  Judged judged;
  for (int i = 0; i < 3; ++i) {
    auto message = std::get<ReceiverFix>(fix(100.0 + i, 0.0, 0.0));
    message.position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_UNKNOWN;
    judged.add(message);
  }
  EXPECT_EQ(judged.fates, "aaa");
}

TEST(DatumSearch, AveragesTheTimeAskedFor) {
  Judged judged(2.0);
  for (int i = 0; i < 2; ++i) judged.add(fix(100.0 + 0.5 * i, 1.0 * i, 0.0));
  judged.add(fix(101.0, 2.0, 0.0));
  judged.add(fix(101.5, 3.0, 0.0));
  EXPECT_EQ(judged.fates, "nnnn");
  judged.add(fix(102.0, 4.0, 0.0));
  EXPECT_EQ(judged.fates, "nnnna");
  EXPECT_NEAR(judged.place().x(), 2.0, 0.01) << "the median";
}

TEST(DatumSearch, GivesUpWhatWaits) {
  Judged judged;
  judged.add(fix(100.0, 0.0, 0.0));
  EXPECT_EQ(judged.search.take_waiting().size(), 1u);
  EXPECT_TRUE(judged.search.take_waiting().empty());
}

}  // namespace
}  // namespace multipath_localization
