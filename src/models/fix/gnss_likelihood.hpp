#pragma once

#include <optional>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "simd/block.hpp"
#include "simd/instruction_set.hpp"

namespace multipath_localization {

/// How the two parts of the likelihood meet, as `likelihood_kernel` says.
enum class LikelihoodKernel { kProduct, kCross };

/// p(z | x) of [NIS] section 3.4.
struct GnssLikelihoodParameters {
  double sigma_b = 0.05;            ///< root of 0.0025 m^2, section 4.1
  double sigma_s = 0.316227766017;  ///< root of Eq. (45)
  double sigma_p = 0.1;             ///< root of 0.01 rad^2, section 4.1
  bool use_declared_covariance = true;
  LikelihoodKernel likelihood_kernel = LikelihoodKernel::kProduct;

  void fields(ParameterVisitor& field);
};

/// sigma_b and sigma_s in force for one fix [m].
struct FixSigmas {
  double direct;
  double shadow;
};

/// Those of the parameters, raised to what the receiver declares where that is asked for.
FixSigmas fix_sigmas(const GnssLikelihoodParameters& parameters, const GnssFix& fix);

/// Where a fix in shadow puts the antenna: `radius` [m] from the fix less `offset`, in map [m].
struct ShadowRing {
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/// The likelihood of one fix at any number of poses, Eq. (33) of [NIS]: a mixture of Gaussian kernels, in
/// logarithms so that no distance underflows.
///
/// Departs: delta(.), called Dirac's, is read as the difference.
class GnssLikelihood {
 public:
  /// `shadow_weight` is the share of Eq. (31) in Eq. (33): 1/2 there, 0 for Eq. (47). `ring` is round the
  /// fix, with r_hat, in Eq. (32). `heading` is the yaw that the fix tells [rad], or nothing: then the
  /// heading's term is left out of Eqs. (27) and (31).
  GnssLikelihood(const GnssLikelihoodParameters& parameters, const GnssFix& fix, double shadow_weight,
                 const ShadowRing& ring, const std::optional<double>& heading);

  /// Adds the logarithm of its largest term at each pose to `log_weight`; `factor` becomes what all terms are
  /// to the largest, 1..4, whose logarithm few need; `shadow_share` the part, 0..1, that Eq. (31)
  /// contributes.
  void add_to(InstructionSet set, const PoseBlock& poses, double* log_weight, double* factor,
              float* shadow_share) const;

 private:
  bool cross_;
  ShadowRing ring_;
  double shadow_weight_;
  FixSigmas sigma_;
  double sigma_p_;
  Eigen::Vector2d fix_;
  Eigen::Vector2d antenna_in_base_;
  std::optional<double> heading_;
};

}  // namespace multipath_localization
