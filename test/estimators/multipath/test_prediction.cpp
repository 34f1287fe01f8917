#include <gtest/gtest.h>

#include "estimators/multipath/prediction.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(Prediction, CarriesTheMeanAlongAndItsHeadingErrorAcross) {
  OdometrySum odometry({0.005, 0.002, 0.03, 0.004, 1.5e-4, 2e-5});
  for (int i = 1; i <= 50; ++i) odometry.add({0.02 * i, 0.02, 2.0, 0.0});
  Mixture mixture;
  mixture.mean.head<3>() << 1.0, 2.0, 0.5 * kPi;
  mixture.covariance = Eigen::Vector3d(0.01, 0.01, 0.04).asDiagonal();
  const Prediction prediction = predicted(mixture, odometry);
  EXPECT_LT((prediction.pose.position() - Eigen::Vector2d(1.0, 4.0)).norm(), 1e-9);
  EXPECT_NEAR(prediction.covariance(0, 0), 0.01 + 4.0 * 0.04, 0.01);
  EXPECT_NEAR(prediction.covariance(1, 1), 0.01, 0.005);
}

}  // namespace
}  // namespace multipath_localization::multipath
