#include <gtest/gtest.h>

#include "ros/map/datum_parameter.hpp"

namespace multipath_localization {
namespace {

/// Why a datum is refused, "" where it is not.
std::string refusal_of(const std::string& datum) {
  DatumParameter parameter;
  try {
    load(YAML::Load("{datum: " + datum + "}"), parameter);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

Geodetic place_of(const std::string& datum) {
  DatumParameter parameter;
  load(YAML::Load("{datum: " + datum + "}"), parameter);
  return parameter.place(7.0).value();
}

TEST(DatumParameter, IsAsThatOfRobotLocalization) {
  const Geodetic place = place_of("[55.944904, -3.186693, 0.0]");
  EXPECT_EQ(place.latitude_deg, 55.944904);
  EXPECT_EQ(place.longitude_deg, -3.186693);
  EXPECT_EQ(place.altitude, 7.0);
}

TEST(DatumParameter, MayHaveAnAltitudeOrNoYaw) {
  EXPECT_EQ(place_of("[52.5, 13.4, 0, 40]").altitude, 40.0);
  EXPECT_EQ(place_of("[52.5, 13.4]").altitude, 7.0);
  EXPECT_FALSE(DatumParameter{}.place());
}

TEST(DatumParameter, IsRefusedWhereItIsNoPlace) {
  EXPECT_EQ(refusal_of("[]"), "");
  EXPECT_NE(refusal_of("[52.5]"), "");
  EXPECT_NE(refusal_of("[139.7, 35.6]"), "") << "longitude first";
  EXPECT_NE(refusal_of("[52.5, 13.4, 0, 40, 1]"), "");
  EXPECT_NE(refusal_of("[52.5, .nan]"), "");
}

TEST(DatumParameter, IsRefusedWhereItTurnsTheMap) {
  EXPECT_NE(refusal_of("[52.5, 13.4, 1.57]").find("turned by 1.57"), std::string::npos);
  EXPECT_NE(refusal_of("[52.5, 13.4, 40.0]").find("altitude comes fourth"), std::string::npos);
  EXPECT_NE(refusal_of("[52.5, 13.4, .nan]"), "");
}

}  // namespace
}  // namespace multipath_localization
