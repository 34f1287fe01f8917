#include "simulation/simulator.hpp"

#include <utility>

namespace multipath_localization {

namespace {

/// The receiver's, on the base as levelled at that place in map [m].
Eigen::Vector2d antenna_at(const Pose2& base_in_map, const SimulatorParameters& parameters) {
  const ReceiverParameters& receiver = parameters.receiver;
  const Tilt tilt = parameters.ground.tilt(base_in_map);
  return levelled(tilt, {receiver.antenna_x, receiver.antenna_y, receiver.antenna_z});
}

}  // namespace

void SimulatorParameters::fields(ParameterVisitor& field) {
  field("time_step", time_step, {1e-4, 1.0}, "s", "Delta of [NIS]");
  field("datum_latitude_deg", datum_latitude_deg, {-90.0, 90.0}, "deg", "origin of the map, north");
  field("datum_longitude_deg", datum_longitude_deg, {-180.0, 180.0}, "deg", "origin of the map, east");
  field("datum_altitude", datum_altitude, {-1e4, 1e5}, "m", "origin of the map, above the ellipsoid");
  field.group("robot", robot, "reference point in the middle of the rear or of the driven axle");
  field.group("ground", ground, "slopes: the robot drives at its speed over the map");
  field.group("odometer", odometer, "wheel odometry and gyro");
  field.group("receiver", receiver, "GNSS receiver");
  field.group("second_receiver", second_receiver, "another GNSS receiver, beside the first one");
  field.group("dual_receiver", dual_receiver, "a pair of RTK receivers, to tell the heading too");
  field.group("gyro", gyro, "a gyro beside the odometry");
  field.group("compass", compass, "what tells the heading: a compass or two antennas");
  field.group("velocity", velocity, "velocities by Doppler, of the antenna of `receiver`");
  field.group("constellations", constellations, "satellites: those that fly");
  field.group("sky", sky, "satellites: how their signals spread among the buildings");
  field.group("raw_receiver", raw_receiver, "satellites: how the receiver tracks them");
  field.list("zones", zones, "regions in the shadow of buildings; of overlapping ones the first counts");
  field.list("buildings", buildings, "drawn; they stand in the way of satellites");
  field.list("outages", outages, "intervals without fixes");
  field.group("faults", faults, "what goes wrong between sensors and whoever uses them");
}

Simulator::Simulator(const SimulatorParameters& parameters, std::uint64_t seed)
    : parameters_(parameters),
      robot_(parameters.robot, seed),
      odometer_(parameters.odometer, seed),
      second_receiver_(parameters.second_receiver, parameters.outages, seed),
      dual_receiver_(parameters.dual_receiver, parameters.outages, seed),
      zones_(parameters.zones, seed),
      receiver_(parameters.receiver, parameters.outages, seed),
      fix_faults_(parameters.faults.fix, seed),
      odometry_faults_(parameters.faults.odometry, seed),
      gyro_(parameters.gyro, parameters.faults.gyro, seed),
      compass_(parameters.compass, parameters.faults.heading, seed),
      velocity_receiver_(parameters.velocity, parameters.faults.velocity, seed) {
  for (const BuildingParameters& building : parameters_.buildings) {
    Polygon(building.corners, "building " + building.name);
  }
  if (parameters_.receiver.source == ReceiverSource::kSatellites) {
    SkyView sky(parameters_.sky, parameters_.buildings, seed);
    RawReceiver raw(parameters_.raw_receiver, satellites(parameters_.constellations, seed), std::move(sky),
                    LocalFrame(parameters_.datum()), seed);
    satellite_receiver_.emplace(parameters_.receiver, parameters_.outages, std::move(raw), seed);
  } else {
    reception_ = zones_.around(robot_.pose() * antenna_at(robot_.pose(), parameters_));
  }
}

std::vector<Measurement> Simulator::receive(double duration) {
  if (satellite_receiver_) {
    std::vector<Measurement> delivered = satellite_receiver_->step(robot_, time());
    reception_ = satellite_receiver_->reception();
    return delivered;
  }
  const Eigen::Vector2d antenna_in_map = robot_.pose() * antenna_at(robot_.pose(), parameters_);
  reception_ = zones_.around(antenna_in_map);
  const std::vector<GnssFix> fixes = receiver_.step(antenna_in_map, reception_, time(), duration);
  return {fixes.begin(), fixes.end()};
}

std::vector<Measurement> Simulator::spoilt(const std::vector<Measurement>& delivered) {
  std::vector<Measurement> measurements;
  const auto release = [&] {
    for (const SpoiltFix& out : fix_faults_.release(time())) measurements.emplace_back(out.fix);
  };
  release();
  for (const Measurement& measurement : delivered) {
    if (const auto* fix = std::get_if<GnssFix>(&measurement)) {
      fix_faults_.take(*fix, time());
      release();
    } else {
      measurements.push_back(measurement);
    }
  }
  return measurements;
}

std::vector<GnssVelocity> Simulator::velocities(double duration) {
  const Eigen::Vector2d lever = antenna_at(robot_.pose(), parameters_);
  const Eigen::Vector2d swing = robot_.yaw_rate() * Eigen::Vector2d(-lever.y(), lever.x());
  const Eigen::Vector2d velocity =
      rotation(robot_.pose().yaw) * (Eigen::Vector2d(robot_.speed(), robot_.lateral_speed()) + swing);
  std::vector<GnssVelocity> received;
  for (GnssVelocity read : velocity_receiver_.step(velocity, reception_.in_shadow, time(), duration)) {
    if (outage_at(parameters_.outages, read.stamp)) continue;
    read.antenna_in_base = receiver_.antenna_in_base();
    received.push_back(read);
  }
  return received;
}

Readings Simulator::step(const MotionCommand& u) {
  ++steps_;
  const double duration = parameters_.time_step;
  zones_.step(duration);
  robot_.step(u, duration);
  Readings readings;
  readings.yaw_rates = gyro_.step(robot_.yaw_rate(), time());
  if (const auto level = odometer_.step(robot_, time(), duration)) {
    readings.odometry = odometry_faults_.spoil(along_ground(parameters_.ground.tilt(robot_.pose()), *level));
  }
  readings.measurements = spoilt(receive(duration));
  for (const GnssFix& fix : second_receiver_.step(robot_.pose(), time(), duration)) {
    readings.measurements.emplace_back(fix);
  }
  const auto bias_at = [this](const Eigen::Vector2d& point) { return zones_.around(point).bias; };
  for (const DualAntennaFix& fixes : dual_receiver_.step(robot_.pose(), bias_at, time())) {
    readings.measurements.emplace_back(fixes);
  }
  for (const Heading& heading : compass_.step(robot_.pose().yaw, time())) {
    readings.measurements.emplace_back(heading);
  }
  for (const GnssVelocity& velocity : velocities(duration)) readings.measurements.emplace_back(velocity);
  return readings;
}

}  // namespace multipath_localization
