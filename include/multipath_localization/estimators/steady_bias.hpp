#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

struct SteadyBiasParameters {
  double tolerance = 1.0;
  double distance = 150.0;
  double time = 150.0;
  double prior = 0.01;

  void fields(ParameterVisitor& field);
};

/// Doubts a bias that does not change. Reflections change as the robot drives on; an error of the pose does
/// not, and looks like a bias of the fixes that stays for good.
class SteadyBias {
 public:
  /// The fixes are held to have this bias, `distance` [m] and `duration` [s] of driving after the last call.
  void add(const Eigen::Vector2d& bias, double distance, double duration,
           const SteadyBiasParameters& parameters);
  /// There is no bias now.
  void clear() { *this = {}; }

  /// Probability that the fixes are right and the pose is wrong by the bias.
  [[nodiscard]] double probability(const SteadyBiasParameters& parameters) const;

 private:
  Eigen::Vector2d reference_ = Eigen::Vector2d::Zero();  ///< mean bias over the way [m]
  double way_ = 0.0;  ///< driven with it, 1 where pose and fixes are as likely to be wrong
};

}  // namespace multipath_localization
