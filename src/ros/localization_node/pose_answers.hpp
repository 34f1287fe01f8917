#pragma once

#include <optional>

#include "multipath_localization/localization/localizer.hpp"
#include "ros/localization_node/localization_outputs.hpp"
#include "ros/localization_node/map_to_odom.hpp"
#include "ros/localization_node/odometry_log.hpp"
#include "ros/localization_node/pose_persistence.hpp"
#include "ros/map/datum.hpp"

namespace multipath_localization {

/// Answers odometry: publishes the pose at each of its messages and broadcasts map -> odom; saves a pose now
/// and then.
class PoseAnswers {
 public:
  /// `outputs` has to outlive it.
  PoseAnswers(const LocalizationParameters& parameters, LocalizationOutputs& outputs);

  [[nodiscard]] OdometryLog& odometry() { return odometry_; }
  [[nodiscard]] const OdometryLog& odometry() const { return odometry_; }
  [[nodiscard]] MapToOdom& map_to_odom() { return map_to_odom_; }
  [[nodiscard]] const PosePersistence& persistence() const { return persistence_; }

  /// Answers the odometry that has no pose as yet: the last message, and at the start those before it,
  /// because the first fix may reach us after odometry that is younger. Returns the number of poses, or
  /// nothing where the estimate is not finite.
  std::optional<unsigned> publish(const Localizer& localizer, const Datum& datum);

  /// What the last odometry says.
  [[nodiscard]] OdometryState state() const;

 private:
  void save(const PoseEstimate& estimate, const Datum& datum);

  LocalizationOutputs& outputs_;
  OdometryLog odometry_;
  MapToOdom map_to_odom_;
  PosePersistence persistence_;
};

}  // namespace multipath_localization
