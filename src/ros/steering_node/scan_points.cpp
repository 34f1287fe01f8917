#include "ros/steering_node/scan_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace multipath_localization {

namespace {

constexpr std::size_t kMostBeams = 100000;

std::string fault_of(const sensor_msgs::LaserScan& scan) {
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment)) return "scan of unknown angles";
  if (!std::isfinite(scan.range_min) || !(scan.range_max > scan.range_min)) return "scan of unknown ranges";
  if (scan.ranges.size() > kMostBeams) return "scan of too many beams";
  const auto blind = [](float range) { return std::isnan(range); };
  if (std::all_of(scan.ranges.begin(), scan.ranges.end(), blind)) return "scan without a range";
  return "";
}

/// How far off a beam found something [m].
std::optional<double> found_at(float range, const sensor_msgs::LaserScan& scan) {
  if (std::isinf(range) && range < 0.0F) return scan.range_min;
  if (!(range >= scan.range_min && range <= scan.range_max)) return std::nullopt;
  return range;
}

}  // namespace

ScanPoints scan_points(const sensor_msgs::LaserScan& scan, const Eigen::Isometry3d& scanner_in_base,
                       const Footprint& robot) {
  ScanPoints points{{}, fault_of(scan)};
  if (!points.fault.empty()) return points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const auto range = found_at(scan.ranges[i], scan);
    if (!range) continue;
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Eigen::Vector3d found(*range * std::cos(angle), *range * std::sin(angle), 0.0);
    const Eigen::Vector2d point = (scanner_in_base * found).head<2>();
    if (!robot.holds(point)) points.in_base.push_back(point);
  }
  return points;
}

}  // namespace multipath_localization
