#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/building.hpp"

namespace multipath_localization {

struct LaserParameters {
  double rate = 0.0;
  int beams = 360;
  double range_min = 0.1;
  double range_max = 20.0;
  double noise = 0.01;

  void fields(ParameterVisitor& field);
};

/// A scanner that looks all round from where the base's reference point is, above which it stands. Its beams
/// begin backwards and go on counter-clockwise.
class Laser {
 public:
  /// Throws ParameterError on a building of fewer than three corners.
  Laser(const LaserParameters& parameters, const std::vector<BuildingParameters>& buildings,
        std::uint64_t seed);

  /// Whether a scan is due at `time` [s].
  bool due(double time);

  /// Of each beam, from `pose` in map, how far the nearest wall is [m]: infinity beyond `range_max`, and 0
  /// within `range_min`.
  std::vector<float> scan(const Pose2& pose);

  [[nodiscard]] double increment() const { return 2.0 * kPi / parameters_.beams; }  ///< of angle [rad]

 private:
  LaserParameters parameters_;
  std::vector<Wall> walls_;
  std::uint64_t seed_;
  std::uint32_t scans_ = 0;
};

}  // namespace multipath_localization
