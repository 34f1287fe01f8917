#pragma once

#include <Eigen/Core>
#include <vector>

#include "multipath_localization/core/constellation.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// Which satellites there are and where they start.
struct ConstellationParameters {
  bool gps = true;
  bool glonass = true;
  bool galileo = true;
  bool beidou = true;
  double epoch = 0.0;
  double epoch_spread = 0.0;

  void fields(ParameterVisitor& field);
};

/// Position [m] and velocity [m/s] of a satellite. The frame is said where it is used.
struct OrbitState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
};

/// A circular orbit about the turning Earth, without perturbations.
class CircularOrbit {
 public:
  /// Of a radius [m] and an inclination against the equator [rad]. At time 0 the ascending node lies at the
  /// longitude `node` and the satellite stands `argument` beyond it along the orbit [rad].
  CircularOrbit(double radius, double inclination, double node, double argument);

  /// In ECEF, at a time [s].
  [[nodiscard]] OrbitState at(double time) const;

  /// The same orbit with time 0 moved to what was `epoch` [s].
  [[nodiscard]] CircularOrbit from(double epoch) const;

 private:
  double radius_;
  double inclination_;
  double node_;
  double argument_;
  double rate_;  ///< [rad/s]
};

struct Satellite {
  Constellation constellation = Constellation::kGps;
  int number = 1;  ///< within the constellation
  CircularOrbit orbit;
};

/// The satellites of the chosen constellations, evenly spread over the planes of each: 31 of GPS, 24 each of
/// GLONASS, Galileo and BeiDou (those in medium orbits). The seed chooses within the spread of the epoch.
std::vector<Satellite> satellites(const ConstellationParameters& parameters, std::uint64_t seed);

/// The satellite when it sent what arrives at an antenna in map (east, north, up [m]) at `time` [s]. In map,
/// the Earth's rotation during the flight undone, as in SatelliteObservation.
OrbitState at_transmission(const CircularOrbit& orbit, const LocalFrame& map, const Eigen::Vector3d& antenna,
                           double time);

}  // namespace multipath_localization
