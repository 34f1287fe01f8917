#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "simulation/gauss_markov.hpp"
#include "simulation/polygon.hpp"

namespace multipath_localization {

/// What a zone is bounded by, as `shape` says.
enum class ZoneShape { kHalfPlane, kPolygon };

/// How the error grows within a zone, as `law` says.
enum class ZoneLaw { kDepth, kRandomWalk };

/// A region in the shadow of buildings, where fixes carry a bias.
struct ZoneParameters {
  std::string name = "zone";
  ZoneShape shape = ZoneShape::kHalfPlane;
  std::vector<double> corners;  ///< polygon: [x0, y0, x1, y1, ...]
  double edge_x = 0.0;          ///< half-plane: a point of its edge
  double edge_y = 0.0;
  double inward = 3.14159265358979;  ///< half-plane: direction from the edge into the shadow
  ZoneLaw law = ZoneLaw::kDepth;
  double bias_cap = 5.0;
  double direction = 3.14159265358979;
  double direction_sigma = 0.0;
  double direction_rate = 0.0;
  double direction_walk = 0.0;
  double bias_sigma = 3.0;
  double bias_time_constant = 20.0;

  void fields(ParameterVisitor& field);
};

/// One zone and the bias in it as it runs with time. Deterministic by (seed, index).
class Zone {
 public:
  /// Throws ParameterError when a polygon has fewer than three corners.
  Zone(const ZoneParameters& parameters, std::uint64_t seed, std::uint32_t index);

  /// Moves the bias process on by one step of `duration` [s].
  void step(double duration);

  /// How far a point in map lies within the shadow [m], negative outside.
  [[nodiscard]] double depth(const Eigen::Vector2d& point) const;

  /// Bias of a fix taken at a point in map [m]; zero outside. By `law`:
  /// depth: its length is the depth, at most the cap, Eq. (44) of [NIS], which leaves the direction open;
  /// here it is fixed, turns at a rate or wanders. random_walk: a Gauss-Markov process, its length cut at the
  /// cap.
  [[nodiscard]] Eigen::Vector2d bias(const Eigen::Vector2d& point) const;

  [[nodiscard]] const ZoneParameters& parameters() const { return parameters_; }

 private:
  ZoneParameters parameters_;
  Polygon polygon_;
  std::uint64_t seed_;
  std::uint32_t index_;
  std::uint32_t steps_ = 0;
  double direction_ = 0.0;
  std::optional<GaussMarkov2> walk_;
};

/// What surrounds an antenna at one instant.
struct Reception {
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();  ///< of a fix taken here [m]
  bool in_shadow = false;
};

/// All zones of a receiver; of overlapping ones the first counts.
class Zones {
 public:
  /// Throws ParameterError when a polygon has fewer than three corners.
  Zones(const std::vector<ZoneParameters>& parameters, std::uint64_t seed);

  /// Moves them on by one step of `duration` [s].
  void step(double duration);
  /// At a point in map.
  [[nodiscard]] Reception around(const Eigen::Vector2d& point) const;

 private:
  std::vector<Zone> zones_;
};

}  // namespace multipath_localization
