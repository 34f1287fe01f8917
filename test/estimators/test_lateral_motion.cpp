#include <gtest/gtest.h>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

/// Those that are moved by odometry and corrected by the fixes of one antenna.
class EstimatorOfFixes : public ::testing::TestWithParam<std::string> {};

TEST_P(EstimatorOfFixes, FollowsARobotThatMovesSideways) {
  SimulatedDrive drive(1);
  Localizer localizer(make_estimator(GetParam(), {}, 1), {});
  localizer.start(std::nullopt);
  drive.run(localizer, 60.0);
  drive.speed = 0.0;
  drive.lateral_speed = -0.8;
  drive.run(localizer, 20.0);
  drive.speed = 1.0;
  RootMeanSquare error;
  drive.run(localizer, 20.0, [&] { error.add(position_error(localizer.estimate(), drive.truth)); });
  EXPECT_TRUE(localizer.estimate().aligned);
  EXPECT_LT(error.value(), 0.5);
}

TEST_P(EstimatorOfFixes, GoesOnSidewaysWithoutFixes) {
  SimulatedDrive drive(2);
  Localizer localizer(make_estimator(GetParam(), {}, 1), {});
  localizer.start(std::nullopt);
  drive.run(localizer, 60.0);
  const Eigen::Vector2d before = position_error(localizer.estimate(), drive.truth);
  drive.receiving = false;
  drive.speed = 0.0;
  drive.lateral_speed = 1.0;
  drive.bend = 0.0;
  drive.run(localizer, 20.0);
  const PoseEstimate estimate = localizer.estimate();
  EXPECT_LT((position_error(estimate, drive.truth) - before).norm(), 4.0) << "of 20 m";
  EXPECT_LT(nees(estimate, drive.truth), 20.0);
}

INSTANTIATE_TEST_SUITE_P(ByName, EstimatorOfFixes,
                         ::testing::Values("multipath_particle_filter", "gated_ekf", "two_stage_ekf",
                                           "nishida_particle_filter", "conventional_particle_filter"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace multipath_localization
