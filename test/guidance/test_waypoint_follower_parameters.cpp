#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/guidance/waypoint_follower_parameters.hpp"

namespace multipath_localization {
namespace {

TEST(WaypointFollowerParameters, NameWhatDoesTheWorkOfAFormerKey) {
  try {
    WaypointFollowerParameters::refuse_former(YAML::Load("{multipath_speed_ratio: 0.7}"), "steering/");
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_STREQ(error.what(),
                 "steering/multipath_speed_ratio is a parameter no longer; use slow_sigma and stop_sigma");
  }
  EXPECT_THROW(WaypointFollowerParameters::refuse_former(YAML::Load("{lookahead: 2.0}")), ParameterError);
  EXPECT_NO_THROW(WaypointFollowerParameters::refuse_former(YAML::Load("{cruise_speed: 2.0}")));
  EXPECT_NO_THROW(WaypointFollowerParameters::refuse_former(YAML::Node()));
}

TEST(WaypointFollowerParameters, TellTheTightestCurvature) {
  WaypointFollowerParameters parameters;
  EXPECT_NEAR(parameters.tightest_curvature(), std::tan(0.6) / 0.5, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
