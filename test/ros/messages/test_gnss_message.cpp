#include <gtest/gtest.h>

#include "good_epoch.hpp"
#include "ros/messages/gnss_message.hpp"
#include "ros/messages/heading_conversions.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector2d kAntenna(0.3, 0.1);

std::optional<Eigen::Vector2d> known(const std::string& frame) {
  if (frame == "gps") return kAntenna;
  if (frame == "gps_right") return -kAntenna;
  return std::nullopt;
}

FixPair good_pair() {
  FixPair pair{good_fix(), good_fix()};
  pair.right.header.frame_id = "gps_right";
  return pair;
}

CheckedMeasurement read(const GnssMessage& message, const GnssParameters& parameters = {}) {
  return to_measurement(message, berlin(), parameters, known);
}

GnssMessage with_frame(GnssMessage message, const std::string& frame) {
  if (auto* fix = std::get_if<ReceiverFix>(&message)) fix->header.frame_id = frame;
  if (auto* pair = std::get_if<FixPair>(&message)) pair->right.header.frame_id = frame;
  if (auto* epoch = std::get_if<GnssEpoch>(&message)) epoch->header.frame_id = frame;
  return message;
}

TEST(ToMeasurement, KeepsTheKindAndFindsTheAntennas) {
  const CheckedMeasurement fix = read(good_fix());
  ASSERT_EQ(fix.reason, Reason::kAccepted);
  EXPECT_EQ(std::get<GnssFix>(fix.measurement).antenna_in_base, kAntenna);
  const CheckedMeasurement dual = read(good_pair());
  ASSERT_EQ(dual.reason, Reason::kAccepted);
  EXPECT_EQ(std::get<DualAntennaFix>(dual.measurement).left.antenna_in_base, kAntenna);
  EXPECT_EQ(std::get<DualAntennaFix>(dual.measurement).right.antenna_in_base, -kAntenna);
  const CheckedMeasurement epoch = read(good_epoch());
  ASSERT_EQ(epoch.reason, Reason::kAccepted);
  EXPECT_EQ(std::get<PseudorangeEpoch>(epoch.measurement).antenna_in_base, kAntenna);
  EXPECT_EQ(satellites_of(epoch.measurement), 13u);
  EXPECT_EQ(satellites_of(fix.measurement), 0u);
}

TEST(ToMeasurement, TurnsAHeadingAsItsSensorIsMounted) {
  std_msgs::Header header = good_fix().header;
  header.frame_id = "compass";
  const GnssMessage message = to_message(Heading{header.stamp.toSec(), 1.0, 0.01}, header);
  const RotationFinder across = [](const std::string& frame) {
    std::optional<Eigen::Quaterniond> found;
    if (frame == "compass") found = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());
    return found;
  };
  const CheckedMeasurement checked = to_measurement(message, berlin(), {}, known, across);
  ASSERT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_NEAR(std::get<Heading>(checked.measurement).yaw, 0.6, 1e-9);
  EXPECT_NEAR(std::get<Heading>(read(message).measurement).yaw, 1.0, 1e-9)
      << "as the base where tf is silent";
  EXPECT_EQ(name_of(message), "heading");
  EXPECT_TRUE(frames_of(message).empty()) << "it waits for no antenna";
  EXPECT_FALSE(place_of(message, {}));
  EXPECT_NEAR(declared_sigma(message), 0.1, 1e-12);
}

TEST(ToMeasurement, KeepsWhoseFixItIs) {
  const GnssMessage message = ReceiverFix(good_fix(), 2);
  const CheckedMeasurement checked = read(message);
  ASSERT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(std::get<GnssFix>(checked.measurement).receiver, 2u);
  EXPECT_EQ(name_of(message), "fix_3");
  EXPECT_EQ(name_of(checked.measurement), "fix_3");
  EXPECT_EQ(name_of(GnssMessage(good_fix())), "fix");
  EXPECT_EQ(name_of(GnssMessage(good_epoch())), "epoch");
  EXPECT_EQ(fix_topic(0), "gps/fix");
  EXPECT_EQ(fix_topic(1), "gps_2/fix");
}

