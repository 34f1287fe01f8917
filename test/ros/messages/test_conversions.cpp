#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "good_fix.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Reason reason(const sensor_msgs::NavSatFix& fix) { return to_fix(fix, berlin(), FixParameters{}).reason; }

template <class Change>
Reason reason_after(Change change) {
  sensor_msgs::NavSatFix fix = good_fix();
  change(fix);
  return reason(fix);
}

TEST(ToFix, KeepsStampPlaceCovarianceAndLeverArm) {
  const CheckedFix checked = to_fix(good_fix(), berlin(), FixParameters{}, {0.3, 0.1});
  ASSERT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(checked.fix.stamp, 100.5);
  EXPECT_TRUE(checked.fix.position.isApprox(berlin().to_map({52.501, 13.402, 45.0})));
  EXPECT_GT(checked.fix.position.x(), 0.0) << "east of the datum";
  EXPECT_GT(checked.fix.position.y(), 0.0) << "north of the datum";
  EXPECT_EQ(checked.fix.covariance, (Eigen::Matrix2d() << 4.0, 1.0, 1.0, 9.0).finished());
  EXPECT_EQ(checked.fix.antenna_in_base, Eigen::Vector2d(0.3, 0.1));
}

TEST(ToFix, ClaimsTheStatusOfTheMessage) {
  sensor_msgs::NavSatFix message = good_fix();
  message.status.status = sensor_msgs::NavSatStatus::STATUS_GBAS_FIX;
  EXPECT_EQ(to_fix(message, berlin(), FixParameters{}).fix.status, FixStatus::kGroundBased);
  message.status.status = 17;  // that nobody knows
  EXPECT_EQ(to_fix(message, berlin(), FixParameters{}).fix.status, FixStatus::kSingle);
}

TEST(ToFix, RefusesStampOfZero) {
  EXPECT_EQ(reason_after([](auto& f) { f.header.stamp = ros::Time(); }), Reason::kZeroStamp);
}

TEST(ToFix, RefusesANameOfAFrameThatIsTooLong) {
  EXPECT_EQ(reason_after([](auto& f) { f.header.frame_id = std::string(256, 'a'); }), Reason::kAccepted);
  EXPECT_EQ(reason_after([](auto& f) { f.header.frame_id = std::string(257, 'a'); }), Reason::kInvalidFrame);
}

TEST(Frame, IsShownCutOffWhereItIsTooLong) {
  EXPECT_EQ(shown("gps"), "gps");
  EXPECT_EQ(shown(std::string(1000000, 'a')).size(), 256U + 3U);
}

TEST(ToFix, RefusesStatusBelowTheOneAskedFor) {
  sensor_msgs::NavSatFix fix = good_fix();
  fix.status.status = -1;
  EXPECT_EQ(reason(fix), Reason::kNoFix);
  FixParameters any;
  any.min_fix_status = -1;
  EXPECT_EQ(to_fix(fix, berlin(), any).reason, Reason::kAccepted);
}

TEST(ToFix, RefusesPlacesThatAreNone) {
  EXPECT_EQ(reason_after([](auto& f) { f.latitude = kNan; }), Reason::kNotFinite);
  EXPECT_EQ(reason_after([](auto& f) { f.longitude = kInfinity; }), Reason::kNotFinite);
  EXPECT_EQ(reason_after([](auto& f) { f.latitude = 90.1; }), Reason::kInvalidPosition);
  EXPECT_EQ(reason_after([](auto& f) { f.longitude = 1e308; }), Reason::kInvalidPosition);
  EXPECT_EQ(reason_after([](auto& f) { f.altitude = 1e308; }), Reason::kInvalidPosition);
  EXPECT_EQ(reason_after([](auto& f) { f.altitude = -kInfinity; }), Reason::kInvalidPosition);
}

