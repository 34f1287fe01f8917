#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "multipath_localization/core/angle.hpp"
#include "simulation/compass.hpp"

namespace multipath_localization {
namespace {

std::vector<Heading> read(const CompassParameters& parameters, double yaw,
                          const std::vector<SensorFault>& faults = {}) {
  Compass compass(parameters, faults, 3);
  std::vector<Heading> all;
  for (int i = 1; i <= 1000; ++i) {
    for (const Heading& heading : compass.step(yaw, 0.01 * i)) all.push_back(heading);
  }
  return all;
}

CompassParameters at_50_hz() {
  CompassParameters parameters;
  parameters.rate = 50.0;
  parameters.outlier_share = 0.0;
  return parameters;
}

TEST(Compass, IsNotThereWithoutARate) { EXPECT_TRUE(read({}, 0.5).empty()); }

TEST(Compass, ReadsTheYawWithOffsetAndNoise) {
  CompassParameters parameters = at_50_hz();
  parameters.offset = 0.3;
  parameters.noise = 0.05;
  parameters.declared_sigma = 0.02;
  const std::vector<Heading> all = read(parameters, 3.0);
  ASSERT_EQ(all.size(), 500U);
  EXPECT_NEAR(all[10].stamp, 0.22, 1e-9);
  EXPECT_NEAR(all[10].variance, 4e-4, 1e-12);
  double mean = 0.0, squares = 0.0;
  for (const Heading& heading : all) mean += angle_difference(heading.yaw, 3.3) / 500.0;
  for (const Heading& heading : all) squares += std::pow(angle_difference(heading.yaw, 3.3), 2) / 500.0;
  EXPECT_NEAR(mean, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares), 0.05, 0.01);
}

TEST(Compass, IsAnyAsOftenAsItIsAnOutlier) {
  CompassParameters parameters = at_50_hz();
  parameters.outlier_share = 0.2;
  int far = 0;
  for (const Heading& heading : read(parameters, 0.0)) far += std::abs(heading.yaw) > 0.2 ? 1 : 0;
  EXPECT_NEAR(far, 94, 30);
}

TEST(Compass, IsSpoiltByItsFaults) {
  SensorFault turned;
  turned.kind = "offset";
  turned.size = kPi;
  turned.start = 5.0;
  for (const Heading& heading : read(at_50_hz(), 0.0, {turned})) {
    EXPECT_EQ(std::abs(heading.yaw) > 1.0, heading.stamp >= 5.0) << heading.stamp;
    EXPECT_LE(std::abs(heading.yaw), kPi);
  }
}

}  // namespace
}  // namespace multipath_localization
