#include "estimators/nishida/fix_heading.hpp"

#include <cmath>

namespace multipath_localization {

void FixHeadingParameters::fields(ParameterVisitor& field) {
  field("fix_heading", fix_heading, {"off", "chord", "printed"},
        "heading from two positions, Eq. (12): off; chord = turned by the odometry's own chord, valid in "
        "reverse; printed = direction of the chord + yaw rate x time");
  field("fix_heading_distance", fix_heading_distance, {0.0, 1e3}, "m",
        "distance between the two positions at least; 0 as printed");
}

void FixHeading::restart(const Eigen::Vector2d& position) {
  start_ = position;
  base_in_start_ = Pose2{};
}

bool FixHeading::due() const {
  return parameters_.fix_heading != FixHeadingSource::kOff &&
         base_in_start_.position().norm() >= parameters_.fix_heading_distance;
}

std::optional<double> FixHeading::heading(const Eigen::Vector2d& base_by_fix) const {
  if (!due()) return std::nullopt;
  const Eigen::Vector2d seen = base_by_fix - start_;
  const double printed = std::atan2(seen.y(), seen.x()) + base_in_start_.yaw;
  if (parameters_.fix_heading == FixHeadingSource::kPrinted) return wrap_angle(printed);
  return wrap_angle(printed - std::atan2(base_in_start_.y, base_in_start_.x));
}

}  // namespace multipath_localization
