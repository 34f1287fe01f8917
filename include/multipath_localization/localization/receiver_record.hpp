#pragma once

#include <optional>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/localization/mirror_check.hpp"
#include "multipath_localization/localization/receiver_covariance.hpp"

namespace multipath_localization {

/// A receiver that says the same to the bit while the robot drives on.
struct FrozenReceiver {
  double duration = 0.0;  ///< since it said so first [s]
  double driven = 0.0;    ///< since then [m]
};

/// What the fixes of one receiver have shown so far.
struct ReceiverRecord {
  explicit ReceiverRecord(const ReceiverCovarianceParameters& parameters) : covariance(parameters) {}

  /// Takes note of where a fix lies after a way of `driven` [m] in all, and tells why a repeated one is
  /// refused: it is `frozen` once the robot has driven `frozen_distance` [m] since, and `repeated` before.
  void tell_frozen(const GnssFix& fix, double driven, double frozen_distance, Reason& reason);

  ReceiverCovariance covariance;
  MirrorCheck mirror;
  std::optional<FrozenReceiver> frozen;  ///< what the last fix told of that

 private:
  /// A place fixes have told, and when and after which way they did so first.
  struct Told {
    Eigen::Vector2d position;
    double stamp;
    double driven;
  };
  std::optional<Told> told_;  ///< last
};

}  // namespace multipath_localization
