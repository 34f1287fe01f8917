#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "ros/wheel_odometry_node/wheel_odometry_parameters.hpp"

namespace multipath_localization {
namespace {

WheelOdometryParameters loaded(const std::string& yaml) {
  WheelOdometryParameters parameters;
  load(YAML::Load(yaml), parameters);
  return parameters;
}

TEST(WheelOdometryParameters, AreDescribedByTheirYaml) {
  std::stringstream text;
  text << std::ifstream(CONFIG_DIR "/wheel_odometry.yaml").rdbuf();
  EXPECT_EQ(text.str(), describe(WheelOdometryParameters()));
}

TEST(WheelOdometryParameters, OfEachKindOfBaseAreWantedWhole) {
  EXPECT_NO_THROW(loaded("{wheel_radius: 0.1, track: 0.5}").require_all());
  EXPECT_THROW(loaded("{track: 0.5}").require_all(), ParameterError);
  EXPECT_THROW(loaded("{wheel_radius: 0.1}").require_all(), ParameterError);
  EXPECT_THROW(loaded("{wheel_radius: 0.1, track: 0.5, right_wheels: ' '}").require_all(), ParameterError);
  EXPECT_NO_THROW(
      loaded("{wheel_radius: 0.1, wheelbase: 1.2, steering_joints: steer, right_wheels: ''}").require_all());
  EXPECT_THROW(loaded("{wheel_radius: 0.1, track: 1.2, steering_joints: steer}").require_all(),
               ParameterError);
  EXPECT_NO_THROW(loaded("{source: ackermann, wheelbase: 1.2}").require_all());
  EXPECT_THROW(loaded("{source: ackermann, track: 1.2}").require_all(), ParameterError);
  EXPECT_THROW(loaded("{wheel_radiuss: 0.1}"), ParameterError);
}

}  // namespace
}  // namespace multipath_localization
