#include "simulation/constellations.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

double radians(double degrees) { return degrees * kPi / 180.0; }

/// A constellation after Walker: planes of one inclination, nodes and satellites evenly spread.
struct Walker {
  Constellation constellation;
  int satellites;
  int planes;
  double radius;           // [m]
  double inclination_deg;  // against the equator
  double node_deg;         // longitude of the first plane's ascending node at time 0
};

constexpr Walker kGps = {Constellation::kGps, 31, 6, 26560e3, 55.0, 10.0};
constexpr Walker kGlonass = {Constellation::kGlonass, 24, 3, 25510e3, 64.8, 35.0};
constexpr Walker kGalileo = {Constellation::kGalileo, 24, 3, 29600e3, 56.0, 70.0};
constexpr Walker kBeidou = {Constellation::kBeidou, 24, 3, 27906e3, 55.0, 105.0};

/// Appends the satellites, numbered plane by plane in turn, their time 0 moved to `epoch`.
void append(const Walker& walker, double epoch, std::vector<Satellite>& all) {
  for (int i = 0; i < walker.satellites; ++i) {
    const int plane = i % walker.planes;
    const int slots = (walker.satellites - plane + walker.planes - 1) / walker.planes;
    const double node = radians(walker.node_deg + 360.0 * plane / walker.planes);
    const double phasing = 360.0 * plane / walker.satellites;
    const int slot = i / walker.planes;
    const double argument = radians(360.0 * slot / slots + phasing);
    const CircularOrbit orbit(walker.radius, radians(walker.inclination_deg), node, argument);
    all.push_back({walker.constellation, i + 1, orbit.from(epoch)});
  }
}

}  // namespace

void ConstellationParameters::fields(ParameterVisitor& field) {
  field("gps", gps, "31 satellites");
  field("glonass", glonass, "24 satellites");
  field("galileo", galileo, "24 satellites");
  field("beidou", beidou, "24 satellites in medium orbits");
  field("epoch", epoch, {-1e9, 1e9}, "s", "of the orbits when the simulation starts");
  field("epoch_spread", epoch_spread, {0.0, 1e9}, "s",
        "added to it at most, by seed; 86400: any time of the day");
}

CircularOrbit::CircularOrbit(double radius, double inclination, double node, double argument)
    : radius_(radius),
      inclination_(inclination),
      node_(node),
      argument_(argument),
      rate_(std::sqrt(kEarthGravitation / (radius * radius * radius))) {}

CircularOrbit CircularOrbit::from(double epoch) const {
  return {radius_, inclination_, node_ - kEarthRotationRate * epoch, argument_ + rate_ * epoch};
}

OrbitState CircularOrbit::at(double time) const {
  const Eigen::Matrix3d plane =
      (Eigen::AngleAxisd(node_ - kEarthRotationRate * time, Eigen::Vector3d::UnitZ()) *
       Eigen::AngleAxisd(inclination_, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  const double u = argument_ + rate_ * time;
  const Eigen::Vector3d position = plane * Eigen::Vector3d(std::cos(u), std::sin(u), 0.0) * radius_;
  const Eigen::Vector3d among_stars =
      plane * Eigen::Vector3d(-std::sin(u), std::cos(u), 0.0) * radius_ * rate_;
  return {position, among_stars - kEarthRotationRate * Eigen::Vector3d::UnitZ().cross(position)};
}

std::vector<Satellite> satellites(const ConstellationParameters& parameters, std::uint64_t seed) {
  RandomStream random(seed, 0, kConstellationStream);
  const double epoch = parameters.epoch + parameters.epoch_spread * random.uniform();
  std::vector<Satellite> all;
  if (parameters.gps) append(kGps, epoch, all);
  if (parameters.glonass) append(kGlonass, epoch, all);
  if (parameters.galileo) append(kGalileo, epoch, all);
  if (parameters.beidou) append(kBeidou, epoch, all);
  return all;
}

OrbitState at_transmission(const CircularOrbit& orbit, const LocalFrame& map, const Eigen::Vector3d& antenna,
                           double time) {
  constexpr int kIterations = 3;  // each leaves a hundred-thousandth of the error of flight time
  OrbitState state;
  double flight = 0.075;
  for (int i = 0; i < kIterations; ++i) {
    const OrbitState in_ecef = orbit.at(time - flight);
    state = {map.satellite_to_map(in_ecef.position),
             map.satellite_velocity_to_map(in_ecef.position, in_ecef.velocity)};
    flight = (state.position - antenna).norm() / kSpeedOfLight;
  }
  return state;
}

}  // namespace multipath_localization
