#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/TwistWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ros/localization_node/localization_parameters.hpp"
#include "tools/doctor/odometry_track.hpp"

namespace multipath_localization {

/// A message and when it came in.
template <class Message>
struct Arrived {
  Message message;
  double time = 0.0;  ///< on the host's clock, or the bag's [s]
};

/// A transform and the node that broadcast it.
struct Broadcast {
  geometry_msgs::TransformStamped transform;
  std::string node;
  bool is_static = false;
};

/// What was seen of a robot, live or in a bag.
struct Observations {
  std::string fix_topic = "gps/fix";
  std::string odometry_topic = "odom";
  std::string imu_topic = "imu/data";
  std::string velocity_topic = "gps/velocity";
  std::string heading_topic = "heading";
  FrameParameters frames;
  std::map<std::string, std::string> types;  ///< of all topics, by name without leading slash
  /// Types of topics of a bag whose messages cannot be read, being of another version of it.
  std::map<std::string, std::string> other_versions;
  std::vector<Arrived<sensor_msgs::NavSatFix>> fixes;
  std::vector<Arrived<nav_msgs::Odometry>> odometry;
  std::vector<Arrived<sensor_msgs::Imu>> imus;
  std::vector<Arrived<geometry_msgs::TwistWithCovarianceStamped>> velocities;
  std::vector<Arrived<sensor_msgs::Imu>> headings;
  std::vector<Broadcast> transforms;
  std::vector<double> datum;    ///< of the parameters, or saved in their datum_file; empty for none
  std::string datum_file;       ///< where it was saved, empty where it is one of the parameters
  std::vector<double> antenna;  ///< of the parameters, empty for none
  FixParameters fix_parameters;
  OdometryParameters odometry_parameters;
  LocalizerParameters localizer_parameters;
  bool from_bag = true;
  bool use_sim_time = false;  ///< live: the parameter /use_sim_time
  bool clock = false;         ///< somebody publishes /clock, or it was recorded
};

/// The datum that the node would find by the usable fixes (DatumSearch), or the first of them where no three
/// agree; nothing where there are none.
std::optional<Geodetic> place_of_fixes(const Observations& seen);

/// The usable fixes in a map with that origin, antenna at the base, and the usable odometry, as the
/// localization node reads them.
struct Motion {
  std::vector<GnssFix> fixes;
  std::vector<OdometryIncrement> increments;
  OdometryTrack track;
};
/// What of the odometry is read: both as the node does, or its poses or its twist alone.
enum class Voice { kBoth, kPoses, kTwist };
Motion motion_of(const Observations& seen, Voice voice = Voice::kBoth);

/// The name `asked` if there is such a topic, else the only topic of that type that is not the output of a
/// localisation, else `asked`.
std::string resolved(const std::map<std::string, std::string>& types, const std::string& asked,
                     const std::string& type);

}  // namespace multipath_localization
