#include "multipath_localization/simulation/simulator.hpp"

namespace multipath_localization {

void BuildingParameters::fields(ParameterVisitor& field) {
  field("name", name, {}, "what to call it");
  field("corners", corners, {-1e6, 1e6}, "m", "x0, y0, x1, y1, ... in map");
  field("height", height, {0.0, 1e4}, "m", "above the ground");
}

void SimulatorParameters::fields(ParameterVisitor& field) {
  field("time_step", time_step, {1e-4, 1.0}, "s", "Delta of [NIS]");
  field("datum_latitude_deg", datum_latitude_deg, {-90.0, 90.0}, "deg", "origin of the map, north");
  field("datum_longitude_deg", datum_longitude_deg, {-180.0, 180.0}, "deg", "origin of the map, east");
  field("datum_altitude", datum_altitude, {-1e4, 1e5}, "m", "origin of the map, above the ellipsoid");
  field.group("robot", robot, "front-wheel steering, reference point in the middle of the rear axle");
  field.group("odometer", odometer, "wheel odometry and gyro");
  field.group("receiver", receiver, "GNSS receiver");
  field.list("zones", zones, "regions in the shadow of buildings; of overlapping ones the first counts");
  field.list("buildings", buildings, "drawn only");
  field.list("outages", outages, "intervals without fixes");
}

Simulator::Simulator(const SimulatorParameters& parameters, std::uint64_t seed)
    : parameters_(parameters),
      robot_(parameters.robot, seed),
      odometer_(parameters.odometer, seed),
      receiver_(parameters.receiver, parameters.outages, seed) {
  for (const ZoneParameters& zone : parameters_.zones) {
    zones_.emplace_back(zone, seed, static_cast<std::uint32_t>(zones_.size()));
  }
  for (const BuildingParameters& building : parameters_.buildings) {
    Polygon(building.corners, "building " + building.name);
  }
  reception_ = reception();
}

Reception Simulator::reception() const {
  const Eigen::Vector2d antenna = robot_.pose() * receiver_.antenna_in_base();
  for (const Zone& zone : zones_) {
    if (zone.depth(antenna) > 0.0) return {zone.bias(antenna), true};
  }
  return {};
}

Readings Simulator::step(const MotionCommand& u) {
  ++steps_;
  const double duration = parameters_.time_step;
  for (Zone& zone : zones_) zone.step(duration);
  robot_.step(u, duration);
  reception_ = reception();
  return {odometer_.step(robot_, time(), duration),
          receiver_.step(robot_.pose(), reception_, time(), duration)};
}

}  // namespace multipath_localization