TEST(ToFix, RefusesWhatTheMapDoesNotReach) {
  EXPECT_EQ(reason_after([](auto& f) { f.latitude = 53.3; }), Reason::kAccepted) << "89 km";
  EXPECT_EQ(reason_after([](auto& f) { f.latitude = 53.5; }), Reason::kInvalidPosition) << "111 km";
  EXPECT_EQ(reason_after([](auto& f) { f.latitude = f.longitude = 0.0; }), Reason::kInvalidPosition);
  EXPECT_EQ(reason_after([](auto& f) { f.latitude = 0.0; }), Reason::kInvalidPosition);
}

TEST(ToFix, AcceptsAltitudeNaN) {
  sensor_msgs::NavSatFix fix = good_fix();
  fix.altitude = kNan;
  const CheckedFix checked = to_fix(fix, berlin(), FixParameters{});
  ASSERT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_TRUE(checked.fix.position.allFinite());
}

TEST(ToFix, TakesTheDefaultWhereNoCovarianceIsDeclared) {
  FixParameters parameters;
  parameters.default_sigma = 2.0;
  const Eigen::Matrix2d expected = 4.0 * Eigen::Matrix2d::Identity();
  sensor_msgs::NavSatFix zero = good_fix();
  zero.position_covariance.assign(0.0);
  EXPECT_EQ(to_fix(zero, berlin(), parameters).fix.covariance, expected);
  sensor_msgs::NavSatFix unknown = good_fix();
  unknown.position_covariance_type = 0;
  unknown.position_covariance.assign(kNan);
  EXPECT_EQ(to_fix(unknown, berlin(), parameters).reason, Reason::kAccepted);
  EXPECT_EQ(to_fix(unknown, berlin(), parameters).fix.covariance, expected);
  EXPECT_TRUE(std::isnan(declared_sigma(unknown)));
}

TEST(ToFix, RefusesCovariancesThatAreNone) {
  const Reason none = Reason::kInvalidCovariance;
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance[0] = kNan; }), none);
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance[4] = kInfinity; }), none);
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance[0] = -1.0; }), none);
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance[4] = 1e308; }), none);
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance[1] = f.position_covariance[3] = 7.0; }), none);
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance[1] = -1.0; }), none) << "not symmetric";
  sensor_msgs::NavSatFix rounded = good_fix();
  rounded.position_covariance[1] += 4e-6;
  const CheckedFix checked = to_fix(rounded, berlin(), FixParameters{});
  EXPECT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(checked.fix.covariance(0, 1), checked.fix.covariance(1, 0)) << "filters take it for symmetric";
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance_type = 4; }), none);
}

TEST(ToFix, LooksAtNothingVerticalAndAtOffDiagonalsOnlyWhereTheyAreKnown) {
  EXPECT_EQ(reason_after([](auto& f) { f.position_covariance[8] = kNan; }), Reason::kAccepted);
  sensor_msgs::NavSatFix diagonal = good_fix();
  diagonal.position_covariance_type = 2;
  diagonal.position_covariance[1] = kNan;
  EXPECT_EQ(to_fix(diagonal, berlin(), FixParameters{}).fix.covariance,
            Eigen::Matrix2d(Eigen::Vector2d(4.0, 9.0).asDiagonal()));
}

TEST(ToMessage, IsUndoneByToFix) {
  GnssFix fix;
  fix.stamp = 100.5;
  fix.position = {1234.5, -876.25};
  fix.covariance << 4.0, 1.0, 1.0, 9.0;
  fix.status = FixStatus::kSatelliteBased;
  std_msgs::Header header;
  header.stamp = ros::Time(100, 500000000);
  header.frame_id = "gps";
  const sensor_msgs::NavSatFix message = to_message(fix, berlin(), header);
  EXPECT_EQ(message.header.frame_id, "gps");
  const CheckedFix back = to_fix(message, berlin(), FixParameters{});
  ASSERT_EQ(back.reason, Reason::kAccepted);
  EXPECT_EQ(back.fix.stamp, fix.stamp);
  EXPECT_LT((back.fix.position - fix.position).norm(), 1e-6);
  EXPECT_EQ(back.fix.covariance, fix.covariance);
  EXPECT_EQ(back.fix.status, fix.status);
}

