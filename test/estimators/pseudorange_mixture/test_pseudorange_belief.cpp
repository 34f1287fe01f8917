#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "estimators/pseudorange_mixture/pseudorange_belief.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

using State = PseudorangeBelief;

const OdometryNoise kOdometry;
const ReceiverStateNoise kNoise;
const MotionLaw kNoSlip{0.0, 1.0, 0.0, false};

/// Some belief with two satellites and an offset, and everything correlated.
PseudorangeBelief random_belief(std::uint64_t seed) {
  PseudorangeBelief belief;
  for (int i = 0; i < 3; ++i) belief.append(1.0);
  RandomStream random(seed, 0, 0);
  const Eigen::Index n = belief.mean.size();
  const auto normal = [&random] { return random.normal(); };
  const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(n, n, normal);
  belief.mean = Eigen::VectorXd::NullaryExpr(n, normal);
  belief.covariance = A * A.transpose() + Eigen::MatrixXd::Identity(n, n);
  return belief;
}

SatelliteSlots three_slots() {
  SatelliteSlots slots;
  slots.admit(
      {{Constellation::kGps, 1}, {Constellation::kGlonass, std::nullopt}, {Constellation::kGlonass, 1}}, 0.0);
  return slots;
}

SparseRow random_row(RandomStream& random) {
  SparseRow H;
  for (const int state : {int(kX), int(kY), int(State::kUp), int(State::kClock), State::state_of(1)}) {
    H.set(state, random.normal());
  }
  return H;
}

TEST(PseudorangeBelief, UpdatesOneByOneEqualTheBatch) {
  PseudorangeBelief belief = random_belief(1);
  const Eigen::VectorXd x = belief.mean;
  const Eigen::MatrixXd P = belief.covariance;
  const int m = 4;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(m, x.size());
  Eigen::VectorXd z(m);
  RandomStream random(2, 0, 0);
  for (int k = 0; k < m; ++k) {
    const SparseRow row = random_row(random);
    for (int i = 0; i < row.size(); ++i) H(k, row.state(i)) = row.value(i);
    z(k) = random.normal();
    const State::Vector PHt = belief.covariance_with(row);
    belief.correct(PHt, row.dot(PHt) + 0.5, z(k) - row.dot(belief.mean));
  }
  const Eigen::MatrixXd S = H * P * H.transpose() + 0.5 * Eigen::MatrixXd::Identity(m, m);
  const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
  EXPECT_LT((belief.mean - (x + K * (z - H * x))).norm(), 1e-9);
  EXPECT_LT((belief.covariance - (P - K * H * P)).norm(), 1e-9);
}

TEST(PseudorangeBelief, PlanarPartMovesAsItDoesAlone) {
  PseudorangeBelief belief = random_belief(3);
  Belief planar = belief.planar();
  PreintegratedOdometry odometry(kOdometry);
  odometry.restart(0.01, 0.002);
  for (int i = 1; i <= 20; ++i) odometry.add({0.1 * i, 0.1, 5.0, 0.3});
  ReceiverStateNoise noise;
  noise.position_walk = 0.0;
  belief.mean.segment<2>(State::kVelocityEast).setZero();
  for (const int v : {int(State::kVelocityEast), int(State::kVelocityNorth)}) {
    belief.covariance.row(v).setZero();
    belief.covariance.col(v).setZero();
  }
  belief.propagate(odometry, kNoSlip, kOdometry, noise, three_slots());
  planar.propagate(odometry, kOdometry);
  EXPECT_LT((belief.planar().mean - planar.mean).norm(), 1e-12);
  EXPECT_LT((belief.planar().covariance - planar.covariance).norm(), 1e-9);
}

TEST(PseudorangeBelief, ClockMovesByItsDriftAndBiasesDecay) {
  PseudorangeBelief belief = random_belief(4);
  const State::Vector x = belief.mean;
  const State::Matrix P = belief.covariance;
  PreintegratedOdometry odometry(kOdometry);
  odometry.add({2.0, 2.0, 0.0, 0.0});
  belief.propagate(odometry, kNoSlip, kOdometry, kNoise, three_slots());
  EXPECT_NEAR(belief.mean(State::kClock), x(State::kClock) + 2.0 * x(State::kDrift), 1e-12);
  EXPECT_NEAR(belief.covariance(State::kClock, State::kClock),
              P(State::kClock, State::kClock) + 4.0 * P(State::kClock, State::kDrift) +
                  4.0 * P(State::kDrift, State::kDrift) + 2.0 * kNoise.clock_walk * kNoise.clock_walk,
              1e-9);
  const double kept = std::exp(-2.0 / kNoise.bias_time);
  EXPECT_NEAR(belief.mean(State::state_of(0)), kept * x(State::state_of(0)), 1e-12);
  EXPECT_NEAR(belief.mean(State::state_of(1)), x(State::state_of(1)), 1e-12);
  EXPECT_NEAR(belief.covariance(kX, State::state_of(2)), kept * P(kX, State::state_of(2)), 1e-12);
}

