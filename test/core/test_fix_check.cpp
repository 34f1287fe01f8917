#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "multipath_localization/core/fix_check.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

GnssFix sound_fix() {
  GnssFix fix;
  fix.stamp = 1.0;
  fix.position = {10.0, -20.0};
  fix.covariance << 2.0, 0.5, 0.5, 1.0;
  fix.antenna_in_base = {0.3, 0.0};
  return fix;
}

std::optional<Reason> defect_after(const std::function<void(GnssFix&)>& spoil) {
  GnssFix fix = sound_fix();
  spoil(fix);
  return defect(fix);
}

TEST(FixCheck, SoundFixHasNoDefect) { EXPECT_EQ(defect(sound_fix()), std::nullopt); }

TEST(FixCheck, NotFiniteAnywhereThatCounts) {
  for (const double bad : {kNan, kInf, -kInf}) {
    EXPECT_EQ(defect_after([&](GnssFix& f) { f.stamp = bad; }), Reason::kNotFinite);
    EXPECT_EQ(defect_after([&](GnssFix& f) { f.position.y() = bad; }), Reason::kNotFinite);
    EXPECT_EQ(defect_after([&](GnssFix& f) { f.covariance(0, 1) = bad; }), Reason::kNotFinite);
    EXPECT_EQ(defect_after([&](GnssFix& f) { f.antenna_in_base.x() = bad; }), Reason::kNotFinite);
  }
}

TEST(FixCheck, ValuesBeyondEveryMap) {
  for (const double bad : {1e8, -1e8, 1e308}) {
    EXPECT_EQ(defect_after([&](GnssFix& f) { f.position.x() = bad; }), Reason::kInvalidPosition);
    EXPECT_EQ(defect_after([&](GnssFix& f) { f.antenna_in_base.y() = bad; }), Reason::kInvalidPosition);
    EXPECT_EQ(defect_after([&](GnssFix& f) { f.covariance(1, 1) = bad; }), Reason::kInvalidCovariance);
  }
}

TEST(FixCheck, InvalidCovariances) {
  EXPECT_EQ(defect_after([](GnssFix& f) { f.covariance(0, 0) = -1e-3; }), Reason::kInvalidCovariance);
  EXPECT_EQ(defect_after([](GnssFix& f) { f.covariance(0, 1) = 0.6; }), Reason::kInvalidCovariance);
  EXPECT_EQ(defect_after([](GnssFix& f) { f.covariance << 1.0, 2.0, 2.0, 1.0; }), Reason::kInvalidCovariance);
  EXPECT_EQ(defect_after([](GnssFix& f) { f.covariance << 0.0, 1.0, 1.0, 0.0; }), Reason::kInvalidCovariance);
}

TEST(FixCheck, RoundingZerosAndFullCorrelationAreNoDefects) {
  EXPECT_EQ(defect_after([](GnssFix& f) { f.covariance(0, 1) += 1e-9; }), std::nullopt);
  EXPECT_EQ(defect_after([](GnssFix& f) { f.covariance.setZero(); }), std::nullopt);
  EXPECT_EQ(defect_after([](GnssFix& f) { f.covariance << 0.1, 0.1, 0.1, 0.1; }), std::nullopt);
}

TEST(FixCheck, RepeatedPositionIsFrozenUntilItMoves) {
  FixCheck check;
  GnssFix fix = sound_fix();
  EXPECT_EQ(check.defect(fix), std::nullopt);
  fix.stamp += 0.2;
  EXPECT_EQ(check.defect(fix), Reason::kFrozen);
  EXPECT_EQ(check.defect(fix), Reason::kFrozen);
  fix.position.x() += 1e-6;
  EXPECT_EQ(check.defect(fix), std::nullopt);
}

TEST(FixCheck, DefectiveFixesAreNotRemembered) {
  FixCheck check;
  GnssFix defective = sound_fix();
  defective.covariance(0, 0) = -1.0;
  EXPECT_EQ(check.defect(defective), Reason::kInvalidCovariance);
  EXPECT_EQ(check.defect(sound_fix()), std::nullopt);
  check.forget();
  EXPECT_EQ(check.defect(sound_fix()), std::nullopt);
}

TEST(Usable, PriorsAreFiniteWithPositiveVariances) {
  PosePrior prior;
  EXPECT_TRUE(usable(prior));
  prior.covariance(2, 2) = 0.0;
  EXPECT_FALSE(usable(prior));
  prior.covariance(2, 2) = kNan;
  EXPECT_FALSE(usable(prior));
  prior.covariance.setIdentity();
  prior.covariance(0, 2) = 0.5;
  EXPECT_FALSE(usable(prior));
  prior.covariance(2, 0) = 0.5;
  EXPECT_TRUE(usable(prior));
  prior.covariance(0, 2) = prior.covariance(2, 0) = 1.5;  // correlated by more than one
  EXPECT_FALSE(usable(prior));
  prior.covariance.setIdentity();
  prior.covariance(1, 1) = 1.1e14;
  EXPECT_FALSE(usable(prior));
  prior.covariance(1, 1) = 0.9e14;
  EXPECT_TRUE(usable(prior));
  prior.pose.y = -1.1e7;
  EXPECT_FALSE(usable(prior));
  prior.pose.y = -0.9e7;
  EXPECT_TRUE(usable(prior));
  prior.stamp = kNan;
  EXPECT_FALSE(usable(prior));
  prior.stamp = 0.0;
  prior.pose.yaw = kInf;
  EXPECT_FALSE(usable(prior));
}

TEST(Usable, IncrementsAreFiniteAndLast) {
  EXPECT_TRUE(usable(OdometryIncrement{1.0, 0.02, 1.0, 0.1}));
  EXPECT_FALSE(usable(OdometryIncrement{1.0, 0.0, 1.0, 0.1}));
  EXPECT_FALSE(usable(OdometryIncrement{1.0, 0.02, kNan, 0.1}));
  EXPECT_FALSE(usable(OdometryIncrement{1.0, 0.02, 1.0, kInf}));
}

}  // namespace
}  // namespace multipath_localization