TEST(ToDual, ReadsBothFixesWithTheirAntennas) {
  FixPair pair{good_fix(), good_fix()};
  pair.right.latitude += 1e-5;
  pair.right.header.stamp += ros::Duration(0.01);
  const CheckedDual checked = to_dual(pair, berlin(), FixParameters{}, {0.0, 0.5}, {0.0, -0.5});
  ASSERT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_DOUBLE_EQ(checked.fix.stamp, 100.51) << "of the later one";
  EXPECT_EQ(checked.fix.left.antenna_in_base, Eigen::Vector2d(0.0, 0.5));
  EXPECT_EQ(checked.fix.right.antenna_in_base, Eigen::Vector2d(0.0, -0.5));
  EXPECT_NEAR((checked.fix.right.position - checked.fix.left.position).y(), 1.113, 0.001);
  EXPECT_NEAR(checked.fix.right.stamp, 100.51, 1e-9);
}

TEST(ToDual, RefusesForEitherFix) {
  const auto refusal = [](const FixPair& pair) {
    return to_dual(pair, berlin(), FixParameters{}, {0.0, 0.5}, {0.0, -0.5}).reason;
  };
  FixPair pair{good_fix(), good_fix()};
  pair.right.latitude = kNan;
  EXPECT_EQ(refusal(pair), Reason::kNotFinite);
  pair.left.status.status = -1;
  EXPECT_EQ(refusal(pair), Reason::kNoFix) << "the left one's reason first";
}

TEST(ToDual, RefusesAntennasInOnePlace) {
  const FixPair pair{good_fix(), good_fix()};
  EXPECT_EQ(to_dual(pair, berlin(), FixParameters{}, {0.1, 0.0}, {0.1, 0.005}).reason, Reason::kInvalidFrame);
}

TEST(ToPose2, IsUndoneByToMessage) {
  for (const double yaw : {-3.1, -1.0, 0.0, 0.5, kPi}) {
    const auto back = to_pose2(to_message(Pose2{1.5, -2.0, yaw}));
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, 1.5, 1e-12);
    EXPECT_NEAR(back->y, -2.0, 1e-12);
    EXPECT_NEAR(angle_difference(back->yaw, yaw), 0.0, 1e-12);
  }
}

TEST(ToPose2, TakesYawOutOfATiltedPose) {
  geometry_msgs::Pose pose;  // yaw 90 degrees after a roll of 10 degrees about x
  const double roll = 10.0 * kPi / 180.0;
  pose.orientation.w = std::cos(0.5 * roll) * std::sqrt(0.5);
  pose.orientation.x = std::sin(0.5 * roll) * std::sqrt(0.5);
  pose.orientation.y = std::sin(0.5 * roll) * std::sqrt(0.5);
  pose.orientation.z = std::cos(0.5 * roll) * std::sqrt(0.5);
  ASSERT_TRUE(to_pose2(pose));
  EXPECT_NEAR(to_pose2(pose)->yaw, 0.5 * kPi, 1e-12);
}

TEST(ToPose2, RefusesWhatIsNoPose) {
  geometry_msgs::Pose pose;
  EXPECT_TRUE(to_pose2(pose)) << "four zeros: no orientation filled in";
  pose.orientation.w = 0.5;
  EXPECT_FALSE(to_pose2(pose));
  pose.orientation.w = 1.0;
  pose.position.z = 1e308;
  EXPECT_FALSE(to_pose2(pose));
  pose.position.z = kNan;
  EXPECT_FALSE(to_pose2(pose));
}