TEST(ToMeasurement, TakesALoneAntennaToBeAtTheBaseUnlessItMayNot) {
  GnssParameters strict;
  strict.require_antenna_transform = true;
  GnssParameters given;
  given.antenna = {0.4, -0.2};
  for (const GnssMessage& message : {GnssMessage(good_fix()), GnssMessage(good_epoch())}) {
    const GnssMessage lost = with_frame(message, "nowhere");
    EXPECT_EQ(read(lost).reason, Reason::kAccepted);
    EXPECT_EQ(read(lost, strict).reason, Reason::kInvalidFrame);
  }
  const auto fix = std::get<GnssFix>(read(with_frame(good_fix(), "nowhere")).measurement);
  EXPECT_EQ(fix.antenna_in_base, Eigen::Vector2d(0.0, 0.0));
  const auto placed = std::get<GnssFix>(read(with_frame(good_fix(), "nowhere"), given).measurement);
  EXPECT_EQ(placed.antenna_in_base, Eigen::Vector2d(0.4, -0.2));
  const auto known = std::get<GnssFix>(read(good_fix(), given).measurement);
  EXPECT_EQ(known.antenna_in_base, kAntenna) << "tf counts first";
}

TEST(ToMeasurement, NeedsToKnowBothOfTwoAntennas) {
  EXPECT_EQ(read(with_frame(good_pair(), "nowhere")).reason, Reason::kInvalidFrame);
}

TEST(StampedEarlier, TakesTheDelayOffButMakesNoStampZero) {
  sensor_msgs::NavSatFix fix = good_fix();
  fix.header.stamp = ros::Time(10, 500000000);
  EXPECT_NEAR(stamped_earlier(fix, 0.3).header.stamp.toSec(), 10.2, 1e-9);
  EXPECT_NEAR(stamped_earlier(fix, -0.3).header.stamp.toSec(), 10.8, 1e-9);
  EXPECT_EQ(stamped_earlier(fix, 0.0).header.stamp, fix.header.stamp);
  EXPECT_EQ(stamped_earlier(fix, 11.0).header.stamp, ros::Time(0, 1));
  fix.header.stamp = ros::Time();
  EXPECT_EQ(stamped_earlier(fix, 0.3).header.stamp, ros::Time());
  fix.header.stamp = ros::Time(4294967295, 0);
  EXPECT_NO_THROW(stamped_earlier(fix, -2.0));
}

TEST(Check, FindsDefectsOfEachKind) {
  EXPECT_EQ(check(GnssMessage(good_pair()), GnssParameters{}), Reason::kAccepted);
  FixPair pair = good_pair();
  pair.right.status.status = -1;
  EXPECT_EQ(check(GnssMessage(pair), GnssParameters{}), Reason::kNoFix);
  GnssEpoch epoch = good_epoch();
  epoch.pseudoranges.clear();
  EXPECT_EQ(check(GnssMessage(epoch), GnssParameters{}), Reason::kTooFewSatellites);
  sensor_msgs::NavSatFix fix = good_fix();
  fix.latitude = 91.0;
  EXPECT_EQ(check(GnssMessage(fix), GnssParameters{}), Reason::kInvalidPosition);
}

TEST(PlaceOf, IsThatOfTheFixTheLeftOneOrTheSolution) {
  const GnssParameters parameters;
  EXPECT_EQ(place_of(good_fix(), parameters)->latitude_deg, 52.501);
  FixPair pair = good_pair();
  pair.right.latitude = 52.6;
  EXPECT_EQ(place_of(pair, parameters)->latitude_deg, 52.501);
  EXPECT_LT((berlin().to_map(*place_of(good_epoch(), parameters)) - Eigen::Vector2d(320.0, -150.0)).norm(),
            0.01);
}

}  // namespace
}  // namespace multipath_localization
