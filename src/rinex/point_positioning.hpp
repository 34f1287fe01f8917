#pragma once

#include <optional>
#include <set>
#include <vector>

#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "rinex/tracked_satellite.hpp"

namespace multipath_localization {

/// A single-point position.
struct PointFix {
  Geodetic antenna;
  PseudorangeSolution solution;  ///< in the epoch's map; its covariance is that in the antenna's plane too
};

/// One epoch, corrected as seen from where the antenna is.
struct CorrectedEpoch {
  GnssTime time;
  std::vector<TrackedSatellite> satellites;        ///< above the mask
  std::vector<SatelliteObservation> observations;  ///< of them, in a map near the antenna
  std::optional<PointFix> plain;                   ///< least squares by declared weights
  std::optional<PointFix> robust;                  ///< robust_position
};

/// How epochs are corrected.
struct PositioningSettings {
  double elevation_mask = 0.0;             ///< [rad]
  std::set<Constellation> constellations;  ///< that are used
};

/// Corrects epoch after epoch. What the atmosphere takes and elevations depend on where the antenna is, to a
/// kilometre or so: that is the last robust fix, at first and after jumps one from the epoch itself, found
/// without corrections to begin with.
class PointPositioning {
 public:
  PointPositioning(const Navigation& navigation, const PositioningSettings& settings)
      : navigation_(navigation), settings_(settings) {}

  /// Nothing as long as no epoch has told where the antenna is, and without satellites above the mask.
  std::optional<CorrectedEpoch> correct(const RawEpoch& raw);

 private:
  [[nodiscard]] std::vector<TrackedSatellite> tracked(const RawEpoch& raw) const;
  /// Nothing unless it ends in a robust fix.
  [[nodiscard]] std::optional<CorrectedEpoch> cold_start(const std::vector<TrackedSatellite>& satellites,
                                                         const GnssTime& time) const;
  [[nodiscard]] CorrectedEpoch corrected(const std::vector<TrackedSatellite>& satellites,
                                         const GnssTime& time, const Geodetic& antenna) const;

  const Navigation& navigation_;
  PositioningSettings settings_;
  std::optional<Geodetic> antenna_;
};

}  // namespace multipath_localization
