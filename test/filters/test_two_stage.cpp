#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/filters/two_stage.hpp"

namespace multipath_localization {
namespace {

constexpr int kN = 3;
constexpr int kD = 2;
constexpr int kM = 2;
constexpr int kJoint = kN + kD;

template <int Rows, int Columns>
Eigen::Matrix<double, Rows, Columns> random_matrix(RandomStream& random) {
  Eigen::Matrix<double, Rows, Columns> m;
  for (int i = 0; i < Rows; ++i) {
    for (int j = 0; j < Columns; ++j) m(i, j) = random.normal();
  }
  return m;
}

template <int N>
Eigen::Matrix<double, N, N> random_covariance(RandomStream& random, double scale) {
  const Eigen::Matrix<double, N, N> root = random_matrix<N, N>(random);
  return scale * (root * root.transpose() + 0.1 * Eigen::Matrix<double, N, N>::Identity());
}

/// One step of a linear system that differs from every other step.
struct LinearStep {
  explicit LinearStep(RandomStream& random)
      : F(0.9 * Eigen::Matrix3d::Identity() + 0.1 * random_matrix<kN, kN>(random)),
        B(random_matrix<kN, kD>(random)),
        Q(random_covariance<kN>(random, 0.05)),
        G(0.95 * Eigen::Matrix2d::Identity() + 0.05 * random_matrix<kD, kD>(random)),
        W(random_covariance<kD>(random, 0.02)),
        H(random_matrix<kM, kN>(random)),
        C(random_matrix<kM, kD>(random)),
        R(random_covariance<kM>(random, 0.5)) {}

  Eigen::Matrix<double, kN, kN> F;
  Eigen::Matrix<double, kN, kD> B;
  Eigen::Matrix<double, kN, kN> Q;
  Eigen::Matrix<double, kD, kD> G;
  Eigen::Matrix<double, kD, kD> W;
  Eigen::Matrix<double, kM, kN> H;
  Eigen::Matrix<double, kM, kD> C;
  Eigen::Matrix<double, kM, kM> R;
};

Gaussian<kJoint> joint(const TwoStage<kN, kD>& belief) {
  const Gaussian<kN> x = two_stage::corrected(belief);
  Gaussian<kJoint> result;
  result.mean << x.mean, belief.bias.mean;
  const Eigen::Matrix<double, kN, kD> cross = belief.sensitivity * belief.bias.covariance;
  result.covariance << x.covariance, cross, cross.transpose(), belief.bias.covariance;
  return result;
}

/// A system with a bias, the two-stage estimator of it and the Kalman filter of state and bias together.
class Twins {
 public:
  Twins(std::uint64_t seed, bool bias_varies) : seed_(seed), bias_varies_(bias_varies) {
    RandomStream random(seed_, 0, 0);
    belief.bias_free = {random_matrix<kN, 1>(random), random_covariance<kN>(random, 1.0)};
    belief.bias = {random_matrix<kD, 1>(random), random_covariance<kD>(random, 2.0)};
    belief.sensitivity = random_matrix<kN, kD>(random);
    augmented = joint(belief);
    truth_ = augmented.mean + random_matrix<kJoint, 1>(random);
  }

  void step() {
    RandomStream random(seed_, ++step_, 0);
    const LinearStep s(random);
    Eigen::Matrix<double, kJoint, kJoint> F = Eigen::Matrix<double, kJoint, kJoint>::Identity();
    F.topLeftCorner<kN, kN>() = s.F;
    F.topRightCorner<kN, kD>() = s.B;
    Eigen::Matrix<double, kJoint, kJoint> Q = Eigen::Matrix<double, kJoint, kJoint>::Zero();
    Q.topLeftCorner<kN, kN>() = s.Q;
    if (bias_varies_) {
      F.bottomRightCorner<kD, kD>() = s.G;
      Q.bottomRightCorner<kD, kD>() = s.W;
    }
    truth_ = F * truth_ + 0.1 * random_matrix<kJoint, 1>(random);
    Eigen::Matrix<double, kM, kJoint> H;
    H << s.H, s.C;
    const Eigen::Vector2d z = H * truth_ + 0.3 * random_matrix<kM, 1>(random);

    kalman::predict<kJoint>(augmented, F * augmented.mean, F, Q);
    expected = kalman::correct<kJoint, kM>(augmented, z - H * augmented.mean, H, s.R);

    two_stage::predict<kN, kD>(belief, s.F * belief.bias_free.mean, s.F, s.B, s.Q);
    if (bias_varies_) two_stage::vary_bias<kN, kD>(belief, s.G, s.W);
    seen = two_stage::correct<kN, kD, kM>(belief, z - s.H * belief.bias_free.mean, s.H, s.C, s.R);
  }