/// Var[x(t)] of an Ornstein-Uhlenbeck velocity summed up in small steps.
double summed_variance(const MotionLaw& law, double duration) {
  const double dt = 1e-3;
  Eigen::Matrix2d F;
  F << 1.0, dt, 0.0, 1.0 - dt / law.velocity_time;
  Eigen::Matrix2d P = Eigen::Matrix2d::Zero();
  for (double t = 0.0; t < duration; t += dt) {
    P = (F * P * F.transpose()).eval();
    P(1, 1) += 2.0 * law.velocity_sigma * law.velocity_sigma / law.velocity_time * dt;
  }
  return P(0, 0);
}

TEST(PseudorangeBelief, UnseenVelocityMovesThePositionAndDecays) {
  const MotionLaw law{0.75, 2.0, 0.1, true};
  PseudorangeBelief belief;
  belief.mean(State::kVelocityEast) = 1.0;
  PreintegratedOdometry odometry(kOdometry);
  odometry.add({3.0, 3.0, 0.0, 0.0});
  belief.propagate(odometry, law, kOdometry, kNoise, SatelliteSlots());
  EXPECT_NEAR(belief.mean(State::kVelocityEast), std::exp(-1.5), 1e-12);
  EXPECT_NEAR(belief.mean(kX), 2.0 * (1.0 - std::exp(-1.5)), 1e-12);
  EXPECT_EQ(belief.mean(kY), 0.0);
  EXPECT_NEAR(belief.covariance(kY, kY) / summed_variance(law, 3.0), 1.0, 0.01);
  EXPECT_NEAR(belief.covariance(kYaw, kYaw), 0.03, 1e-12);
}

TEST(PseudorangeBelief, AtRestNothingSlipsButWhereTheOdometryMayBeDead) {
  PreintegratedOdometry odometry(kOdometry);
  odometry.add({3.0, 3.0, 0.0, 0.0});
  for (const bool always : {false, true}) {
    PseudorangeBelief belief;
    belief.propagate(odometry, {0.75, 2.0, 0.1, always}, kOdometry, kNoise, SatelliteSlots());
    EXPECT_EQ(belief.covariance(kX, kX) > 0.0, always);
  }
}

TEST(PseudorangeBelief, SlotsComeAndGoWithoutTouchingTheOthers) {
  PseudorangeBelief belief = random_belief(5);
  const State::Matrix P = belief.covariance;
  belief.append(16.0);
  EXPECT_EQ(belief.covariance(State::state_of(3), State::state_of(3)), 16.0);
  EXPECT_EQ(belief.covariance(State::state_of(3), kX), 0.0);
  belief.remove(3);
  EXPECT_EQ(belief.covariance, P);
  belief.remove(0);  // the last, slot 2, is slot 0 now
  EXPECT_EQ(belief.covariance(State::state_of(0), State::state_of(0)),
            P(State::state_of(2), State::state_of(2)));
  EXPECT_EQ(belief.covariance(State::state_of(0), kYaw), P(State::state_of(2), kYaw));
  EXPECT_EQ(belief.covariance(State::state_of(0), State::state_of(1)),
            P(State::state_of(2), State::state_of(1)));
}

TEST(PseudorangeBelief, CovarianceStaysSymmetricAndPositiveForSixHours) {
  PseudorangeBelief belief = random_belief(6);
  belief.covariance *= 1e4;
  const SatelliteSlots slots = three_slots();
  RandomStream random(7, 0, 0);
  PreintegratedOdometry odometry(kOdometry);
  for (int second = 0; second < 6 * 3600; ++second) {
    odometry.restart(belief.mean(kScale), belief.mean(kGyroBias));
    odometry.add({1.0 * second, 1.0, 5.0, 0.1});
    belief.propagate(odometry, laws_of_wheels().laws[0], kOdometry, kNoise, slots);
    for (int k = 0; k < 12; ++k) {
      const SparseRow H = random_row(random);
      const State::Vector PHt = belief.covariance_with(H);
      belief.correct(PHt, H.dot(PHt) + 0.01, 0.0);
    }
  }
  EXPECT_EQ(belief.covariance, State::Matrix(belief.covariance.transpose()));
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(belief.covariance).eigenvalues().minCoeff(), 0.0);
}

}  // namespace
}  // namespace multipath_localization
