#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/core/tilt.hpp"
#include "multipath_localization/localization/gravity_filter.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.01;  ///< [s]

InertialSample sample_of(double stamp, const Eigen::Vector3d& acceleration) {
  InertialSample sample;
  sample.stamp = stamp;
  sample.acceleration = acceleration;
  return sample;
}

Eigen::Vector3d gravity(const Tilt& tilt) { return 9.81 * up_in_base(tilt); }

TEST(GravityFilter, FindsTheSlopeOfARobotAtRestAfterASecond) {
  GravityFilter filter;
  for (int i = 0; i < 50; ++i) filter.add(sample_of(kStep * i, gravity({0.1, -0.2})));
  EXPECT_FALSE(filter.up());
  for (int i = 50; i < 150; ++i) filter.add(sample_of(kStep * i, gravity({0.1, -0.2})));
  ASSERT_TRUE(filter.up());
  EXPECT_NEAR(tilt_of(*filter.up()).roll, 0.1, 1e-9);
  EXPECT_NEAR(tilt_of(*filter.up()).pitch, -0.2, 1e-9);
}

TEST(GravityFilter, TakesPullingAwayAndCurvesOutByTheOdometry) {
  GravityFilter filter;
  double largest = 0.0;
  for (int i = 0; i < 600; ++i) {
    const double stamp = kStep * i;
    const double speed = std::min(2.0 * std::max(stamp - 2.0, 0.0), 3.0);  // 2 m/s^2 for 1.5 s
    const bool pulls = stamp > 2.0 && stamp <= 3.5;
    filter.drive({stamp, kStep, speed, 0.3});
    filter.add(sample_of(stamp, gravity({}) + Eigen::Vector3d(pulls ? 2.0 : 0.0, 0.3 * speed, 0.0)));
    if (!filter.up()) continue;
    const Tilt tilt = tilt_of(*filter.up());
    largest = std::max({largest, std::abs(tilt.roll), std::abs(tilt.pitch)});
  }
  EXPECT_LT(largest, 0.01);
}

TEST(GravityFilter, FollowsTheGyroWhereASlopeBegins) {
  GravityFilter filter;
  double pitch = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double rate = i >= 300 && i < 350 ? -0.5 : 0.0;
    pitch += kStep * rate;
    InertialSample sample = sample_of(kStep * i, gravity({0.0, pitch}));
    sample.rate = Eigen::Vector3d(0.0, rate, 0.0);
    filter.add(sample);
    if (i == 355) {
      EXPECT_NEAR(tilt_of(*filter.up()).pitch, -0.25, 0.005);
    }
  }
}

TEST(GravityFilter, DoesNotTakeAccelerationsWithoutGravityForIt) {
  GravityFilter filter;
  for (int i = 0; i < 500; ++i) filter.add(sample_of(kStep * i, {0.3, 0.0, 0.1}));
  EXPECT_FALSE(filter.up());
}

}  // namespace
}  // namespace multipath_localization
