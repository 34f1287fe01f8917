#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization::multipath {

/// Headings of about a second as one.
struct HeadingSighting {
  double yaw = 0.0;        ///< mean, of the base of now [rad]
  double variance = 0.0;   ///< declared of one [rad^2]
  double count = 1.0;      ///< of headings
  double duration = 0.0;   ///< since the last sighting [s]
  double turn_rate = 0.0;  ///< of the robot within it, whatever the direction [rad/s]
  /// From where the antenna was at the start to the base of now, in the base of now; nothing once that is far
  /// [m].
  std::optional<Eigen::Vector2d> from_start;
};

/// Collects headings until they are weighed, and turns them on with the base.
class HeadingBlock {
 public:
  /// The robot moves on by that.
  void move(const OdometryIncrement& u);

  /// Takes a heading: how unusable it is, or nothing. One that is the same to the last digit is repeated.
  std::optional<Reason> add(const Heading& heading);

  [[nodiscard]] bool empty() const { return headings_.empty(); }
  /// Since the last `take` [s].
  [[nodiscard]] double age() const { return now_ - taken_; }

  /// Those of the headings that agree as one; forgets them. At least one has to be there.
  HeadingSighting take();

 private:
  std::vector<Heading> headings_;
  std::optional<double> last_;  ///< that was told [rad]
  double now_ = 0.0;
  double taken_ = 0.0;
  double turned_ = 0.0;  ///< since the last `take`, whatever the direction [rad]
};

}  // namespace multipath_localization::multipath
