#include "estimators/nishida/bias_filter.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kStartRateSigma = 10.0;  ///< of the offset's rate before it was seen to change [m/s]

/// Open sky is never less probable, nor shadow. Far below what either is: few fixes that happen to agree in a
/// shadow would else be taken for open sky, and the pose thrown onto them. Ten that do agree overcome it.
constexpr double kLeastProbability = 1e-9;

}  // namespace

void BiasFilter::forget() {
  started_ = false;
  open_ = 0.5;
  unseen_.setZero();
}

Eigen::Vector2d BiasFilter::update(const Eigen::Vector2d& fix, const Eigen::Vector2d& predicted,
                                   const FixSigmas& sigma, double duration) {
  const bool relative = parameters_.bias_input == BiasInput::kRelative;
  const Eigen::Vector2d z = relative ? Eigen::Vector2d(fix - predicted) : fix;
  const double variance = square(sigma.shadow);
  if (!started_) {
    start(z, variance);
  } else {
    predict(duration);
    const Eigen::Matrix<double, 2, 4> H = gnss_bias::observation();
    const Eigen::Vector2d innovation = z - H * eta_.mean;
    if (judges_sky()) judge_sky(innovation, sigma);
    kalman::correct<4, 2>(eta_, innovation, H, variance * Eigen::Matrix2d::Identity());
  }
  // Eq. (10): no bias under open sky.
  if (judges_sky() && relative) eta_.mean *= 1.0 - open_;
  const Eigen::Vector2d smoothed = gnss_bias::offset(eta_.mean);
  return parameters_.bias_input == BiasInput::kSmoothed ? Eigen::Vector2d(smoothed - predicted) : smoothed;
}

void BiasFilter::start(const Eigen::Vector2d& offset, double variance) {
  started_ = true;
  const double rate_variance = square(kStartRateSigma);
  eta_.mean << offset.x(), 0.0, offset.y(), 0.0;
  eta_.covariance = Eigen::Vector4d(variance, rate_variance, variance, rate_variance).asDiagonal();
}

/// Eqs. (16), (17) of [NIS].
void BiasFilter::predict(double duration) {
  const gnss_bias::Matrix A = gnss_bias::transition(parameters_.bias_motion, duration);
  const gnss_bias::Matrix Q =
      gnss_bias::process_noise(parameters_.bias_motion, parameters_.bias_process_noise, duration);
  kalman::predict<4>(eta_, A * eta_.mean, A, Q);
  if (judges_sky()) unseen_ = A * unseen_ * A.transpose() + Q;
}

/// Bayes' rule between the two cases of Eq. (10) of [NIS].
void BiasFilter::judge_sky(const Eigen::Vector2d& innovation, const FixSigmas& sigma) {
  const auto log_likelihood = [&](double s) {
    return kalman::compare<4, 2>(eta_, innovation, gnss_bias::observation(),
                                 square(s) * Eigen::Matrix2d::Identity())
        .log_likelihood;
  };
  const double open = std::log(open_) + log_likelihood(sigma.direct);
  const double shadow = std::log(1.0 - open_) + log_likelihood(sigma.shadow);
  open_ = std::clamp(std::exp(open - log_sum(open, shadow)), kLeastProbability, 1.0 - kLeastProbability);
  unseen_ *= 1.0 - open_;
}

Eigen::Matrix2d BiasFilter::covariance() const {
  const Eigen::Matrix<double, 2, 4> H = gnss_bias::observation();
  return H * eta_.covariance * H.transpose();
}

Eigen::Matrix2d BiasFilter::moved_unseen() const {
  const Eigen::Matrix<double, 2, 4> H = gnss_bias::observation();
  return H * unseen_ * H.transpose();
}

}  // namespace multipath_localization
