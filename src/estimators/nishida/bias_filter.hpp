#pragma once

#include <Eigen/Core>

#include "models/fix/gnss_likelihood.hpp"
#include "multipath_localization/filters/kalman.hpp"
#include "multipath_localization/models/fix/gnss_bias.hpp"

namespace multipath_localization {

/// The Kalman filter of [NIS] section 3.2 that smooths the fixes and gives their bias, Eqs. (14)-(21).
class BiasFilter {
 public:
  explicit BiasFilter(const GnssBiasParameters& parameters) : parameters_(parameters) { forget(); }

  void forget();

  /// Takes a fix `duration` [s] after the one before and gives the bias [m], whose length is r_hat, Eq. (21).
  /// `fix` and `predicted`, the antenna at f(x_est, u), in map [m]; sigma_c is `sigma.shadow`, section 3.2.
  Eigen::Vector2d update(const Eigen::Vector2d& fix, const Eigen::Vector2d& predicted, const FixSigmas& sigma,
                         double duration);

  /// Covariance of the smoothed offset [m^2].
  [[nodiscard]] Eigen::Matrix2d covariance() const;

  /// Probability that the last fix had direct signals. Departs from [NIS], which asks nowhere: by Eqs. (10)
  /// and (11) such fixes scatter less, and how they scatter about the smoothed offset shows wherever the
  /// robot is. One half unless `sky` is "scatter".
  [[nodiscard]] double open_probability() const { return open_; }

  /// What the bias may have moved by, unseen, since the sky was open [m^2]: a move of the bias and one of the
  /// robot look alike. Zero unless `sky` is "scatter".
  [[nodiscard]] Eigen::Matrix2d moved_unseen() const;

 private:
  void start(const Eigen::Vector2d& offset, double variance);
  void predict(double duration);
  void judge_sky(const Eigen::Vector2d& innovation, const FixSigmas& sigma);
  [[nodiscard]] bool judges_sky() const { return parameters_.sky == Sky::kScatter; }

  GnssBiasParameters parameters_;
  bool started_ = false;
  double open_ = 0.5;
  Gaussian<4> eta_;
  gnss_bias::Matrix unseen_;  ///< covariance of what moved since the sky was open
};

}  // namespace multipath_localization
