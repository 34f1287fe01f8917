#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "good_fix.hpp"
#include "ros/localization_node/estimate_messages.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

PoseEstimate some_estimate() {
  PoseEstimate estimate;
  estimate.valid = true;
  estimate.pose = {10.0, -3.0, 2.0};
  estimate.covariance << 1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 0.5;
  estimate.position_covariance_overall << 4.0, 0.4, 0.4, 5.0;
  return estimate;
}

TEST(ToMessage, FillsARowMajorSixBySix) {
  const geometry_msgs::PoseWithCovariance message = to_message(some_estimate());
  Eigen::Matrix<double, 6, 6> covariance;
  for (int i = 0; i < 36; ++i) covariance(i / 6, i % 6) = message.covariance[static_cast<std::size_t>(i)];
  EXPECT_EQ((covariance - covariance.transpose()).norm(), 0.0);
  EXPECT_NEAR(covariance(0, 0), 4.0, 1e-12);
  EXPECT_NEAR(covariance(0, 1), 0.4, 1e-12);
  EXPECT_NEAR(covariance(1, 1), 5.0, 1e-12);
  EXPECT_EQ(covariance(0, 5), 0.2);
  EXPECT_EQ(covariance(1, 5), 0.3);
  EXPECT_EQ(covariance(5, 5), 0.5);
  EXPECT_EQ(covariance.block(2, 0, 3, 6).cwiseAbs().sum(), 0.0);
}

TEST(ToOdometry, HasStampTwistAndTiltOfTheOdometryItStandsFor) {
  ReadOdometry odometry;
  odometry.message.header.stamp = ros::Time(12.5);
  odometry.message.twist.twist.linear.x = 1.5;
  odometry.tilt = {0.1, -0.2};
  const nav_msgs::Odometry message = to_odometry(some_estimate(), odometry, "map", "base_link");
  EXPECT_EQ(message.header.stamp, ros::Time(12.5));
  EXPECT_EQ(message.twist.twist.linear.x, 1.5);
  const geometry_msgs::Quaternion& q = message.pose.pose.orientation;
  const Eigen::Quaterniond read(q.w, q.x, q.y, q.z);
  const Tilt tilt = tilt_of(read.conjugate() * Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(tilt.roll, 0.1, 1e-9);
  EXPECT_NEAR(tilt.pitch, -0.2, 1e-9);
  const Eigen::Vector3d forwards = read * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(std::atan2(forwards.y(), forwards.x()), 2.0, 1e-9);
}

TEST(ToPoseArray, CapsTheCloudAndKeepsItsSpread) {
  std::vector<Hypothesis> cloud(1000);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud[i].pose.x = static_cast<double>(i);
  const geometry_msgs::PoseArray array = to_pose_array(cloud, 10, std_msgs::Header());
  ASSERT_EQ(array.poses.size(), 10u);
  EXPECT_EQ(array.poses[9].position.x, 900.0);
  EXPECT_EQ(to_pose_array(cloud, 5000, std_msgs::Header()).poses.size(), 1000u);
  EXPECT_TRUE(to_pose_array({}, 10, std_msgs::Header()).poses.empty());
}

TEST(ToReport, IntroducesEachKind) {
  const FixReport fix = to_report(good_fix());
  EXPECT_EQ(fix.kind, "fix");
  EXPECT_EQ(fix.header.stamp, good_fix().header.stamp);
  EXPECT_NEAR(fix.declared_sigma, std::sqrt(6.5), 1e-12);
  EXPECT_EQ(fix.satellites, 0u);

  FixPair pair{good_fix(), good_fix()};
  pair.left.header.frame_id = "gps_left";
  pair.right.position_covariance[0] = pair.right.position_covariance[4] = 0.5;
  const FixReport dual = to_report(pair);
  EXPECT_EQ(dual.kind, "dual");
  EXPECT_EQ(dual.header.frame_id, "gps_left");
  EXPECT_NEAR(dual.declared_sigma, std::sqrt(0.5 * (6.5 + 0.5)), 1e-12);

  GnssEpoch raw;
  raw.pseudoranges.resize(7);
  const FixReport epoch = to_report(raw);
  EXPECT_EQ(epoch.kind, "epoch");
  EXPECT_EQ(epoch.satellites, 7u);
  EXPECT_TRUE(std::isnan(epoch.declared_sigma));
}

TEST(Concluded, SaysWhatBecameOfAMeasurement) {
  Innovation innovation = refused(Reason::kGated);
  innovation.innovation = {3.0, -4.0};
  innovation.covariance = 2.25 * Eigen::Matrix2d::Identity();
  const FixReport report = concluded(to_report(good_fix()), innovation, 101.0);
  EXPECT_FALSE(report.accepted);
  EXPECT_EQ(report.reason, "gated");
  EXPECT_EQ(report.innovation_y, -4.0);
  EXPECT_NEAR(report.predicted_sigma, 1.5, 1e-12);
  EXPECT_NEAR(report.age, 0.5, 1e-9);
}

TEST(SigmasTold, AreThoseThatAreKnown) {
  FixReport report = to_report(good_fix());
  EXPECT_EQ(sigmas_told(report), "declared 2.55 m");
  report.declared_sigma = 0.1;
  report.observed_sigma = 4.2;
  report.used_sigma = 4.5;
  EXPECT_EQ(sigmas_told(report), "declared 0.10 m, observed 4.20 m, using 4.50 m");
  EXPECT_EQ(sigmas_told(to_report(GnssEpoch())), "");
}

TEST(Concluded, KnowsNoAgeWithoutStamps) {
  sensor_msgs::NavSatFix unstamped = good_fix();
  unstamped.header.stamp = ros::Time();
  EXPECT_EQ(concluded(to_report(unstamped), Innovation{}, 101.0).age, 0.0);
  EXPECT_EQ(concluded(to_report(good_fix()), Innovation{}, 0.0).age, 0.0);
}

TEST(ToNavSatFix, ClaimsAFixOnlyWhereThePoseCanBeTrusted) {
  const PoseEstimate estimate = some_estimate();
  const auto fix = to_nav_sat_fix(estimate, Trust::kMultipath, berlin(), std_msgs::Header());
  EXPECT_EQ(fix.status.status, 0);
  EXPECT_TRUE(berlin().to_map(to_geodetic(fix)).isApprox(estimate.pose.position(), 1e-6));
  EXPECT_EQ(fix.position_covariance[4], 5.0);
  for (const Trust trust : {Trust::kNotReady, Trust::kAligning, Trust::kLost}) {
    EXPECT_EQ(to_nav_sat_fix(estimate, trust, berlin(), std_msgs::Header()).status.status, -1);
  }
}

TEST(Finite, SeesNaNInAnyPart) {
  EXPECT_TRUE(finite(some_estimate()));
  PoseEstimate bad = some_estimate();
  bad.covariance(1, 2) = kNan;
  EXPECT_FALSE(finite(bad));
  bad = some_estimate();
  bad.pose.yaw = kInfinity;
  EXPECT_FALSE(finite(bad));
}

}  // namespace
}  // namespace multipath_localization
