#include <gtest/gtest.h>

#include "multipath_localization/core/measurement_kinds.hpp"

namespace multipath_localization {
namespace {

std::string_view name(const Measurement& measurement) { return kMeasurementNames.at(measurement.index()); }

TEST(MeasurementNames, StandAtTheIndexOfTheirKind) {
  EXPECT_EQ(name(GnssFix{}), "fix");
  EXPECT_EQ(name(DualAntennaFix{}), "dual");
  EXPECT_EQ(name(PseudorangeEpoch{}), "epoch");
  EXPECT_EQ(name(GnssVelocity{}), "velocity");
  EXPECT_EQ(name(Heading{}), "heading");
}

TEST(MeasurementKinds, TellPlacesOrMotionAndHeading) {
  for (const std::size_t kind : {kFixKind, kDualKind, kEpochKind}) EXPECT_TRUE(tells_position(kind));
  for (const std::size_t kind : {kVelocityKind, kHeadingKind}) EXPECT_FALSE(tells_position(kind));
}

}  // namespace
}  // namespace multipath_localization
