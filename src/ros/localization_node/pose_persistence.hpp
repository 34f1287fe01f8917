#pragma once

#include <optional>
#include <string>
#include <utility>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "ros/localization_node/saved_pose.hpp"
#include "support/background_writer.hpp"

namespace multipath_localization {

/// Keeps the pose in a file, from which the next run goes on.
class PosePersistence {
 public:
  /// An empty name of a file: nothing is kept.
  PosePersistence(std::string file, double max_age) : file_(std::move(file)), max_age_(max_age) {}

  /// What the last run leaves to start from.
  struct Start {
    PosePrior prior;
    Geodetic datum;  ///< of its map
  };
  /// What to start from at this odometry; nothing where nothing was saved. Throws ParameterError where what
  /// was does not count: see `resumed`, and where `map` is known and another.
  [[nodiscard]] std::optional<Start> start(const OdometryState& now, const LocalFrame* map) const;

  /// Whether a pose is to be saved by now, at that stamp of odometry [s]: once a second.
  [[nodiscard]] bool due(double stamp) const;
  /// Saves it, without waiting for the disk.
  void save(const SavedPose& pose);

  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string file_;
  double max_age_;
  double saved_ = 0.0;  ///< stamp of the odometry of the pose saved last [s]
  BackgroundWriter writer_;
};

}  // namespace multipath_localization
