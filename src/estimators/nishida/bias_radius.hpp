#pragma once

#include <Eigen/Core>

#include "multipath_localization/filters/kalman.hpp"
#include "multipath_localization/models/fix/gnss_bias.hpp"

namespace multipath_localization {

/// The Kalman filter of [NIS] section 3.2 that smooths the fixes and gives the radius r_hat of the bias, Eqs.
/// (14)-(21).
class BiasRadius {
 public:
  explicit BiasRadius(const GnssBiasParameters& parameters) : parameters_(parameters) {}

  void forget() { started_ = false; }

  /// Takes a fix `duration` [s] after the one before and gives r_hat [m], Eq. (21). `fix` and `predicted`,
  /// the antenna at f(x_est, u), in map [m]; `sigma_c` is the fix's standard deviation [m], sigma_s by
  /// section 3.2.
  double update(const Eigen::Vector2d& fix, const Eigen::Vector2d& predicted, double sigma_c,
                double duration);

  /// Covariance of the smoothed offset [m^2].
  [[nodiscard]] Eigen::Matrix2d covariance() const;

 private:
  GnssBiasParameters parameters_;
  bool started_ = false;
  Gaussian<4> eta_;
};

}  // namespace multipath_localization
