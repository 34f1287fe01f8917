#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/covariance.hpp"

namespace multipath_localization {

/// A normal distribution over N numbers: mean of size N, covariance of size N x N, symmetric.
template <int N>
struct Gaussian {
  Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Identity();
};

/// The Kalman filter's two steps for states of N and measurements of M numbers. They know no angles: the
/// caller wraps what has to be wrapped, in the mean it passes and in the innovation.
namespace kalman {

/// How a measurement compares with what was expected of it.
template <int M>
struct Innovation {
  Eigen::Matrix<double, M, 1> innovation = Eigen::Matrix<double, M, 1>::Zero();  ///< y = z - h(x)
  Eigen::Matrix<double, M, M> covariance = Eigen::Matrix<double, M, M>::Zero();  ///< S = H P H' + R
  double nis = std::numeric_limits<double>::infinity();              ///< y' S^-1 y, chi-square of M dof
  double log_likelihood = -std::numeric_limits<double>::infinity();  ///< log N(y; 0, S)
};

/// Moves the belief to `mean` = f(x, u): P <- F P F' + Q with F = df/dx at the old mean (N x N), Q of size N
/// x N.
template <int N>
void predict(Gaussian<N>& belief, const Eigen::Matrix<double, N, 1>& mean,
             const Eigen::Matrix<double, N, N>& F, const Eigen::Matrix<double, N, N>& Q) {
  belief.mean = mean;
  belief.covariance = symmetric<N>(F * belief.covariance * F.transpose() + Q);
}

/// Compares without correcting, for gates and mode probabilities: y (M), H = dh/dx (M x N), R (M x M). When S
/// is not positive definite the measurement explains nothing: NIS is infinite, the log likelihood minus
/// infinity.
template <int N, int M>
Innovation<M> compare(const Gaussian<N>& belief, const Eigen::Matrix<double, M, 1>& y,
                      const Eigen::Matrix<double, M, N>& H, const Eigen::Matrix<double, M, M>& R) {
  Innovation<M> result;
  result.innovation = y;
  result.covariance = symmetric<M>(H * belief.covariance * H.transpose() + R);
  const Eigen::LLT<Eigen::Matrix<double, M, M>> factor(result.covariance);
  if (factor.info() != Eigen::Success) return result;
  const Eigen::Matrix<double, M, 1> whitened = factor.matrixL().solve(y);
  const double log_root_determinant = factor.matrixLLT().diagonal().array().log().sum();
  result.nis = whitened.squaredNorm();
  result.log_likelihood = -0.5 * result.nis - log_root_determinant - 0.5 * M * std::log(2.0 * kPi);
  return result;
}

/// Corrects the belief by an innovation y (M) with H = dh/dx (M x N) and R (M x M), P in Joseph form
/// (I - K H) P (I - K H)' + K R K', which stays positive in the presence of rounding. Leaves the belief alone
/// when S is not positive definite.
template <int N, int M>
Innovation<M> correct(Gaussian<N>& belief, const Eigen::Matrix<double, M, 1>& y,
                      const Eigen::Matrix<double, M, N>& H, const Eigen::Matrix<double, M, M>& R) {
  const Innovation<M> result = compare<N, M>(belief, y, H, R);
  if (!std::isfinite(result.nis)) return result;
  const Eigen::LLT<Eigen::Matrix<double, M, M>> factor(result.covariance);
  const Eigen::Matrix<double, N, M> K = factor.solve(H * belief.covariance).transpose();
  const Eigen::Matrix<double, N, N> A = Eigen::Matrix<double, N, N>::Identity() - K * H;
  belief.mean += K * y;
  belief.covariance = symmetric<N>(A * belief.covariance * A.transpose() + K * R * K.transpose());
  return result;
}

}  // namespace kalman

}  // namespace multipath_localization
