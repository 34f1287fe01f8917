#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/filters/kalman.hpp"

namespace multipath_localization {

/// A state of N numbers and a bias of D numbers that enters its dynamics and its measurements linearly:
/// x(k) = f(x(k-1)) + B b + w, z = h(x) + C b + v, Eqs. (7), (8) of [KIM]. Kept in two stages: the estimate
/// that there would be without bias, and the bias, which sees the state through its sensitivity V. The three
/// say the same as a joint Gaussian of x and b in which x = bias_free + V b, bias_free independent of b.
template <int N, int D>
struct TwoStage {
  Gaussian<N> bias_free;                                                          ///< x, P of [KIM] 3.2 A
  Gaussian<D> bias{Eigen::Matrix<double, D, 1>::Zero(),                           ///< b, M of [KIM] 3.2 B;
                   Eigen::Matrix<double, D, D>::Zero()};                          ///< none while M = 0
  Eigen::Matrix<double, N, D> sensitivity = Eigen::Matrix<double, N, D>::Zero();  ///< V, N x D
};

/// The two-stage estimator of Friedland 1969, section 3.2 of [KIM]. On a linear system with a constant bias
/// it is the Kalman filter of state and bias together.
///
/// Departs, throughout: A5 and B4 in Joseph form and B5 without R^-1, which are equal and stay positive in
/// the presence of rounding.
namespace two_stage {

/// Eqs. B7, B8 of [KIM]: the state with the bias allowed for, x + V b, and its covariance P + V M V', which
/// [KIM] leaves out and Friedland gives.
template <int N, int D>
Gaussian<N> corrected(const TwoStage<N, D>& belief) {
  const auto& V = belief.sensitivity;
  return {belief.bias_free.mean + V * belief.bias.mean,
          symmetric<N>(belief.bias_free.covariance + V * belief.bias.covariance * V.transpose())};
}

/// Eqs. A1, A2, B1 of [KIM]: moves the bias-free estimate to `mean` = f(x), with F = df/dx (N x N), Q of size
/// N x N and B = dx/db (N x D) of this step. The sensitivity is U until the next correction.
///
/// Departs: A2 prints the Jacobian times the state for f; B1 prints F(k), B(k) for F(k-1), B(k-1), and V(k)
/// for V(k-1).
template <int N, int D>
void predict(TwoStage<N, D>& belief, const Eigen::Matrix<double, N, 1>& mean,
             const Eigen::Matrix<double, N, N>& F, const Eigen::Matrix<double, N, D>& B,
             const Eigen::Matrix<double, N, N>& Q) {
  kalman::predict<N>(belief.bias_free, mean, F, Q);
  belief.sensitivity = F * belief.sensitivity + B;
}

/// Lets the bias change to G b + noise of covariance W (both D x D), and splits the joint Gaussian into
/// independent stages again, without loss.
///
/// Departs: Eq. (9) of [KIM] has the bias constant, G = I and W = 0, where this does nothing.
template <int N, int D>
void vary_bias(TwoStage<N, D>& belief, const Eigen::Matrix<double, D, D>& G,
               const Eigen::Matrix<double, D, D>& W) {
  using MatrixD = Eigen::Matrix<double, D, D>;
  const MatrixD M = belief.bias.covariance;
  const Eigen::Matrix<double, N, D> U = belief.sensitivity;
  const MatrixD M_varied = symmetric<D>(G * M * G.transpose() + W);
  const Eigen::LLT<MatrixD> factor(M_varied);
  if (factor.info() != Eigen::Success) return;
  // The old bias given the new one is L times it, with the covariance of a correction by it.
  const MatrixD L = factor.solve(G * M).transpose();
  const MatrixD kept = MatrixD::Identity() - L * G;
  const MatrixD left = kept * M * kept.transpose() + L * W * L.transpose();
  belief.bias_free.mean += U * (belief.bias.mean - L * G * belief.bias.mean);
  belief.bias_free.covariance = symmetric<N>(belief.bias_free.covariance + U * left * U.transpose());
  belief.sensitivity = U * L;
  belief.bias = {G * belief.bias.mean, M_varied};
}

/// Compares without correcting: `innovation` z - h(x) of the bias-free estimate (M), H = dh/dx (M x N) at it,
/// C = dz/db (M x D), R (M x M). The result is of the measurement with the bias allowed for: z - h(x) - T b
/// with T = H U + C, Eq. B2 of [KIM], and its covariance, the bracket of B4.
template <int N, int D, int M>
kalman::Innovation<M> compare(const TwoStage<N, D>& belief, const Eigen::Matrix<double, M, 1>& innovation,
                              const Eigen::Matrix<double, M, N>& H, const Eigen::Matrix<double, M, D>& C,
                              const Eigen::Matrix<double, M, M>& R) {
  const Eigen::Matrix<double, M, D> T = H * belief.sensitivity + C;
  const auto bias_free = kalman::compare<N, M>(belief.bias_free, innovation, H, R);
  return kalman::compare<D, M>(belief.bias, innovation - T * belief.bias.mean, T, bias_free.covariance);
}

/// Eqs. A4-A8, B2-B6 of [KIM]; arguments and result as of `compare`. The bias filter is a Kalman filter that
/// measures the bias-free innovation, T b plus an error of covariance S. Leaves the belief alone when S is
/// not positive definite.
///
/// Departs: A3 prints the Jacobian times the state for h.
template <int N, int D, int M>
kalman::Innovation<M> correct(TwoStage<N, D>& belief, const Eigen::Matrix<double, M, 1>& innovation,
                              const Eigen::Matrix<double, M, N>& H, const Eigen::Matrix<double, M, D>& C,
                              const Eigen::Matrix<double, M, M>& R) {
  const Eigen::Matrix<double, M, D> T = H * belief.sensitivity + C;  // B2
  const Eigen::Matrix<double, N, M> PHt = belief.bias_free.covariance * H.transpose();
  const auto bias_free = kalman::correct<N, M>(belief.bias_free, innovation, H, R);  // A4-A8
  const Eigen::Matrix<double, M, 1> left = innovation - T * belief.bias.mean;
  if (!std::isfinite(bias_free.nis)) return kalman::compare<D, M>(belief.bias, left, T, bias_free.covariance);
  belief.sensitivity -= PHt * bias_free.covariance.llt().solve(T);           // B3
  return kalman::correct<D, M>(belief.bias, left, T, bias_free.covariance);  // B4-B6
}

}  // namespace two_stage

}  // namespace multipath_localization
