#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "simulation/building.hpp"
#include "simulation/compass.hpp"
#include "simulation/constellations.hpp"
#include "simulation/dual_receiver.hpp"
#include "simulation/faults.hpp"
#include "simulation/ground.hpp"
#include "simulation/gyro.hpp"
#include "simulation/odometer.hpp"
#include "simulation/raw_receiver.hpp"
#include "simulation/receiver.hpp"
#include "simulation/robot.hpp"
#include "simulation/satellite_receiver.hpp"
#include "simulation/second_receiver.hpp"
#include "simulation/sky_view.hpp"
#include "simulation/velocity_receiver.hpp"
#include "simulation/zone.hpp"

namespace multipath_localization {

struct SimulatorParameters {
  double time_step = 0.01;
  double datum_latitude_deg = 33.894;
  double datum_longitude_deg = 130.839;
  double datum_altitude = 30.0;
  RobotParameters robot;
  GroundParameters ground;
  OdometerParameters odometer;
  ReceiverParameters receiver;
  SecondReceiverParameters second_receiver;
  DualReceiverParameters dual_receiver;
  GyroParameters gyro;
  CompassParameters compass;
  VelocityReceiverParameters velocity;
  ConstellationParameters constellations;
  SkyParameters sky;
  RawReceiverParameters raw_receiver;
  std::vector<ZoneParameters> zones;
  std::vector<BuildingParameters> buildings;
  std::vector<OutageParameters> outages;
  FaultParameters faults;

  void fields(ParameterVisitor& field);
  [[nodiscard]] Geodetic datum() const { return {datum_latitude_deg, datum_longitude_deg, datum_altitude}; }
};

/// What the sensors deliver at the end of one step.
struct Readings {
  std::vector<YawRate> yaw_rates;  ///< of a gyro beside the odometry
  std::optional<OdometryIncrement> odometry;
  std::vector<Measurement> measurements;  ///< stamped when measured, delivered a latency later
};

/// A robot with odometer, gyro and GNSS receivers among buildings. Time starts at 0. Deterministic: the same
/// parameters, seed and commands give the same bytes.
class Simulator {
 public:
  /// Throws ParameterError on a polygon of fewer than three corners, a wrong number of noise constants or an
  /// error of poses that is none.
  Simulator(const SimulatorParameters& parameters, std::uint64_t seed);

  /// Moves on by one time step under a command (not finite: a stop).
  Readings step(const MotionCommand& u);

  [[nodiscard]] double time() const { return static_cast<double>(steps_) * parameters_.time_step; }  ///< [s]
  [[nodiscard]] double time_step() const { return parameters_.time_step; }                           ///< [s]
  [[nodiscard]] const Pose2& truth() const { return robot_.pose(); }             ///< base in map
  [[nodiscard]] double speed() const { return robot_.speed(); }                  ///< true [m/s]
  [[nodiscard]] double yaw_rate() const { return robot_.yaw_rate(); }            ///< true [rad/s]
  [[nodiscard]] double lateral_speed() const { return robot_.lateral_speed(); }  ///< true, to the left [m/s]
  /// Of a fix taken now; by satellites the bias is the error of the last fix, and a shadow is where those in
  /// line of sight are not the majority of those received.
  [[nodiscard]] const Reception& around() const { return reception_; }
  /// The NavSatStatus that a fix of that stamp claims, where a fault makes it lie.
  [[nodiscard]] std::optional<int> claimed_status(double stamp) const { return fix_faults_.status(stamp); }
  [[nodiscard]] const SimulatorParameters& parameters() const { return parameters_; }

 private:
  std::vector<Measurement> receive(double duration);
  std::vector<Measurement> spoilt(const std::vector<Measurement>& delivered);
  std::vector<GnssVelocity> velocities(double duration);

  SimulatorParameters parameters_;
  std::int64_t steps_ = 0;
  Robot robot_;
  Odometer odometer_;
  SecondReceiver second_receiver_;
  DualReceiver dual_receiver_;
  Zones zones_;
  std::optional<SatelliteReceiver> satellite_receiver_;
  Receiver receiver_;
  FixFaults fix_faults_;
  OdometryFaults odometry_faults_;
  Gyro gyro_;
  Compass compass_;
  VelocityReceiver velocity_receiver_;
  Reception reception_;
};

}  // namespace multipath_localization
