#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "evaluation/drive.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/trust.hpp"

namespace multipath_localization {

/// One instant and what the estimator held then.
struct Epoch {
  TruthSample truth;  ///< of a drive without truth its stamp alone counts
  Trust state = Trust::kNotReady;
  bool valid = false;  ///< whether the estimator claimed to know anything; nothing below counts otherwise
  bool aligned = false;
  Pose2 estimate;  ///< base in map
  Eigen::Matrix2d position_covariance =
      Eigen::Matrix2d::Identity();  ///< of all hypotheses, as published [m^2]
  double yaw_variance = 0.0;        ///< as published [rad^2]
  double shadow_probability = 0.0;
  double wheel_fault_probability = 0.0;
};

/// Estimate minus truth, in map [m].
Eigen::Vector2d error_of(const Epoch& epoch);

/// Normalised estimation error squared of position, 2 degrees of freedom. One square millimetre is added to
/// the declared variances, so that it is finite where they are zero.
double nees_of(const Epoch& epoch);

/// How far off the estimates were. Distances are horizontal.
struct Score {
  std::size_t epochs = 0;      ///< scored: valid and not before the time to score from
  std::size_t unscored = 0;    ///< after that time without a valid estimate
  std::optional<double> mean;  ///< [m], like all below up to `max`
  std::optional<double> rmse;
  std::optional<double> median;
  std::optional<double> p95;  ///< 95 % quantile, linear between order statistics
  std::optional<double> max;
  std::optional<double> heading_rmse;  ///< over the samples whose truth has a heading [rad]
  std::optional<double> rmse_shadow;   ///< over the samples flagged as shadow [m]
  std::optional<double> rmse_open;     ///< over the samples flagged as open [m]
  std::optional<double> nees_mean;     ///< of `nees_of`: 2 is ideal
  std::optional<double> in_ellipse;    ///< fraction inside the estimate's own 95 % ellipse
};

/// Epochs stamped `from` or later. A figure that applies to no epoch is empty.
Score score(const std::vector<Epoch>& epochs, double from);

/// The longest time on end [s], from `from` on, that an estimate was off by `distance` [m] or more; epochs
/// without estimate count as off once there was one. Nothing without a valid epoch.
std::optional<double> longest_off(const std::vector<Epoch>& epochs, double from, double distance);

/// The longest time on end [s], from `from` on, that the error lay outside the 3 sigma ellipse of the
/// declared covariance: a confident wrong pose. Epochs without estimate claim nothing. Nothing without a
/// valid epoch.
std::optional<double> longest_beyond_3_sigma(const std::vector<Epoch>& epochs, double from);

/// The way driven until an estimate first counted as aligned [m]; nothing where none ever did.
std::optional<double> way_to_alignment(const std::vector<Epoch>& epochs);

/// The fixes themselves against truth at their own stamps; those without truth or before `from` do not count.
/// The lever arm is carried by the true heading where there is one.
Score score_fixes(const Drive& drive, double from);

/// The quantile of `values` at `fraction` in 0..1, linear between order statistics. `values` must not be
/// empty.
double quantile(std::vector<double> values, double fraction);

}  // namespace multipath_localization
