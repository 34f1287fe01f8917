#include <gtest/gtest.h>

#include "estimators/nishida/fix_heading.hpp"

namespace multipath_localization {
namespace {

FixHeadingParameters parameters(FixHeadingSource mode, double distance) {
  FixHeadingParameters result;
  result.fix_heading = mode;
  result.fix_heading_distance = distance;
  return result;
}

/// Drives for `steps` of 0.1 s and asks for the heading at the true end.
std::optional<double> heading_after(const FixHeadingParameters& p, Pose2 truth, double speed, double yaw_rate,
                                    int steps) {
  FixHeading heading(p);
  heading.restart(truth.position());
  for (int i = 0; i < steps; ++i) {
    const OdometryIncrement u{0.1 * (i + 1), 0.1, speed, yaw_rate};
    heading.add(u);
    truth = truth * displacement(u);
  }
  return heading.heading(truth.position());
}

TEST(FixHeading, ChordIsExactOnACurveForwardAndInReverse) {
  for (const double speed : {2.0, -2.0}) {
    const auto heading =
        heading_after(parameters(FixHeadingSource::kChord, 1.0), {5.0, -3.0, 2.5}, speed, 0.4, 20);
    ASSERT_TRUE(heading.has_value());
    EXPECT_NEAR(angle_difference(*heading, 2.5 + 0.8), 0.0, 1e-9);
  }
}

TEST(FixHeading, PrintedFlipsInReverseAndAddsTheWholeTurn) {
  const auto ahead = heading_after(parameters(FixHeadingSource::kPrinted, 0.0), {0.0, 0.0, 0.5}, 2.0, 0.4, 5);
  EXPECT_NEAR(*ahead, 0.5 + 0.1 + 0.2, 1e-9);
  const auto reverse =
      heading_after(parameters(FixHeadingSource::kPrinted, 0.0), {0.0, 0.0, 0.5}, -2.0, 0.0, 5);
  EXPECT_NEAR(angle_difference(*reverse, 0.5 + kPi), 0.0, 1e-9);
}

TEST(FixHeading, SaysNothingWhenOffOrTooNear) {
  EXPECT_FALSE(heading_after(parameters(FixHeadingSource::kOff, 0.0), {}, 2.0, 0.0, 50).has_value());
  EXPECT_FALSE(heading_after(parameters(FixHeadingSource::kChord, 5.0), {}, 2.0, 0.0, 20).has_value());
  EXPECT_TRUE(heading_after(parameters(FixHeadingSource::kChord, 5.0), {}, 2.0, 0.0, 30).has_value());
}

}  // namespace
}  // namespace multipath_localization
