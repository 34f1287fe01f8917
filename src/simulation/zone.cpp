#include "simulation/zone.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

Eigen::Vector2d along(double direction) { return {std::cos(direction), std::sin(direction)}; }

}  // namespace

void ZoneParameters::fields(ParameterVisitor& field) {
  field("name", name, {}, "what to call it");
  field("shape", shape, {"half_plane", "polygon"}, "half of the plane, or an outline");
  field("corners", corners, {-1e6, 1e6}, "m", "polygon: x0, y0, x1, y1, ... in map");
  field("edge_x", edge_x, {-1e6, 1e6}, "m", "half_plane: a point of its edge, east");
  field("edge_y", edge_y, {-1e6, 1e6}, "m", "half_plane: the same point, north");
  field("inward", inward, {-2.0 * kPi, 2.0 * kPi}, "rad",
        "half_plane: direction from the edge into the shadow");
  field("law", law, {"depth", "random_walk"},
        "length of the bias: depth into the shadow, Eq. (44) of [NIS], or a Gauss-Markov walk of both "
        "components");
  field("bias_cap", bias_cap, {0.0, 1e4}, "m", "longest bias");
  field("direction", direction, {-2.0 * kPi, 2.0 * kPi}, "rad", "depth: direction of the bias at the start");
  field("direction_sigma", direction_sigma, {0.0, 10.0}, "rad",
        "depth: spread of that direction from seed to seed");
  field("direction_rate", direction_rate, {-10.0, 10.0}, "rad/s", "depth: turn of the direction");
  field("direction_walk", direction_walk, {0.0, 10.0}, "rad/sqrt(s)", "depth: random walk of the direction");
  field("bias_sigma", bias_sigma, {0.0, 1e4}, "m", "random_walk: standard deviation of each component");
  field("bias_time_constant", bias_time_constant, {1e-3, 1e6}, "s", "random_walk: correlation time");
}

Zone::Zone(const ZoneParameters& parameters, std::uint64_t seed, std::uint32_t index)
    : parameters_(parameters), seed_(seed), index_(index), direction_(parameters.direction) {
  if (parameters_.shape == ZoneShape::kPolygon)
    polygon_ = Polygon(parameters_.corners, "zone " + parameters_.name);
  RandomStream random(seed_, 0, kZoneStream + index_);
  direction_ += parameters_.direction_sigma * random.normal();
  walk_.emplace(parameters_.bias_sigma, parameters_.bias_time_constant, random);
}

void Zone::step(double duration) {
  RandomStream random(seed_, ++steps_, kZoneStream + index_);
  direction_ = wrap_angle(direction_ + parameters_.direction_rate * duration +
                          parameters_.direction_walk * std::sqrt(duration) * random.normal());
  walk_->step(duration, random);
}

double Zone::depth(const Eigen::Vector2d& point) const {
  if (parameters_.shape == ZoneShape::kPolygon) return polygon_.depth(point);
  return (point - Eigen::Vector2d(parameters_.edge_x, parameters_.edge_y)).dot(along(parameters_.inward));
}

Eigen::Vector2d Zone::bias(const Eigen::Vector2d& point) const {
  const double inside = depth(point);
  if (!(inside > 0.0)) return Eigen::Vector2d::Zero();
  if (parameters_.law == ZoneLaw::kDepth) return std::min(inside, parameters_.bias_cap) * along(direction_);
  const Eigen::Vector2d& walk = walk_->value();
  const double length = walk.norm();
  return length > parameters_.bias_cap ? Eigen::Vector2d(walk * (parameters_.bias_cap / length)) : walk;
}

Zones::Zones(const std::vector<ZoneParameters>& parameters, std::uint64_t seed) {
  for (const ZoneParameters& zone : parameters) {
    zones_.emplace_back(zone, seed, static_cast<std::uint32_t>(zones_.size()));
  }
}

void Zones::step(double duration) {
  for (Zone& zone : zones_) zone.step(duration);
}

Reception Zones::around(const Eigen::Vector2d& point) const {
  for (const Zone& zone : zones_) {
    if (zone.depth(point) > 0.0) return {zone.bias(point), true};
  }
  return {};
}

}  // namespace multipath_localization
