#pragma once

#include <nav_msgs/Odometry.h>

#include <string>
#include <vector>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "ros/inputs/odometry_reader.hpp"

namespace multipath_localization {

struct Silence {
  double begin = 0.0;  ///< stamp of the last message before [s]
  double end = 0.0;    ///< and of the first that is used after [s]
};

/// The odometry of a bag as the localization node would take it.
class BagOdometry {
 public:
  /// `name`: of file and topic, in errors.
  explicit BagOdometry(std::string name) : name_(std::move(name)) {}

  /// Takes a message, or says why not. Throws DriveError where the stamps go back in time.
  Reason add(const nav_msgs::Odometry& message);

  [[nodiscard]] const std::vector<OdometryIncrement>& increments() const { return increments_; }
  /// Where it was silent for so long that the localization node starts afresh.
  [[nodiscard]] const std::vector<Silence>& silences() const { return silences_; }
  /// Whether its frame is that of map, whose odometry the localization node refuses.
  [[nodiscard]] bool in_map() const { return in_map_; }
  /// When another message of that stamp came in: the stamp of the last odometry before it [s].
  [[nodiscard]] double arrival(double stamp) const {
    return increments_.empty() ? stamp : increments_.back().stamp;
  }

 private:
  void note_restart(double stamp);

  std::string name_;
  OdometryReader reader_{{}, ""};
  std::vector<OdometryIncrement> increments_;
  std::vector<Silence> silences_;
  bool in_map_ = false;
};

}  // namespace multipath_localization
