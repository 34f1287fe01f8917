#pragma once

#include <geometry_msgs/TwistWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "ros/inputs/odometry_reader.hpp"
#include "ros/map/datum_parameter.hpp"
#include "simulation/delivery_queue.hpp"
#include "simulation/faults.hpp"

namespace multipath_localization {

/// Parameters of fault_injector_node, and what `evaluate --faults` reads.
struct FaultInjectorParameters {
  int seed = 1;
  DatumParameter datum;
  FaultParameters faults;

  /// Throws ParameterError on a datum that cannot be used.
  void fields(ParameterVisitor& field);
};

/// Spoils messages between sensors and whoever uses them. It lives by the stamps alone, the latest of which
/// is now: the same messages in the same order give the same bytes. Time counts from the first stamp; a clock
/// that goes back by more than a second starts everything afresh. Messages that no reader would take go
/// through as they are, and so does what no fault changes.
class FaultInjector {
 public:
  explicit FaultInjector(const FaultInjectorParameters& parameters) : parameters_(parameters) {}

  /// What of the fixes comes out now that this one has come in. A position that a fault changes keeps its
  /// altitude.
  std::vector<sensor_msgs::NavSatFix> take(const sensor_msgs::NavSatFix& fix);

  /// The odometry as it comes out, nothing when it is lost; `fixes` are those that come out by its stamp. The
  /// pose is that which the spoilt motion adds up to; messages get lost after it was counted.
  std::optional<nav_msgs::Odometry> take(const nav_msgs::Odometry& odometry,
                                         std::vector<sensor_msgs::NavSatFix>& fixes);

  /// The IMU's messages, or the receiver's velocities, that come out now that this one has come in.
  std::vector<sensor_msgs::Imu> take(const sensor_msgs::Imu& imu);
  std::vector<geometry_msgs::TwistWithCovarianceStamped> take(
      const geometry_msgs::TwistWithCovarianceStamped& velocity);

  /// The same of the headings.
  std::vector<sensor_msgs::Imu> take_heading(const sensor_msgs::Imu& heading);

  /// A line for each fault that is there now, "none" for none.
  [[nodiscard]] std::string active() const;

 private:
  /// Starts afresh or moves on.
  void see(double stamp, bool restarted);
  void begin(double stamp);
  std::vector<sensor_msgs::NavSatFix> release();
  [[nodiscard]] sensor_msgs::NavSatFix message_of(const SpoiltFix& spoilt) const;
  [[nodiscard]] nav_msgs::Odometry message_of(const nav_msgs::Odometry& odometry,
                                              const CheckedOdometry& checked);

  FaultInjectorParameters parameters_;
  std::optional<FixFaults> fix_faults_;
  std::optional<OdometryFaults> odometry_faults_;
  std::optional<SensorFaults> gyro_faults_;
  std::optional<SensorFaults> velocity_faults_;
  std::optional<SensorFaults> heading_faults_;
  DeliveryQueue<sensor_msgs::Imu> imus_;
  DeliveryQueue<sensor_msgs::Imu> headings_;
  DeliveryQueue<geometry_msgs::TwistWithCovarianceStamped> velocities_;
  OdometryReader reader_{{}, ""};
  std::optional<LocalFrame> map_;
  double now_ = 0.0;
  double last_fix_ = 0.0;                                      ///< stamp [s]
  std::size_t taken_ = 0;                                      ///< fixes given to the faults
  std::map<std::size_t, sensor_msgs::NavSatFix> taken_fixes_;  ///< those that are still needed
  Pose2 last_in_odom_;                                         ///< as it came in
  std::optional<Pose2> spoilt_in_odom_;                        ///< as it came out, once that differs
};

}  // namespace multipath_localization
