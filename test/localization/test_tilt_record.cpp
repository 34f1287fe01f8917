#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "multipath_localization/localization/tilt_record.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 0.02;  ///< [s]

/// A sample that tells its tilt by orientation, and a turn about x that is never the same.
InertialSample oriented(double stamp, const Tilt& tilt) {
  InertialSample sample;
  sample.stamp = stamp;
  sample.up = up_in_base(tilt);
  sample.rate = Eigen::Vector3d(1e-3 * std::sin(50.0 * stamp), 0.0, 0.0);
  return sample;
}

/// Samples of `seconds` from `start` on.
void tell(TiltRecord& record, double start, double seconds, const Tilt& tilt) {
  for (int i = 0; i * kStep < seconds; ++i) record.add(oriented(start + i * kStep, tilt));
}

TEST(TiltRecord, IsLevelBeforeAnythingIsTold) {
  const TiltRecord record;
  EXPECT_EQ(record.at(1.0).roll, 0.0);
  EXPECT_EQ(record.at(1.0).pitch, 0.0);
  EXPECT_EQ(record.standing(1.0), TiltStanding::kAbsent);
}

TEST(TiltRecord, TellsTheTiltOfAStampThatHasPassed) {
  TiltRecord record;
  tell(record, 10.0, 1.0, {0.1, 0.0});
  tell(record, 11.0, 1.0, {0.1, -0.2});
  EXPECT_NEAR(record.at(10.5).pitch, 0.0, 1e-12);
  EXPECT_NEAR(record.at(11.5).pitch, -0.2, 1e-12);
  EXPECT_NEAR(record.at(11.5).roll, 0.1, 1e-12);
  EXPECT_EQ(record.standing(12.0), TiltStanding::kUsed);
}

TEST(TiltRecord, FadesToLevelWhereTheSensorFallsSilent) {
  TiltRecord record;
  tell(record, 10.0, 1.0, {0.0, -0.2});
  EXPECT_NEAR(record.at(11.9).pitch, -0.2, 1e-9);
  EXPECT_NEAR(record.at(13.5).pitch, -0.1, 0.01);
  EXPECT_EQ(record.at(16.0).pitch, 0.0);
  EXPECT_EQ(record.standing(13.0), TiltStanding::kSilent);
  tell(record, 16.0, 0.1, {0.0, -0.2});
  EXPECT_NEAR(record.at(16.1).pitch, -0.2, 1e-9);
  EXPECT_EQ(record.standing(16.1), TiltStanding::kUsed);
}

TEST(TiltRecord, ASensorThatSaysTheSameToTheBitIsSilent) {
  TiltRecord record;
  for (int i = 0; i < 500; ++i) {
    InertialSample frozen = oriented(1.0, {0.0, -0.2});
    frozen.stamp = 1.0 + kStep * i;
    record.add(frozen);
  }
  EXPECT_EQ(record.standing(11.0), TiltStanding::kSilent);
  EXPECT_EQ(record.at(11.0).pitch, 0.0);
}

TEST(TiltRecord, AnInclinometerMayStandStill) {
  TiltRecord record;
  for (int i = 0; i < 500; ++i) {
    InertialSample still = oriented(1.0 + kStep * i, {0.0, -0.2});
    still.rate.reset();
    record.add(still);
  }
  EXPECT_EQ(record.standing(11.0), TiltStanding::kUsed);
}

TEST(TiltRecord, DoesNotBelieveARobotUpsideDown) {
  TiltRecord record;
  tell(record, 1.0, 1.0, {3.1, 0.0});
  EXPECT_EQ(record.standing(2.0), TiltStanding::kImplausible);
  EXPECT_EQ(record.at(2.0).roll, 0.0);
  tell(record, 2.0, 1.0, {0.1, 0.0});
  EXPECT_EQ(record.standing(3.0), TiltStanding::kUsed);
}

TEST(TiltRecord, BelievesGravityRatherThanAnOrientationInNed) {
  TiltRecord record;
  for (int i = 0; i < 200; ++i) {
    InertialSample sample = oriented(kStep * i, {M_PI - 0.1, 0.0});
    sample.acceleration = 9.81 * up_in_base({0.1, 0.0});
    record.add(sample);
  }
  EXPECT_EQ(record.standing(4.0), TiltStanding::kUsed);
  EXPECT_NEAR(record.at(4.0).roll, 0.1, 0.005);
}

TEST(TiltRecord, LeavesOutWhatIsNotFinite) {
  TiltRecord record;
  tell(record, 1.0, 1.0, {0.1, 0.0});
  InertialSample broken = oriented(2.0, {0.1, 0.0});
  broken.up->x() = kNan;
  record.add(broken);
  broken = oriented(kNan, {0.1, 0.0});
  record.add(broken);
  EXPECT_NEAR(record.at(2.0).roll, 0.1, 1e-12);
  EXPECT_EQ(record.standing(2.0), TiltStanding::kUsed);
}

TEST(TiltRecord, ForgetsWhatWasBeforeTheClockWentBack) {
  TiltRecord record;
  tell(record, 100.0, 1.0, {0.1, 0.0});
  tell(record, 1.0, 0.1, {0.0, 0.2});
  EXPECT_EQ(record.at(1.1).roll, 0.0);
  EXPECT_NEAR(record.at(1.1).pitch, 0.2, 1e-12);
}

}  // namespace
}  // namespace multipath_localization
