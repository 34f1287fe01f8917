#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/rival.hpp"

namespace multipath_localization::multipath {
namespace {

constexpr double kSpeed = 2.0;  // [m/s]
constexpr double kSigma = 0.3;  // of a fix [m]

/// A robot whose cloud has settled on a drive along x, and which its truth may leave.
class DoubtedCloud : public ::testing::Test {
 protected:
  DoubtedCloud() : cloud_(settings(), 1), rival_(settings(), 2) {
    cloud_.start(fix_at(truth_.position()));
    drive(40, Eigen::Vector2d::Zero(), false);
  }

  static CloudSettings settings() {
    CloudSettings settings;
    settings.particles = 400;
    return settings;
  }

  static GnssFix fix_at(const Eigen::Vector2d& position) {
    GnssFix fix;
    fix.position = position;
    fix.covariance = kSigma * kSigma * Eigen::Matrix2d::Identity();
    return fix;
  }

  /// Straight on for that many seconds, with fixes that are off by `bias` [m].
  void drive(int seconds, const Eigen::Vector2d& bias, bool with_rival) {
    for (int i = 0; i < seconds; ++i) {
      OdometrySum odometry(OdometryNoise{});
      for (int k = 0; k < 10; ++k) odometry.add({0.1 * ++increments_, 0.1, kSpeed, 0.0});
      truth_ = truth_ * Pose2{kSpeed, 0.0, 0.0};
      cloud_.propagate(odometry);
      rival_.propagate(odometry);
      Sighting z;
      RandomStream random(7, static_cast<std::uint32_t>(increments_), 0);
      const double east = kSigma * random.normal();
      z.fix = fix_at(truth_.position() + bias + Eigen::Vector2d(east, kSigma * random.normal()));
      z.duration = 1.0;
      z.usual_speed = kSpeed;
      z.shadow_entry_rate = 1.0 / 60.0;
      const double log_density = cloud_.weigh(z);
      if (with_rival) rival_.weigh(z, log_density, cloud_);
    }
  }

  [[nodiscard]] double error() const { return (cloud_.mixture().mean.head<2>() - truth_.position()).norm(); }

  Pose2 truth_;
  HypothesisCloud cloud_;
  Rival rival_;
  int increments_ = 0;
};

TEST_F(DoubtedCloud, FindsBackFromAHeadingLostUnseen) {
  truth_ = Pose2{truth_.x + 12.0, truth_.y, 1.5};
  drive(40, Eigen::Vector2d::Zero(), true);
  EXPECT_LT(error(), 1.0);
  EXPECT_NEAR(cloud_.mixture().mean(kYaw), 1.5, 0.1);
  EXPECT_LT(cloud_.mixture().shadow, 0.5);
}

TEST_F(DoubtedCloud, KeepsItsPlaceInAShadowThatGoesWithIt) {
  drive(15, Eigen::Vector2d(0.0, 10.0), true);
  EXPECT_LT(error(), 3.0);
  drive(10, Eigen::Vector2d::Zero(), true);
  EXPECT_LT(error(), 1.0);
}

TEST_F(DoubtedCloud, IsLeftAloneUnderOpenSky) {
  const std::size_t before = cloud_.hypotheses().size();
  drive(30, Eigen::Vector2d::Zero(), true);
  EXPECT_EQ(cloud_.hypotheses().size(), before);
  EXPECT_LT(error(), 0.5);
}

}  // namespace
}  // namespace multipath_localization::multipath
