#include "estimators/multipath/summed_noise.hpp"

#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kAcrossToAlong = 0.5;      ///< wheels slip sideways less than they slip along [1]
constexpr double kTurnNoiseOfTurn = 0.004;  ///< wheels scrub in turns; a gyro's scale [rad/sqrt(rad)]
constexpr double kGyroNoise = 0.001;        ///< of a cheap one on a robot that shakes [rad/sqrt(s)]
/// Standard deviation of a value that is anywhere within an interval of length 1: 1 / sqrt(12).
constexpr double kUniform = 0.2887;
/// Turns that nobody measures: 0.15 rad/s as cars and robots do, for three seconds each [rad/sqrt(s)].
constexpr double kUntoldTurn = 0.4;

Eigen::Vector2d perpendicular(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

void SummedNoise::add(const SummedStep& step) {
  carry(step.way);
  add_way(step.way);
  add_turn(step);
  add_sampling(step);
}

void SummedNoise::add_gap(double radius) {
  sampling_.topLeftCorner<2, 2>() += square(0.5 * radius) * Eigen::Matrix2d::Identity();
}

void SummedNoise::carry(const Eigen::Vector2d& way) {
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F.topRightCorner<2, 1>() = perpendicular(way);
  for (Eigen::Matrix3d* noise : {&way_, &turn_, &gyro_, &sampling_, &untold_turns_}) {
    *noise = F * *noise * F.transpose();
  }
}

void SummedNoise::add_way(const Eigen::Vector2d& way) {
  const double length = way.norm();
  const double across = square(kAcrossToAlong * supposed_.distance) * length;
  way_.topLeftCorner<2, 2>() += across * Eigen::Matrix2d::Identity();
  if (length <= 0.0) return;
  const Eigen::Vector2d along = way / length;
  way_.topLeftCorner<2, 2>() += (square(supposed_.distance) * length - across) * along * along.transpose();
}

void SummedNoise::add_turn(const SummedStep& step) {
  const double of_turn = square(kTurnNoiseOfTurn) * std::abs(step.turn);
  if (step.turn_source == TurnSource::kGyro) {
    gyro_(2, 2) += square(kGyroNoise) * step.moved + of_turn;
  } else {
    turn_(2, 2) += square(supposed_.yaw) * step.moved + of_turn;
  }
  if (!step.told_of_turns) untold_turns_(2, 2) += square(kUntoldTurn) * step.moved;
}

/// What happened between two samples is not known: speed and turn changed anywhere within the interval.
void SummedNoise::add_sampling(const SummedStep& step) {
  const double bend = step.way.norm() * std::abs(step.turn);
  const Eigen::Vector2d ahead(std::cos(step.heading), std::sin(step.heading));
  sampling_.topLeftCorner<2, 2>() +=
      square(kUniform * step.unseen_way) * ahead * ahead.transpose() +
      square(kUniform * bend) * perpendicular(ahead) * perpendicular(ahead).transpose();
}

}  // namespace multipath_localization::multipath
