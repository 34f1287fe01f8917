#include "estimators/nishida/bias_radius.hpp"

namespace multipath_localization {

namespace {

constexpr double kStartRateSigma = 10.0;  ///< of the offset's rate before it was seen to change [m/s]

}  // namespace

double BiasRadius::update(const Eigen::Vector2d& fix, const Eigen::Vector2d& predicted, double sigma_c,
                          double duration) {
  const bool relative = parameters_.bias_input == BiasInput::kRelative;
  const Eigen::Vector2d z = relative ? Eigen::Vector2d(fix - predicted) : fix;
  const double variance = sigma_c * sigma_c;
  if (!started_) {
    started_ = true;
    const double rate_variance = kStartRateSigma * kStartRateSigma;
    eta_.mean << z.x(), 0.0, z.y(), 0.0;
    eta_.covariance = Eigen::Vector4d(variance, rate_variance, variance, rate_variance).asDiagonal();
  } else {
    const gnss_bias::Matrix A = gnss_bias::transition(duration);
    kalman::predict<4>(eta_, A * eta_.mean, A,
                       gnss_bias::process_noise(parameters_.bias_process_noise, duration));
    const Eigen::Matrix<double, 2, 4> H = gnss_bias::observation();
    kalman::correct<4, 2>(eta_, z - H * eta_.mean, H, variance * Eigen::Matrix2d::Identity());
  }
  const Eigen::Vector2d smoothed = gnss_bias::offset(eta_.mean);
  return parameters_.bias_input == BiasInput::kSmoothed ? (smoothed - predicted).norm() : smoothed.norm();
}

Eigen::Matrix2d BiasRadius::covariance() const {
  const Eigen::Matrix<double, 2, 4> H = gnss_bias::observation();
  return H * eta_.covariance * H.transpose();
}

}  // namespace multipath_localization
