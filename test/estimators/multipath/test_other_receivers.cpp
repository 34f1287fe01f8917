#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "estimators/multipath/hypothesis.hpp"
#include "estimators/multipath/other_receivers.hpp"
#include "estimators/multipath/state.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization::multipath {
namespace {

const OdometryNoise kNoise = {0.005, 0.002, 0.03, 0.004, 1.5e-4, 2e-5};

ReceiverErrors some_errors(double level, bool in_shadow) {
  ReceiverErrors errors;
  errors.law.log_slow = 0.3;
  errors.level = level;
  errors.in_shadow = in_shadow;
  errors.shadow_law.size = 5.0;
  return errors;
}

GnssFix some_fix() {
  GnssFix fix;
  fix.position = {1.0, -2.0};
  fix.covariance = 0.2 * Eigen::Matrix2d::Identity();
  fix.antenna_in_base = {0.8, -0.3};
  return fix;
}

/// One that knows two other receivers, by a fix of each and some driving between.
Hypothesis some_hypothesis() {
  Hypothesis h;
  h.mean << 0.5, -1.0, 0.4, 0.01, 0.002, 0.02, 0.003, 0.001, 0.2, -0.1, 0.0, 0.0;
  h.covariance.diagonal() << 4.0, 4.0, 0.1, 1e-4, 1e-5, 1e-3, 1e-4, 1e-5, 0.5, 0.5, 0.0, 0.0;
  h.level = 0.5;
  add_receiver(h, some_errors(1.0, true));
  add_receiver(h, some_errors(2.0, false));
  OdometrySum odometry(kNoise);
  for (int i = 1; i <= 50; ++i) odometry.add({0.02 * i, 0.02, 2.0, 0.5});
  for (const std::size_t other : {0U, 1U}) {
    h.correct(some_fix(), Eigen::Matrix2d::Identity());
    h.propagate(odometry, kNoise);
    attend(h, other);
  }
  return h;
}

/// Covariance of all that a hypothesis holds.
Eigen::MatrixXd joint(const Hypothesis& h) {
  const Eigen::Index n = kStateSize + h.others.mean.size();
  Eigen::MatrixXd all(n, n);
  all << h.covariance, h.others.cross, h.others.cross.transpose(), h.others.covariance;
  return all;
}

TEST(OtherReceivers, ComeBackAsTheyWent) {
  const Hypothesis before = some_hypothesis();
  Hypothesis h = before;
  attend(h, 1);
  EXPECT_NE(h.level, before.level);
  EXPECT_NE(h.mean.tail<4>(), before.mean.tail<4>());
  EXPECT_EQ(h.mean.head<8>(), before.mean.head<8>());
  attend(h, 1);
  EXPECT_EQ(h.mean, before.mean);
  EXPECT_EQ(h.level, before.level);
  EXPECT_EQ(h.in_shadow, before.in_shadow);
  EXPECT_EQ(joint(h), joint(before));
}

TEST(OtherReceivers, AreCorrectedAsOneFilterOverAllWouldBe) {
  Hypothesis h = some_hypothesis();
  h.in_shadow = true;
  const Eigen::MatrixXd P = joint(h);
  Eigen::VectorXd x(P.rows());
  x << h.mean, h.others.mean;
  const GnssFix fix = some_fix();
  const Eigen::Vector2d lever = rotation(h.mean(kYaw)) * fix.antenna_in_base;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2, P.rows());
  H.leftCols<2>() = Eigen::Matrix2d::Identity();
  H.col(kYaw) << -lever.y(), lever.x();
  H.middleCols<2>(kSlowX) = H.middleCols<2>(kShadowX) = Eigen::Matrix2d::Identity();
  const Eigen::MatrixXd K =
      P * H.transpose() * (H * P * H.transpose() + Eigen::Matrix2d::Identity()).inverse();
  const Eigen::Vector2d innovation =
      fix.position - h.mean.head<2>() - lever - h.mean.segment<2>(kSlowX) - h.mean.segment<2>(kShadowX);
  const Eigen::VectorXd corrected = x + K * innovation;
  const Eigen::MatrixXd left = P - K * H * P;

  h.correct(fix, Eigen::Matrix2d::Identity());
  EXPECT_LT((h.mean - corrected.head<kStateSize>()).norm(), 1e-9);
  EXPECT_LT((h.others.mean - corrected.tail(h.others.mean.size())).norm(), 1e-9);
  EXPECT_LT((joint(h) - left).norm(), 1e-9);
}

