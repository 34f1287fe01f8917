#include <gtest/gtest.h>

#include <cmath>

#include "simulation/random_receiver.hpp"

namespace multipath_localization {
namespace {

/// 400 s at 1 m/s to the east.
std::vector<MotionStep> straight() {
  std::vector<MotionStep> steps(40000);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = {{static_cast<double>(i + 1) * kWayStep, 0.0, 0.0}, 1.0, 0.0};
  }
  return steps;
}

RandomReceiver white(double sigma) {
  RandomReceiver receiver;
  receiver.kind = ReceiverKind::kWhite;
  receiver.levels = {{0.0, 0.0, 1.0, sigma}};
  receiver.statuses = {FixStatus::kSingle};
  return receiver;
}

double error(const GnssFix& fix) { return (fix.position - Eigen::Vector2d(fix.stamp, 0.0)).norm(); }

TEST(RandomReceiver, AFixIsThePositionPlusWhatIsWrongWithIt) {
  const ReadFixes read = read_fixes(white(0.0), straight(), 1);
  ASSERT_EQ(read.fixes.size(), 2000u);
  for (const GnssFix& fix : read.fixes) ASSERT_NEAR(error(fix), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(read.fixes.back().stamp, 400.0);
}

TEST(RandomReceiver, HonestDeclarationsAreWhatTheErrorsComeTo) {
  RandomReceiver receiver = white(0.4);
  receiver.levels.front().slow_sigma = 0.3;
  receiver.levels.front().slow_time = 2.0;
  double squares = 0.0;
  const ReadFixes read = read_fixes(receiver, straight(), 1);
  for (const GnssFix& fix : read.fixes) squares += error(fix) * error(fix);
  EXPECT_NEAR(std::sqrt(0.5 * squares / 2000.0), 0.5, 0.05);
  EXPECT_NEAR(read.fixes.front().covariance(0, 0), 0.25, 1e-12);
  receiver.optimism = 5.0;
  EXPECT_NEAR(read_fixes(receiver, straight(), 1).fixes.front().covariance(0, 0), 0.01, 1e-12);
}

TEST(RandomReceiver, AShadowBiasesTheFixesInIt) {
  for (const ShadowLaw law :
       {ShadowLaw::kConstant, ShadowLaw::kTurning, ShadowLaw::kJumping, ShadowLaw::kWalkingIn}) {
    RandomReceiver receiver = white(0.0);
    receiver.shadows = {{Eigen::Vector2d(200.0, 0.0), 50.0, 8.0, law, 0.02, 20.0, 0.0}};
    const ReadFixes read = read_fixes(receiver, straight(), 1);
    for (std::size_t i = 0; i < read.fixes.size(); ++i) {
      const bool inside = std::abs(read.fixes[i].stamp - 200.0) < 50.0;
      ASSERT_EQ(read.truths[i].fault == FixFault::kShadow, inside) << to_string(law);
      const bool grown = law != ShadowLaw::kWalkingIn || read.fixes[i].stamp > 171.0;
      if (!inside || grown) {
        ASSERT_NEAR(error(read.fixes[i]), inside ? 8.0 : 0.0, 1e-6) << to_string(law);
      }
    }
  }
}

TEST(RandomReceiver, AnOutageHasNoFixesAndTheFirstAfterItMayBeOff) {
  RandomReceiver receiver = white(0.0);
  receiver.outages = {{{100.0, 30.0}, 10.0, 5.0}};
  for (const GnssFix& fix : read_fixes(receiver, straight(), 1).fixes) {
    ASSERT_FALSE(fix.stamp >= 100.0 && fix.stamp < 130.0);
    ASSERT_NEAR(error(fix), fix.stamp >= 130.0 && fix.stamp < 140.0 ? 5.0 : 0.0, 1e-6) << fix.stamp;
  }
}

TEST(RandomReceiver, RtkClaimsItsLevelsAndItsWrongFixesAreAsSureAsTheRightOnes) {
  RandomReceiver receiver = white(0.0);
  receiver.kind = ReceiverKind::kRtk;
  receiver.levels = {{0.0, 0.0, 1.0, 0.01}, {0.0, 0.5, 50.0, 0.01}, {2.0, 1.0, 50.0, 0.5}};
  receiver.statuses = {FixStatus::kGroundBased, FixStatus::kSatelliteBased, FixStatus::kSingle};
  receiver.fixed_stretch = 20.0;
  receiver.float_stretch = 5.0;
  receiver.wrong_fix_share = 1.0;
  const ReadFixes read = read_fixes(receiver, straight(), 1);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < read.fixes.size(); ++i) {
    const FixTruth& truth = read.truths[i];
    ASSERT_EQ(read.fixes[i].status, receiver.statuses[truth.level]);
    if (truth.fault != FixFault::kWrongFix) continue;
    ++wrong;
    ASSERT_EQ(truth.level, static_cast<std::size_t>(kFixed));
    ASSERT_NEAR(read.fixes[i].covariance(0, 0), 1e-4, 1e-12);
    ASSERT_GE(truth.bias.norm(), 0.3 - 1e-9);
    ASSERT_LE(truth.bias.norm(), 15.0 + 1e-9);
  }
  EXPECT_GT(wrong, 200u);
}

TEST(RandomReceiver, NamesItsKindsAndDeclarations) {
  EXPECT_EQ(to_string(ReceiverKind::kRtk), "rtk");
  EXPECT_EQ(to_string(Declaration::kCentimetres), "centimetres");
}

TEST(RandomReceiver, DrawsEveryKindWithUsableCovariances) {
  std::size_t kinds = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    RandomStream random(seed, 0, 1);
    const RandomReceiver receiver = draw_receiver(random, straight(), 1.0);
    kinds |= std::size_t{1} << static_cast<std::size_t>(receiver.kind);
    for (const GnssFix& fix : read_fixes(receiver, straight(), seed).fixes) {
      ASSERT_TRUE(fix.position.allFinite());
      ASSERT_GT(fix.covariance(0, 0) * fix.covariance(1, 1), std::pow(fix.covariance(0, 1), 2));
    }
  }
  EXPECT_EQ(kinds, 63u);
}

}  // namespace
}  // namespace multipath_localization
