#include "simulation/laser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/periods.hpp"
#include "simulation/streams.hpp"
#include "support/plane.hpp"

namespace multipath_localization {

namespace {

/// How far along a ray a wall is; infinity where the ray does not come to it.
double range_to(const Wall& wall, const Eigen::Vector2d& origin, const Eigen::Vector2d& ray) {
  const double slant = cross(ray, wall.along);
  if (slant == 0.0) return std::numeric_limits<double>::infinity();
  const Eigen::Vector2d way = wall.start - origin;
  const double range = cross(way, wall.along) / slant;
  const double along = cross(way, ray) / slant;
  const bool met = range >= 0.0 && along >= 0.0 && along <= wall.length;
  return met ? range : std::numeric_limits<double>::infinity();
}

}  // namespace

void LaserParameters::fields(ParameterVisitor& field) {
  field("rate", rate, {0.0, 1e3}, "Hz", "of scans, at most one per simulation step; 0: there is no scanner");
  field("beams", beams, {4, 10000}, "1", "all round");
  field("range_min", range_min, {0.0, 100.0}, "m", "nearer it sees nothing");
  field("range_max", range_max, {0.1, 1e3}, "m", "farther it sees nothing");
  field("noise", noise, {0.0, 10.0}, "m", "white, of each range");
}

Laser::Laser(const LaserParameters& parameters, const std::vector<BuildingParameters>& buildings,
             std::uint64_t seed)
    : parameters_(parameters), seed_(seed) {
  for (const BuildingParameters& building : buildings) {
    const std::vector<Wall> of_building = walls(building);
    walls_.insert(walls_.end(), of_building.begin(), of_building.end());
  }
}

bool Laser::due(double time) {
  const auto due = static_cast<std::uint32_t>(periods(time, parameters_.rate));
  if (due <= scans_) return false;
  scans_ = due;
  return true;
}

std::vector<float> Laser::scan(const Pose2& pose) {
  RandomStream random(seed_, scans_, kLaserStream);
  std::vector<float> ranges;
  for (int i = 0; i < parameters_.beams; ++i) {
    const double angle = pose.yaw - kPi + i * increment();
    const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls_) nearest = std::min(nearest, range_to(wall, pose.position(), ray));
    const double range = nearest + parameters_.noise * random.normal();
    const bool far = range > parameters_.range_max;
    ranges.push_back(far ? std::numeric_limits<float>::infinity()
                         : static_cast<float>(range < parameters_.range_min ? 0.0 : range));
  }
  return ranges;
}

}  // namespace multipath_localization
