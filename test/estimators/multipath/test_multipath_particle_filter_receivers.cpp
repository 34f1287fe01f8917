#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "default_localizer.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

constexpr int kSeeds = 4;
const Eigen::Vector2d kBeside(0.0, -0.8);  ///< antenna of the second receiver [m]

/// A second receiver, whose fixes are off by that [m] at a time [s]; it is silent where it gives none.
using Bias = std::function<std::optional<Eigen::Vector2d>(double)>;

std::optional<Eigen::Vector2d> good(double) { return Eigen::Vector2d(0.0, 0.0); }
std::optional<Eigen::Vector2d> absent(double) { return std::nullopt; }
/// In shadows of half a minute that it does not declare.
std::optional<Eigen::Vector2d> shadowed(double time) {
  const bool in_shadow = std::fmod(time, 60.0) > 30.0;
  return in_shadow ? Eigen::Vector2d(6.0, -4.0) : Eigen::Vector2d(0.0, 0.0);
}

void add_fix(Localizer& localizer, const SimulatedDrive& drive, std::uint64_t seed, double stamp,
             const Bias& bias, double sigma, FixStatus status) {
  const auto step = static_cast<std::uint32_t>(std::lround(20.0 * stamp));
  const std::optional<Eigen::Vector2d> off = bias(stamp);
  if (step % 4 != 2 || !off) return;
  RandomStream random(seed, step, 77);
  GnssFix fix;
  fix.stamp = stamp;
  fix.receiver = 1;
  fix.antenna_in_base = kBeside;
  fix.position = drive.truth * kBeside + *off + sigma * normals<2>(random);
  fix.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
  fix.status = status;
  localizer.add(Measurement(fix));
}

/// Lets the drive hear the second receiver, whose fixes are that good [m], beside the first one.
void add_second(Localizer& localizer, SimulatedDrive& drive, std::uint64_t seed, const Bias& bias,
                double sigma, FixStatus status = FixStatus::kSingle) {
  drive.spoilt = [&localizer, &drive, seed, bias, sigma, status](const OdometryIncrement& u) {
    add_fix(localizer, drive, seed, u.stamp, bias, sigma, status);
    return u;
  };
}

/// RMSE from 60 s on over two minutes [m], with the estimate at the end of each drive.
double rmse(
    const Bias& second, double fix_sigma,
    const std::function<void(const PoseEstimate&)>& at_end = [](const PoseEstimate&) {}) {
  RootMeanSquare error;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Localizer localizer = default_localizer(seed);
    SimulatedDrive drive(seed);
    drive.fix_sigma = fix_sigma;
    add_second(localizer, drive, seed, second, fix_sigma);
    drive.run(localizer, 120.0, [&] {
      if (drive.time > 60.0) error.add(position_error(localizer.estimate(), drive.truth));
    });
    at_end(localizer.estimate());
  }
  return error.value();
}

TEST(MultipathParticleFilterReceivers, OneInAShadowThatItDoesNotDeclareDoesNoHarm) {
  const auto knows = [](const PoseEstimate& estimate) {
    ASSERT_EQ(estimate.receivers.size(), 2u);
    EXPECT_LT(estimate.receivers[0].shadow_probability, 0.2);
    EXPECT_GT(estimate.receivers[1].shadow_probability, 0.8);
    EXPECT_LT((estimate.receivers[1].bias - Eigen::Vector2d(6.0, -4.0)).norm(), 1.0);
    EXPECT_LT(estimate.shadow_probability, 0.2) << "the other one is under open sky";
  };
  EXPECT_LT(rmse(shadowed, 0.3, knows), 1.1 * rmse(absent, 0.3));
}

TEST(MultipathParticleFilterReceivers, TwoGoodOnesAreNoWorseThanOne) {
  EXPECT_LT(rmse(good, 0.3), rmse(absent, 0.3));
  EXPECT_LT(rmse(good, 0.02), 1.02 * rmse(absent, 0.02));
}

TEST(MultipathParticleFilterReceivers, TwoThatAgreeAreBelievedWhateverWasBelievedBefore) {
  const Bias wrong_until_60 = [](double time) {
    return time < 60.0 ? Eigen::Vector2d(-2.5, 0.8) : Eigen::Vector2d(0.0, 0.0);
  };
  EXPECT_LT(rmse(wrong_until_60, 0.02), 0.5);
}

TEST(MultipathParticleFilterReceivers, CorrectionsOfOneThatTellsLittleMakeThePositionNoSurer) {
  Localizer localizer = default_localizer(1);
  SimulatedDrive drive(1);
  const auto corrected = [&](double sigma) {
    add_second(localizer, drive, 1, good, sigma, FixStatus::kGroundBased);
    drive.run(localizer, 60.0);
    return std::sqrt(localizer.estimate().covariance(0, 0));
  };
  EXPECT_GT(corrected(5.0), 1.5) << "metres beside the other one's decimetres";
  EXPECT_LT(corrected(0.02), 0.5) << "centimetres";
}

TEST(MultipathParticleFilterReceivers, TwoRtkAntennasTellTheHeadingWithinThreeMetres) {
  RootMeanSquare heading;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Localizer localizer = default_localizer(seed);
    SimulatedDrive drive(seed);
    drive.fix_sigma = 0.02;
    add_second(localizer, drive, seed, good, drive.fix_sigma);
    drive.speed = 0.0;
    drive.run(localizer, 20.0);
    EXPECT_GT(localizer.estimate().covariance(2, 2), 1.0) << "standing tells whatever a reflection says";
    drive.speed = 1.0;
    drive.run(localizer, 3.0);
    EXPECT_LT(localizer.estimate().covariance(2, 2), 0.1 * 0.1);
    heading.add({wrap_angle(localizer.estimate().pose.yaw - drive.truth.yaw), 0.0});
  }
  EXPECT_LT(heading.value(), 0.05);
}

TEST(MultipathParticleFilterReceivers, LosingOneCostsNoMoreThanItGave) {
  const Bias until_70 = [](double time) { return time < 70.0 ? good(time) : absent(time); };
  const auto forgot = [](const PoseEstimate& estimate) { EXPECT_TRUE(estimate.receivers.empty()); };
  EXPECT_LT(rmse(until_70, 0.3, forgot), 1.3 * rmse(absent, 0.3)) << "give or take other draws";
}

TEST(MultipathParticleFilterReceivers, AreToldApartInTheirReasons) {
  Localizer localizer = default_localizer(1);
  localizer.add(OdometryIncrement{0.1, 0.1, 1.0, 0.0});
  GnssFix fix;
  fix.stamp = 0.1;
  localizer.add(Measurement(fix));
  fix.receiver = 1;
  localizer.add(Measurement(fix));
  localizer.add(Measurement(fix));
  const std::vector<MeasurementReport> reports = localizer.take_reports();
  ASSERT_EQ(reports.size(), 3u);
  EXPECT_EQ(reports[1].innovation.reason, Reason::kAccepted) << "the same place as of the other one";
  EXPECT_EQ(reports[2].innovation.reason, Reason::kRepeated);
}

}  // namespace
}  // namespace multipath_localization
