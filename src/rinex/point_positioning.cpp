#include "rinex/point_positioning.hpp"

#include "multipath_localization/models/pseudorange/robust_position.hpp"

namespace multipath_localization {

namespace {

constexpr double kNear = 1e3;        // [m]
constexpr double kLowestFix = -1e4;  // over the ellipsoid [m]
constexpr double kHighestFix = 1e5;

bool on_earth(const Geodetic& antenna) {
  return antenna.altitude > kLowestFix && antenna.altitude < kHighestFix && valid(antenna);
}

std::optional<PointFix> located(const LocalFrame& map, const std::optional<PseudorangeSolution>& solution) {
  if (!solution) return std::nullopt;
  const Eigen::Vector3d& position = solution->position;
  const PointFix fix{map.to_geodetic(position.head<2>(), position.z()), *solution};
  return on_earth(fix.antenna) ? std::optional(fix) : std::nullopt;
}

/// Where nothing is known: without atmosphere, all satellites alike.
std::optional<Geodetic> rough_position(const std::vector<TrackedSatellite>& satellites) {
  const LocalFrame anywhere(Geodetic{});
  std::vector<SatelliteObservation> observations;
  for (const TrackedSatellite& tracked : satellites) {
    SatelliteObservation observation;
    observation.constellation = tracked.satellite.constellation;
    observation.position = anywhere.satellite_to_map(tracked.at_transmission.position);
    observation.pseudorange = tracked.pseudorange;
    observations.push_back(observation);
  }
  const std::optional<Geodetic> antenna = solve_geodetic(observations, anywhere);
  return antenna && on_earth(*antenna) ? antenna : std::nullopt;
}

bool far_from_origin(const std::optional<PointFix>& fix) {
  return !fix || fix->solution.position.norm() > kNear;
}

}  // namespace

std::optional<CorrectedEpoch> PointPositioning::correct(const RawEpoch& raw) {
  const std::vector<TrackedSatellite> satellites = tracked(raw);
  if (satellites.empty()) return std::nullopt;
  std::optional<CorrectedEpoch> epoch;
  if (antenna_) epoch = corrected(satellites, raw.time, *antenna_);
  if (!epoch || far_from_origin(epoch->robust)) {
    const std::optional<CorrectedEpoch> anew = cold_start(satellites, raw.time);
    if (anew) epoch = anew;
  }
  if (!epoch || epoch->satellites.empty()) return std::nullopt;
  if (epoch->robust) antenna_ = epoch->robust->antenna;
  return epoch;
}

std::vector<TrackedSatellite> PointPositioning::tracked(const RawEpoch& raw) const {
  std::vector<TrackedSatellite> all;
  for (const RawObservation& observation : raw.observations) {
    if (settings_.constellations.count(observation.satellite.constellation) == 0) continue;
    const auto satellite = track(observation, raw.time, navigation_.ephemerides);
    if (satellite) all.push_back(*satellite);
  }
  return all;
}

std::optional<CorrectedEpoch> PointPositioning::cold_start(const std::vector<TrackedSatellite>& satellites,
                                                           const GnssTime& time) const {
  const std::optional<Geodetic> rough = rough_position(satellites);
  if (!rough) return std::nullopt;
  const CorrectedEpoch nearer = corrected(satellites, time, *rough);
  if (!nearer.robust) return std::nullopt;
  CorrectedEpoch epoch = corrected(satellites, time, nearer.robust->antenna);
  return epoch.robust ? std::optional(epoch) : std::nullopt;
}

CorrectedEpoch PointPositioning::corrected(const std::vector<TrackedSatellite>& satellites,
                                           const GnssTime& time, const Geodetic& antenna) const {
  const LocalFrame map(antenna);
  CorrectedEpoch epoch;
  epoch.time = time;
  for (const TrackedSatellite& tracked : satellites) {
    const SatelliteObservation seen = seen_from(map, tracked, time, navigation_.ionosphere);
    if (seen.elevation < settings_.elevation_mask) continue;
    epoch.satellites.push_back(tracked);
    epoch.observations.push_back(seen);
  }
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  epoch.plain =
      located(map, solve_position(epoch.observations, declared_weights(epoch.observations), origin));
  epoch.robust = located(map, robust_position(epoch.observations, origin));
  return epoch;
}

}  // namespace multipath_localization
