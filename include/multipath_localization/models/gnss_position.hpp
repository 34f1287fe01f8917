#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// Derivative of the antenna's position in map, `pose * antenna_in_base`, to (x, y, yaw).
Eigen::Matrix<double, 2, 3> antenna_jacobian(const Pose2& pose, const Eigen::Vector2d& antenna_in_base);

/// How far a receiver's own statement about its error is believed.
struct DeclaredCovarianceParameters {
  double fix_sigma_floor = 0.3;
  double fix_sigma_cap = 50.0;
  double fix_sigma_unknown = 3.0;

  void fields(ParameterVisitor& field);
};

/// The declared covariance (2x2, see `defect`) with its principal standard deviations held between floor and
/// cap; all zeros mean unknown.
Eigen::Matrix2d believed_covariance(const Eigen::Matrix2d& declared,
                                    const DeclaredCovarianceParameters& parameters);

/// p(z | x) of [NIS] section 3.4.
struct GnssLikelihoodParameters {
  double sigma_b = 0.05;            ///< root of 0.0025 m^2, section 4.1
  double sigma_s = 0.316227766017;  ///< root of Eq. (45)
  double sigma_p = 0.1;             ///< root of 0.01 rad^2, section 4.1
  bool use_declared_covariance = true;
  std::string likelihood_kernel = "product";

  void fields(ParameterVisitor& field);
};

/// The likelihood of one fix at any number of poses, in logarithms so that no distance underflows.
class GnssLikelihood {
 public:
  /// `declared` is the fix's covariance; `shadow_weight` is the share of Eq. (31) in Eq. (33): 1/2 there, 0
  /// for Eq. (47). `ring_radius` is r_hat of Eq. (32) [m].
  GnssLikelihood(const GnssLikelihoodParameters& parameters, const Eigen::Matrix2d& declared,
                 double shadow_weight, double ring_radius);

  struct Value {
    double log_likelihood = 0.0;
    double shadow_share = 0.0;  ///< part of the likelihood that Eq. (31) contributes, 0..1
  };

  /// Eq. (33). `error` = antenna expected at the pose - fix [m], with (dx, dy) = error in Eqs. (28), (29);
  /// `heading_error` is d_theta of Eq. (30) [rad], wrapped, or nothing when the fix tells no heading: then
  /// the heading's term is left out of Eqs. (27) and (31).
  ///
  /// Departs: delta(.), called Dirac's, is read as the difference.
  [[nodiscard]] Value operator()(const Eigen::Vector2d& error,
                                 const std::optional<double>& heading_error) const;

  [[nodiscard]] double sigma_b() const { return sigma_b_; }  ///< in force for this fix [m]
  [[nodiscard]] double sigma_s() const { return sigma_s_; }  ///< in force for this fix [m]

 private:
  [[nodiscard]] double log_position_direct(const Eigen::Vector2d& error) const;
  [[nodiscard]] double log_position_shadow(const Eigen::Vector2d& error) const;

  bool cross_;
  double sigma_b_;
  double sigma_s_;
  double sigma_p_;
  double ring_radius_;
  double log_direct_weight_;
  double log_shadow_weight_;
};

}  // namespace multipath_localization
