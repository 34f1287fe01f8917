#pragma once

#include <Eigen/Core>
#include <optional>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// Where the heading by fixes comes from, as `fix_heading` says.
enum class FixHeadingSource { kOff, kChord, kPrinted };

/// Decisions about Eq. (12) of [NIS].
struct FixHeadingParameters {
  FixHeadingSource fix_heading = FixHeadingSource::kOff;
  double fix_heading_distance = 5.0;

  void fields(ParameterVisitor& field);
};

/// The heading theta^GPS from an earlier estimate and a fix, Eq. (12) of [NIS].
///
/// Departs, unless "printed": Eq. (12) is undefined at rest, flips in reverse and adds the whole turn to the
/// chord's direction, where half of it is due. Here a chord counts from a least distance on, and it is
/// compared with the odometry's chord, which carries the sign of the speed (pi in reverse) and the shape of
/// the way.
class FixHeading {
 public:
  explicit FixHeading(const FixHeadingParameters& parameters) : parameters_(parameters) {}

  /// Begins the next chord at an estimated position [m].
  void restart(const Eigen::Vector2d& position);
  void add(const OdometryIncrement& u) { base_in_start_ = base_in_start_ * displacement(u); }

  /// Whether the chord is long enough.
  [[nodiscard]] bool due() const;

  /// Heading of the base now [rad], wrapped, from the position of the base by a fix; nothing until due.
  [[nodiscard]] std::optional<double> heading(const Eigen::Vector2d& base_by_fix) const;

 private:
  FixHeadingParameters parameters_;
  Eigen::Vector2d start_ = Eigen::Vector2d::Zero();
  Pose2 base_in_start_;  ///< by dead reckoning
};

}  // namespace multipath_localization
