#pragma once

#include <string>
#include <vector>

#include "evaluation/drive.hpp"

namespace multipath_localization {

/// Writes odometry, fixes, truth and, where there are any, yaw rates, velocities and headings of a drive into
/// a directory, which is made: `odometry.csv` with a column `duration`, `fix.csv` with `status` and the lever
/// arm, of further receivers `fix_2.csv` and so on, `truth.csv` with `yaw` and, where it is known, `shadow`,
/// `gyro.csv`, `velocity.csv`, `heading.csv`. `read_drive` gives the same drive back, in a map frame whose
/// datum is the first fix. Other measurements are not written. Throws DriveError.
void write_drive(const Drive& drive, const std::string& directory);

/// The recordings of a directory, by name.
struct FoundDrives {
  std::vector<Drive> drives;
  std::vector<std::string> left_out;  ///< "NAME: why", of each of its directories that is none
};

/// Reads every drive of a directory that has `truth.csv`, `fix.csv` and `odometry.csv` and goes on past
/// `score_from` [s], of each the fixes and, where they are there, velocities and yaw rates: pseudoranges
/// beside them are left aside. Throws DriveError when
/// there is none.
FoundDrives read_drives(const std::string& directory, double score_from);

}  // namespace multipath_localization
