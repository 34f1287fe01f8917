#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/motion/steering_motion.hpp"
#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"

namespace multipath_localization {
namespace {

OdometryIncrement increment(double duration, double speed, double yaw_rate) {
  return {duration, duration, speed, yaw_rate};
}

/// The reference: Eqs. (4)-(8) for one pose, in plain C++.
Pose2 plainly_steered(const Pose2& pose, const OdometryIncrement& u,
                      const SteeringNoiseParameters& parameters, const Normals& normals, std::size_t i) {
  if (std::abs(u.speed) < kStandstillSpeed) return pose * displacement(u);
  const double angle = std::atan(parameters.wheelbase * u.yaw_rate / u.speed);
  const auto sigma = [&](double speed_weight, double angle_weight) {
    return std::sqrt(parameters.noise_scale *
                     (speed_weight * u.speed * u.speed + angle_weight * angle * angle));
  };
  const double scale = std::sqrt(parameters.noise_period / u.duration);
  const double v = u.speed + sigma(parameters.alpha1, parameters.alpha2) * normals.first()[i];
  const double limit = parameters.max_steering_angle;
  const double phi =
      std::clamp(angle + sigma(parameters.alpha3, parameters.alpha4) * normals.second()[i], -limit, limit);
  OdometryIncrement drawn = u;
  drawn.speed += scale * (v - u.speed);
  drawn.yaw_rate += scale * (v * std::tan(phi) - u.speed * std::tan(angle)) / parameters.wheelbase;
  Pose2 end = pose * displacement(drawn);
  end.yaw += scale * sigma(parameters.alpha5, parameters.alpha6) * normals.third()[i] * u.duration;
  return end;
}

/// Moves whole blocks of poses by the noise of a step.
void move(const OdometryIncrement& u, const SteeringNoiseParameters& parameters, std::uint32_t step,
          std::vector<Pose2>& poses) {
  const SteeringMotion motion(u, parameters);
  for (std::size_t first = 0; first < poses.size(); first += kBlockSize) {
    BlockValues x;
    BlockValues y;
    BlockValues yaw;
    RandomWords words;
    Normals normals;
    random_words(best_instruction_set(), 2, step, static_cast<std::uint32_t>(first), words);
    standard_normals(best_instruction_set(), words, normals);
    for (std::size_t i = 0; i < kBlockSize; ++i) {
      x[i] = poses[first + i].x;
      y[i] = poses[first + i].y;
      yaw[i] = poses[first + i].yaw;
    }
    motion.move(best_instruction_set(), {x.data(), y.data(), yaw.data(), kBlockSize}, normals);
    for (std::size_t i = 0; i < kBlockSize; ++i) poses[first + i] = {x[i], y[i], yaw[i]};
  }
}

Pose2 moved(const OdometryIncrement& u, const SteeringNoiseParameters& parameters, const Pose2& start) {
  std::vector<Pose2> poses(kBlockSize, start);
  move(u, parameters, 0, poses);
  return poses[0];
}

TEST(SteeringMotion, SteeringAngleGivesTheYawRateBack) {
  for (const double speed : {-3.0, 0.5, 10.0}) {
    for (const double yaw_rate : {-0.7, 0.0, 0.2}) {
      const double phi = steering_angle(increment(0.02, speed, yaw_rate), 1.3);
      EXPECT_NEAR(speed / 1.3 * std::tan(phi), yaw_rate, 1e-9);
    }
  }
  EXPECT_EQ(steering_angle(increment(0.02, 0.0, 0.3), 1.3), 0.0);
}

/// Eq. (3) as printed, with its division by omega.
Pose2 printed_arc(const Pose2& pose, const OdometryIncrement& u) {
  const double radius = u.speed / u.yaw_rate;
  const double turned = pose.yaw + u.yaw_rate * u.duration;
  return {pose.x + radius * (std::sin(turned) - std::sin(pose.yaw)),
          pose.y - radius * (std::cos(turned) - std::cos(pose.yaw)), turned};
}

TEST(SteeringMotion, WithoutNoiseFollowsTheArcOfEquation3) {
  SteeringNoiseParameters parameters;
  parameters.noise_scale = 0.0;
  const Pose2 start{1.0, -2.0, 0.4};
  for (const double yaw_rate : {-1.0, -0.01, 0.3, 2.0}) {
    const OdometryIncrement u = increment(0.5, 3.0, yaw_rate);
    const Pose2 end = moved(u, parameters, start);
    const Pose2 expected = printed_arc(start, u);
    EXPECT_NEAR(end.x, expected.x, 1e-9);
    EXPECT_NEAR(end.y, expected.y, 1e-9);
    EXPECT_NEAR(angle_difference(end.yaw, expected.yaw), 0.0, 1e-9);
  }
}

TEST(SteeringMotion, HasNoSingularityStraightAhead) {
  SteeringNoiseParameters parameters;
  parameters.noise_scale = 0.0;
  const Pose2 straight = moved(increment(0.5, 3.0, 0.0), parameters, {});
  const Pose2 nearly = moved(increment(0.5, 3.0, 1e-9), parameters, {});
  EXPECT_NEAR(straight.x, 1.5, 2e-9);
  EXPECT_EQ(straight.y, 0.0);
  EXPECT_NEAR(nearly.x, straight.x, 1e-9);
  EXPECT_NEAR(nearly.y, straight.y, 1e-9);
}

struct Spread {
  double mean_x = 0.0;
  double variance_x = 0.0;
  double variance_yaw = 0.0;
};

Spread spread_of_one_second(std::uint32_t steps, double speed, const SteeringNoiseParameters& parameters) {
  constexpr std::size_t kSamples = 16 * kBlockSize;
  std::vector<Pose2> poses(kSamples);
  for (std::uint32_t k = 0; k < steps; ++k) move(increment(1.0 / steps, speed, 0.0), parameters, k, poses);
  Spread spread;
  double sum_of_squares = 0.0;
  for (const Pose2& pose : poses) {
    spread.mean_x += pose.x / kSamples;
    sum_of_squares += pose.x * pose.x / kSamples;
    spread.variance_yaw += pose.yaw * pose.yaw / kSamples;
  }
  spread.variance_x = sum_of_squares - spread.mean_x * spread.mean_x;
  return spread;
}

TEST(SteeringMotion, SpeedNoiseIsThatOfEquation5) {
  SteeringNoiseParameters parameters;
  parameters.alpha3 = parameters.alpha4 = parameters.alpha5 = parameters.alpha6 = 0.0;
  parameters.noise_scale = 1.0;
  parameters.noise_period = 1.0;
  const Spread spread = spread_of_one_second(1, 2.0, parameters);
  EXPECT_NEAR(spread.mean_x, 2.0, 0.2);
  EXPECT_NEAR(spread.variance_x, 3.0 * 4.0, 12.0 * 4.0 * std::sqrt(2.0 / 4000.0));
}

TEST(SteeringMotion, YawNoiseIsThatOfEquations6And7) {
  SteeringNoiseParameters parameters;
  parameters.alpha1 = parameters.alpha2 = 0.0;
  parameters.noise_scale = 1e-4;
  parameters.noise_period = 1.0;
  const double expected = 1e-4 * 3.0 * 4.0 * (1.0 + 4.0);  // steering through v / l, and gamma itself
  EXPECT_NEAR(spread_of_one_second(1, 2.0, parameters).variance_yaw, expected, 0.1 * expected);
}

TEST(SteeringMotion, NoiseOfASecondDoesNotDependOnTheOdometryRate) {
  const SteeringNoiseParameters parameters;
  const Spread slow = spread_of_one_second(5, 2.0, parameters);
  const Spread fast = spread_of_one_second(50, 2.0, parameters);
  EXPECT_NEAR(slow.variance_yaw / fast.variance_yaw, 1.0, 0.15);
  EXPECT_NEAR(slow.variance_x / fast.variance_x, 1.0, 0.15);
}

TEST(SteeringMotion, StandingStillDiffusesNothing) {
  const Pose2 start{1.0, 2.0, 0.5};
  const Pose2 end = moved(increment(0.02, 0.0, 0.0), {}, start);
  EXPECT_EQ(end.x, start.x);
  EXPECT_EQ(end.y, start.y);
  EXPECT_EQ(end.yaw, start.yaw);
}

TEST(SteeringMotion, TurnsOnTheSpot) {
  const Pose2 turned = moved(increment(0.5, 0.0, 0.8), {}, {});
  EXPECT_NEAR(turned.yaw, 0.4, 1e-12);
  EXPECT_EQ(turned.x, 0.0);
}

TEST(SteeringMotion, PrintedNoiseStaysFinite) {
  SteeringNoiseParameters parameters;
  parameters.noise_scale = 1.0;
  parameters.max_steering_angle = 1.57;
  std::vector<Pose2> poses(kBlockSize);
  for (std::uint32_t k = 0; k < 1000; ++k) {
    move(increment(0.01, 10.0, 1.0), parameters, k, poses);
    for (const Pose2& pose : poses) {
      ASSERT_TRUE(pose.finite());
      ASSERT_LE(std::abs(pose.yaw), kPi);
    }
  }
}

TEST(SteeringMotion, IsThePlainReferenceOnEachInstructionSet) {
  Normals normals;
  RandomWords words;
  for (const auto& [speed, yaw_rate] : {std::pair(2.0, 0.4), std::pair(-3.0, 0.0), std::pair(0.0, 1.5)}) {
    const OdometryIncrement u = increment(0.1, speed, yaw_rate);
    for (const InstructionSet set : {InstructionSet::kPlain, best_instruction_set()}) {
      random_words(set, 5, 1, 0, words);
      standard_normals(set, words, normals);
      BlockValues x;
      BlockValues y;
      BlockValues yaw;
      for (std::size_t i = 0; i < kBlockSize; ++i) {
        x[i] = 3.0 * static_cast<double>(i) - 300.0;
        y[i] = -2.0 * x[i];
        yaw[i] = 0.02 * x[i] / 2.0;
      }
      SteeringMotion(u, {}).move(set, {x.data(), y.data(), yaw.data(), 200}, normals);
      for (std::size_t i = 0; i < kBlockSize; ++i) {
        const double x0 = 3.0 * static_cast<double>(i) - 300.0;
        const Pose2 start{x0, -2.0 * x0, 0.02 * x0 / 2.0};
        const Pose2 end = i < 200 ? plainly_steered(start, u, {}, normals, i) : start;
        EXPECT_NEAR(x[i], end.x, 1e-9);
        EXPECT_NEAR(y[i], end.y, 1e-9);
        EXPECT_NEAR(angle_difference(yaw[i], end.yaw), 0.0, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace multipath_localization