TEST(OtherReceivers, KeepWhatTheyKnowOfAPoseThatMoves) {
  Hypothesis h = some_hypothesis();
  const double correlated = h.others.cross.topRows<2>().norm();
  EXPECT_GT(correlated, 0.01);
  OdometrySum odometry(kNoise);
  for (int i = 1; i <= 50; ++i) odometry.add({0.02 * i, 0.02, 2.0, 0.0});
  const Eigen::MatrixXd by_yaw = h.others.cross.row(kYaw);
  const OtherReceivers::Cross before = h.others.cross;
  h.propagate(odometry, kNoise);
  const Eigen::Vector2d ahead = rotation(h.mean(kYaw)).col(0);
  const Eigen::MatrixXd swung = h.others.cross.topRows<2>() - before.topRows<2>();
  EXPECT_NEAR((swung + 2.0 * Eigen::Vector2d(ahead.y(), -ahead.x()) * by_yaw).norm(), 0.0,
              0.2 * (2.0 * by_yaw).norm() + 1e-3);
  EXPECT_GT(joint(h).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-9);
}

TEST(OtherReceivers, AreForgottenWithoutATraceInTheOthers) {
  Hypothesis h = some_hypothesis();
  const Eigen::Vector2d bias = h.others.bias(1);
  const Eigen::Matrix2d covariance = h.others.bias_covariance(1);
  const StateCovariance own = h.covariance;
  forget_receiver(h, 0);
  ASSERT_EQ(h.others.errors.size(), 1u);
  EXPECT_EQ(h.others.bias(0), bias);
  EXPECT_EQ(h.others.bias_covariance(0), covariance);
  EXPECT_EQ(h.covariance, own);
}

/// In a shadow of (4, -3) m, beside another receiver that is off by that, as sure of both as fixes of 0.1 m
/// make one who takes the position for known.
Hypothesis in_shadow_beside(const Eigen::Vector2d& bias) {
  Hypothesis h;
  h.level = 0.1;
  h.in_shadow = true;
  h.shadow_law.size = 5.0;
  h.mean.segment<2>(kShadowX) << 4.0, -3.0;
  h.covariance.diagonal().setConstant(0.01);
  ReceiverErrors errors = some_errors(0.1, bias.norm() > 1.0);
  add_receiver(h, errors);
  h.others.mean.tail<2>() = bias;
  h.others.covariance.diagonal().setConstant(0.01);
  return h;
}

TEST(OtherReceivers, ThatAreOffByTheSameAreRatherRight) {
  EXPECT_EQ(likelier_if_moved(Hypothesis{}), 1.0) << "without another";
  EXPECT_GT(likelier_if_moved(in_shadow_beside({4.05, -2.95})), 100.0);
  EXPECT_LT(likelier_if_moved(in_shadow_beside({0.0, 0.0})), 1e-3) << "the other one says where it is";
  EXPECT_NEAR(likelier_if_moved(in_shadow_beside({-3.0, -4.0})), 1.0, 0.9) << "both are in shadows anyway";
  EXPECT_TRUE(std::isfinite(likelier_if_moved(in_shadow_beside({1e4, 1e4}))));
}

TEST(OtherReceivers, FollowAPositionThatIsMovedByTheBias) {
  for (const Eigen::Vector2d& bias : {Eigen::Vector2d(4.0, -3.0), Eigen::Vector2d(-3.0, -4.0)}) {
    Hypothesis h = in_shadow_beside(bias);
    const Eigen::Vector2d fix = h.mean.head<2>() + h.others.bias(0);
    move_by_bias(h);
    EXPECT_LT((h.mean.head<2>() + h.others.bias(0) - fix).norm(), 1e-9) << "its fixes are where they were";
    EXPECT_EQ(h.others.errors[0].in_shadow, bias.x() < 0.0);
    EXPECT_EQ(h.others.mean.tail<2>().norm() > 0.0, h.others.errors[0].in_shadow);
    EXPECT_GT(joint(h).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-9);
  }
}

TEST(OtherReceivers, AreForgottenWhereThePositionIsLost) {
  double shadows = 0.0;
  constexpr int kDraws = 2000;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    Hypothesis h = in_shadow_beside({4.0, -3.0});
    RandomStream random(1, i, 0);
    renew_receivers(h, random);
    ASSERT_EQ(h.others.errors.size(), 1u);
    EXPECT_EQ(h.others.bias(0).norm(), 0.0);
    EXPECT_EQ(h.others.errors[0].level, 0.1);
    const bool wide = h.others.bias_covariance(0)(0, 0) > 20.0;
    EXPECT_EQ(wide, h.others.errors[0].in_shadow);
    shadows += wide ? 1.0 : 0.0;
  }
  EXPECT_NEAR(shadows / kDraws, kShadowAtStart, 0.04);
}

TEST(OtherReceivers, BeginWithTheErrorsOfTheirLaw) {
  Hypothesis h;
  add_receiver(h, some_errors(2.0, true));
  const double slow = std::exp(0.3) * 2.0;
  EXPECT_NEAR(h.others.bias_covariance(0)(0, 0), slow * slow + 25.0, 1e-9);
  EXPECT_EQ(h.others.bias(0), Eigen::Vector2d::Zero());
  EXPECT_EQ(h.others.cross.norm(), 0.0);
}

}  // namespace
}  // namespace multipath_localization::multipath
