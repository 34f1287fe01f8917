#include <gtest/gtest.h>

#include "multipath_localization/core/random.hpp"
#include "tools/doctor/shape_fit.hpp"

namespace multipath_localization {
namespace {

/// Two hundred metres of bends, odometry with the yaw rate times `sign` and the speed times `scale`.
ShapeFit fit_of(double sign, double scale, double sigma) {
  std::vector<OdometryIncrement> odometry;
  std::vector<GnssFix> fixes;
  Pose2 truth{100.0, -20.0, 2.0};
  for (std::uint32_t i = 1; i <= 2000; ++i) {
    OdometryIncrement u{0.1 * i, 0.1, 1.0, i % 400 < 200 ? 0.15 : -0.15};
    truth = truth * displacement(u);
    u.speed *= scale;
    u.yaw_rate *= sign;
    odometry.push_back(u);
    RandomStream random(1, i, 0);
    GnssFix fix;
    fix.stamp = u.stamp;
    fix.position = truth.position() + sigma * Eigen::Vector2d(random.normal(), random.normal());
    fixes.push_back(fix);
  }
  return fit_shape(fixes, OdometryTrack(odometry));
}

TEST(ShapeFit, FindsShapeAndScaleWhateverTheHeading) {
  const ShapeFit fit = fit_of(1.0, 0.8, 0.3);
  EXPECT_TRUE(fit.tells_scale());
  EXPECT_FALSE(fit.fits());
  EXPECT_NEAR(fit.scale, 1.25, 0.02);
  EXPECT_TRUE(fit_of(1.0, 1.0, 0.3).fits());
  EXPECT_GT(fit.alike, fit.pieces / 2);
  EXPECT_EQ(fit.opposite, 0U);
}

TEST(ShapeFit, CoarseFixesDoNotLengthenTheWay) { EXPECT_NEAR(fit_of(1.0, 1.0, 2.0).scale, 1.0, 0.05); }

TEST(ShapeFit, FindsAWayThatIsTurnedOver) {
  const ShapeFit fit = fit_of(-1.0, 1.0, 0.3);
  EXPECT_FALSE(fit.same_shape());
  EXPECT_EQ(fit.alike, 0U);
  EXPECT_GT(fit.opposite, fit.pieces / 2);
}

TEST(ShapeFit, OfNoDriveTellsNothing) {
  const ShapeFit fit = fit_shape({}, OdometryTrack({}));
  EXPECT_EQ(fit.pieces, 0U);
  EXPECT_FALSE(fit.same_shape() || fit.tells_scale() || fit.fits());
}

}  // namespace
}  // namespace multipath_localization