  TwoStage<kN, kD> belief;
  Gaussian<kJoint> augmented;
  kalman::Innovation<kM> expected;
  kalman::Innovation<kM> seen;

 private:
  std::uint64_t seed_;
  bool bias_varies_;
  std::uint32_t step_ = 0;
  Eigen::Matrix<double, kJoint, 1> truth_;
};

void expect_twins_agree(bool bias_varies) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Twins twins(seed, bias_varies);
    for (int step = 0; step < 400; ++step) {
      twins.step();
      const Gaussian<kJoint> both = joint(twins.belief);
      ASSERT_LT((both.mean - twins.augmented.mean).cwiseAbs().maxCoeff(), 1e-9) << seed << ", " << step;
      ASSERT_LT((both.covariance - twins.augmented.covariance).cwiseAbs().maxCoeff(), 1e-9)
          << seed << ", " << step;
      ASSERT_NEAR(twins.seen.nis, twins.expected.nis, 1e-7);
      ASSERT_NEAR(twins.seen.log_likelihood, twins.expected.log_likelihood, 1e-7);
    }
  }
}

TEST(TwoStage, EqualsTheAugmentedKalmanFilterForAConstantBias) { expect_twins_agree(false); }

TEST(TwoStage, EqualsTheAugmentedKalmanFilterForABiasThatVaries) { expect_twins_agree(true); }

/// Section 3.2 of [KIM], A1 ... B8, letter by letter.
TEST(TwoStage, DoesWhatIsPrinted) {
  RandomStream random(3, 0, 0);
  TwoStage<kN, kD> belief;
  belief.bias_free = {random_matrix<kN, 1>(random), random_covariance<kN>(random, 1.0)};
  belief.bias = {random_matrix<kD, 1>(random), random_covariance<kD>(random, 2.0)};
  belief.sensitivity = random_matrix<kN, kD>(random);
  const LinearStep s(random);
  const Eigen::Vector2d z = random_matrix<kM, 1>(random);
  const Eigen::Matrix3d P = s.F * belief.bias_free.covariance * s.F.transpose() + s.Q;  // A1
  const Eigen::Vector3d x = s.F * belief.bias_free.mean;                                // A2
  const Eigen::Matrix2d S = s.H * P * s.H.transpose() + s.R;
  const Eigen::Matrix<double, kN, kM> K_x = P * s.H.transpose() * S.inverse();  // A4
  const Eigen::Matrix3d P_updated = P - K_x * S * K_x.transpose();              // A5
  const Eigen::Vector2d innovation = z - s.H * x;                               // A7
  const Eigen::Vector3d x_updated = x + K_x * innovation;                       // A8
  const Eigen::Matrix<double, kN, kD> U = s.F * belief.sensitivity + s.B;       // B1
  const Eigen::Matrix2d T = s.H * U + s.C;                                      // B2
  const Eigen::Matrix<double, kN, kD> V = U - K_x * T;                          // B3
  const Eigen::Matrix2d M_old = belief.bias.covariance;
  const Eigen::Matrix2d M =
      M_old - M_old * T.transpose() * (S + T * M_old * T.transpose()).inverse() * T * M_old;            // B4
  const Eigen::Matrix2d K_b = M * (V.transpose() * s.H.transpose() + s.C.transpose()) * s.R.inverse();  // B5
  const Eigen::Vector2d b = (Eigen::Matrix2d::Identity() - K_b * T) * belief.bias.mean + K_b * innovation;
  const Eigen::Vector3d sigma = V * b;  // B7

  two_stage::predict<kN, kD>(belief, x, s.F, s.B, s.Q);
  two_stage::correct<kN, kD, kM>(belief, innovation, s.H, s.C, s.R);
  EXPECT_TRUE(belief.bias_free.mean.isApprox(x_updated, 1e-11));
  EXPECT_TRUE(belief.bias_free.covariance.isApprox(P_updated, 1e-11));
  EXPECT_TRUE(belief.sensitivity.isApprox(V, 1e-11));
  EXPECT_TRUE(belief.bias.covariance.isApprox(M, 1e-11));
  EXPECT_TRUE(belief.bias.mean.isApprox(b, 1e-11));
  EXPECT_TRUE(two_stage::corrected(belief).mean.isApprox(x_updated + sigma, 1e-11));  // B8
}