TEST(ToPrior, TakesXYYawOutOfSixBySix) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.pose.pose = to_message(Pose2{1.0, 2.0, 0.5});
  message.pose.covariance[0] = 0.25;
  message.pose.covariance[7] = 0.5;
  message.pose.covariance[1] = message.pose.covariance[6] = 0.1;
  message.pose.covariance[35] = 0.07;
  const auto prior = to_prior(message);
  ASSERT_TRUE(prior);
  const Eigen::Matrix3d expected =
      (Eigen::Matrix3d() << 0.25, 0.1, 0.0, 0.1, 0.5, 0.0, 0.0, 0.0, 0.07).finished();
  EXPECT_EQ(prior->covariance, expected);
  geometry_msgs::PoseWithCovarianceStamped bare = message;
  bare.pose.covariance.assign(0.0);
  ASSERT_TRUE(to_prior(bare));
  EXPECT_EQ(to_prior(bare)->covariance(0, 0), 0.25) << "the default";
  message.pose.covariance[0] = 1e308;
  EXPECT_FALSE(to_prior(message)) << "squares of it are infinite";
  message.pose.covariance[0] = 0.25;
  message.pose.covariance[35] = 0.0;
  EXPECT_FALSE(to_prior(message)) << "nobody knows a heading that well";
  message.pose.covariance[35] = kNan;
  EXPECT_FALSE(to_prior(message));
}

TEST(ToPose2, TakesAQuaternionTypedInWithADigit) {
  geometry_msgs::Pose pose;
  pose.orientation.z = pose.orientation.w = 0.7;
  ASSERT_TRUE(to_pose2(pose));
  EXPECT_NEAR(to_pose2(pose)->yaw, 0.5 * kPi, 1e-12);
  pose.orientation.z = 0.5;
  EXPECT_FALSE(to_pose2(pose));
}

TEST(DefectOf, SaysWhatOfAStartCannotBeUsed) {
  geometry_msgs::PoseWithCovarianceStamped message;
  EXPECT_EQ(defect_of(message), "its quaternion is all zero, which is no orientation");
  EXPECT_FALSE(to_prior(message));
  message.pose.pose.orientation.w = 0.5;
  EXPECT_NE(defect_of(message).find("its quaternion is 0.5"), std::string::npos);
  message.pose.pose.orientation.w = 1.0;
  EXPECT_EQ(defect_of(message), "");
  message.pose.covariance[0] = -1.0;
  EXPECT_NE(defect_of(message).find("covariance"), std::string::npos);
  message.pose.pose.position.x = kNan;
  EXPECT_NE(defect_of(message).find("position"), std::string::npos);
}

TEST(WithMotion, CarriesWhatWasReadAndNothingThatIsNotFinite) {
  nav_msgs::Odometry odometry;
  odometry.twist.twist.linear.z = kNan;
  odometry.twist.covariance[0] = kInfinity;
  const nav_msgs::Odometry read = with_motion(odometry, OdometryIncrement{1.0, 0.1, -2.0, 0.5, 0.3});
  EXPECT_EQ(read.twist.twist.linear.x, -2.0);
  EXPECT_EQ(read.twist.twist.angular.z, 0.5);
  EXPECT_EQ(read.twist.twist.linear.y, 0.3);
  EXPECT_EQ(read.twist.twist.linear.z, 0.0);
  EXPECT_EQ(read.twist.covariance[0], 0.0);
}

TEST(ToTransform, IsThePoseOfTheChild) {
  const geometry_msgs::Transform transform = to_transform(Pose2{10.0, -3.0, 2.0});
  EXPECT_EQ(transform.translation.x, 10.0);
  EXPECT_EQ(transform.translation.y, -3.0);
  EXPECT_NEAR(2.0 * std::atan2(transform.rotation.z, transform.rotation.w), 2.0, 1e-12);
}

TEST(Vectors, KeepTheirNumbersThereAndBack) {
  const Eigen::Vector3d vector(1.0, -2.0, 3.5);
  EXPECT_EQ(to_message(vector).y, -2.0);
  EXPECT_EQ(vector_of(to_message(vector)), vector);
}

TEST(Frames, LoseALeadingSlash) {
  EXPECT_EQ(without_slash("/gps"), "gps");
  EXPECT_EQ(without_slash("gps"), "gps");
  EXPECT_EQ(without_slash(""), "");
}

}  // namespace
}  // namespace multipath_localization
