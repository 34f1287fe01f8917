#pragma once

#include "tools/doctor/finding.hpp"
#include "tools/doctor/observations.hpp"

namespace multipath_localization {

/// Whether both topics are there, under the names the node expects and of the types it reads.
Findings check_topics(const Observations& seen);
/// Whether there are enough messages a second, without long gaps.
Findings check_rates(const Observations& seen);
/// Stamps of zero, twice the same or going back.
Findings check_stamps(const Observations& seen);
/// Stamps against when the messages came in: the receiver's clock, the host's, latency.
Findings check_clocks(const Observations& seen);
/// /use_sim_time and /clock.
Findings check_simulated_time(const Observations& seen);

/// Frames of the messages against those of the node.
Findings check_frames(const Observations& seen);
/// A frame with two parents, or a transform from two nodes.
Findings check_parents(const Observations& seen);
/// map -> odom of somebody else, live or recorded.
Findings check_map_to_odom(const Observations& seen);
/// Where the antenna is: known, near, not turned.
Findings check_antenna(const Observations& seen);

/// Status of the fixes.
Findings check_status(const Observations& seen);
/// Places that are nonsense: 0, 0, not finite, out of range, or far from the others.
Findings check_places(const Observations& seen);
/// Fixes that leap there and back, as those of two receivers do.
Findings check_leaps(const Observations& seen);
/// Declared covariances: zero, unknown, not finite, huge.
Findings check_declared_covariance(const Observations& seen);
/// Declared standard deviation against the scatter of the fixes about the odometry.
Findings check_scatter(const Observations& seen);
/// The same place to the bit while the robot drove.
Findings check_frozen(const Observations& seen);
/// A datum that is rounded or far away.
Findings check_datum(const Observations& seen);

/// Twist of the odometry against the differences of its poses: empty, frame, motion sideways, sign, scale;
/// the fixes say which of the two is wrong.
Findings check_twist(const Observations& seen);
/// Latitude and longitude that are swapped, or no degrees, by the way of odometry.
Findings check_coordinates(const Observations& seen);
/// Curves of odometry against those of the fixes: mirrored, or NED.
Findings check_turns(const Observations& seen);
/// Way by odometry against way by fixes: scale, where the two have the same shape.
Findings check_scale(const Observations& seen);
/// These three: the way of fixes that are misread tells nothing of odometry.
Findings check_way(const Observations& seen);

/// An IMU, where there is one: whether it has a gyro, how it is mounted, whether it turns as odometry does.
Findings check_gyro(const Observations& seen);
/// A receiver's velocities, where there are any: against how the fixes go on.
Findings check_velocity(const Observations& seen);
/// A compass or two antennas, where there are any: against where the fixes and odometry go.
Findings check_heading(const Observations& seen);

/// All of them, in this order.
Findings diagnose(const Observations& seen);

}  // namespace multipath_localization
