#pragma once

#include <string>

#include "evaluation/drive.hpp"

namespace multipath_localization {

/// Writes a drive as a bag that `read_bag` makes the same drive of: `odom`, `gps/fix`, `gps/left/fix` and
/// `gps/right/fix`, `gnss/epoch`, `truth` and where it says so `truth/bias`, with the antennas and, as earth
/// -> map, the datum on `tf_static`. Messages are recorded in the order of their arrival. ROS has no time
/// zero: the stamps of a drive that starts before 1 s are moved on by one second, which rounds intervals
/// otherwise and may tip an estimator's decision that hangs on the last bit. Throws DriveError.
void write_bag(const Drive& drive, const std::string& file);

}  // namespace multipath_localization