TEST(TwoStage, IsTheKalmanFilterWithoutBias) {
  RandomStream random(4, 0, 0);
  TwoStage<kN, kD> belief;
  Gaussian<kN> plain = belief.bias_free;
  for (int step = 0; step < 50; ++step) {
    const LinearStep s(random);
    const Eigen::Vector2d z = random_matrix<kM, 1>(random);
    kalman::predict<kN>(plain, s.F * plain.mean, s.F, s.Q);
    kalman::correct<kN, kM>(plain, z - s.H * plain.mean, s.H, s.R);
    two_stage::predict<kN, kD>(belief, s.F * belief.bias_free.mean, s.F, s.B, s.Q);
    two_stage::correct<kN, kD, kM>(belief, z - s.H * belief.bias_free.mean, s.H, s.C, s.R);
  }
  const Gaussian<kN> corrected = two_stage::corrected(belief);
  EXPECT_TRUE(corrected.mean.isApprox(plain.mean, 1e-12));
  EXPECT_TRUE(corrected.covariance.isApprox(plain.covariance, 1e-12));
  EXPECT_EQ(belief.bias.mean, Eigen::Vector2d::Zero());
}

/// Position and bias of the fix add up in every measurement: what was not known before, no number of them
/// tells.
TEST(TwoStage, ABiasOfTheMeasurementIsToldFromTheStateByThePriorsAlone) {
  using Vector1 = Eigen::Matrix<double, 1, 1>;
  TwoStage<1, 1> belief;
  belief.bias_free.covariance(0, 0) = 0.5;
  belief.bias.covariance(0, 0) = 4.0;
  for (int i = 0; i < 10000; ++i) {
    const Vector1 innovation(3.0 - belief.bias_free.mean(0));
    two_stage::correct<1, 1, 1>(belief, innovation, Vector1(1.0), Vector1(1.0), Vector1(0.1));
  }
  const Gaussian<1> x = two_stage::corrected(belief);
  EXPECT_NEAR(x.mean(0), 3.0 * 0.5 / 4.5, 1e-4);
  EXPECT_NEAR(belief.bias.mean(0), 3.0 * 4.0 / 4.5, 1e-4);
  EXPECT_NEAR(x.covariance(0, 0), 0.5 * 4.0 / 4.5, 1e-4);
  EXPECT_NEAR(belief.bias.covariance(0, 0), 0.5 * 4.0 / 4.5, 1e-4);
}

TEST(TwoStage, AConstantBiasIsNotVaried) {
  Twins twins(5, false);
  twins.step();
  const TwoStage<kN, kD> before = twins.belief;
  two_stage::vary_bias<kN, kD>(twins.belief, Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Zero());
  EXPECT_TRUE(twins.belief.bias_free.mean.isApprox(before.bias_free.mean, 1e-12));
  EXPECT_TRUE(twins.belief.bias_free.covariance.isApprox(before.bias_free.covariance, 1e-12));
  EXPECT_TRUE(twins.belief.sensitivity.isApprox(before.sensitivity, 1e-12));

  TwoStage<kN, kD> unbiased;
  unbiased.sensitivity.setOnes();
  two_stage::vary_bias<kN, kD>(unbiased, Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Zero());
  EXPECT_EQ(unbiased.sensitivity, (Eigen::Matrix<double, kN, kD>::Ones()));
}

TEST(TwoStage, CompareSaysWhatCorrectWillSayAndChangesNothing) {
  Twins twins(6, true);
  for (int i = 0; i < 20; ++i) twins.step();
  RandomStream random(6, 0, 1);
  const LinearStep s(random);
  const Eigen::Vector2d innovation(0.4, -0.7);
  const Gaussian<kJoint> before = joint(twins.belief);
  const auto compared = two_stage::compare<kN, kD, kM>(twins.belief, innovation, s.H, s.C, s.R);
  EXPECT_EQ(joint(twins.belief).mean, before.mean);
  EXPECT_EQ(joint(twins.belief).covariance, before.covariance);
  const auto corrected = two_stage::correct<kN, kD, kM>(twins.belief, innovation, s.H, s.C, s.R);
  EXPECT_EQ(compared.nis, corrected.nis);
  EXPECT_EQ(compared.log_likelihood, corrected.log_likelihood);
}

TEST(TwoStage, ImpossibleInnovationCovarianceLeavesTheBeliefAlone) {
  TwoStage<2, 2> belief;
  belief.bias_free.covariance.setZero();
  belief.sensitivity.setOnes();
  const auto result =
      two_stage::correct<2, 2, 2>(belief, Eigen::Vector2d(1.0, 1.0), Eigen::Matrix2d::Identity(),
                                  Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero());
  EXPECT_TRUE(std::isinf(result.nis));
  EXPECT_EQ(belief.bias_free.mean, Eigen::Vector2d::Zero());
  EXPECT_EQ(belief.sensitivity, Eigen::Matrix2d::Ones());
}

}  // namespace
}  // namespace multipath_localization
