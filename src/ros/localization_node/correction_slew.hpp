#pragma once

#include <optional>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"

namespace multipath_localization {

/// How fast map -> odom may move the robot in map; 0 stands for any.
struct SlewParameters {
  double max_correction_rate = 0.0;
  double max_correction_turn_rate = 0.0;

  void fields(ParameterVisitor& field);
};

/// Lets map -> odom follow the estimate no faster than asked for, so that a controller in map is not shaken.
/// Rates are those at the robot, however far from the origin of odom it is.
class CorrectionSlew {
 public:
  explicit CorrectionSlew(const SlewParameters& parameters) : parameters_(parameters) {}

  /// The correction to show where `odom_in_map` is the estimate's, at that stamp [s].
  Pose2 follow(const Pose2& odom_in_map, const Pose2& base_in_odom, double stamp);

  void tune(ParameterVisitor& field) { parameters_.fields(field); }

  /// The next correction is shown as it is.
  void jump() { shown_.reset(); }

 private:
  SlewParameters parameters_;
  std::optional<Pose2> shown_;  ///< odom in map
  double stamp_ = 0.0;          ///< of it [s]
};

}  // namespace multipath_localization
