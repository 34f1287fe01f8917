#include <gtest/gtest.h>

#include "multipath_localization/core/measurement_names.hpp"

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

}  // namespace
}  // namespace multipath_localization
