// Writes the recording of a drive directory as a bag: for rosbag play, bag.launch and evaluate --bag.

#include <cstdio>
#include <iostream>

#include "evaluation/drive.hpp"
#include "ros/bags/bag_writer.hpp"

int main(int argc, char** argv) {
  using namespace multipath_localization;
  const std::string first = argc > 1 ? argv[1] : "";
  if (argc != 3 || first == "--help") {
    std::ostream& out = first == "--help" ? std::cout : std::cerr;
    out << "usage: drive_to_bag DRIVE_DIR OUT.bag\n\n"
           "Writes a drive directory (odometry.csv, truth.csv, fix.csv or pseudoranges.csv or both) as a "
           "bag:\n"
           "odom, gps/fix, gnss/epoch, truth; truth's datum as the static transform earth -> map.\n";
    return first == "--help" ? 0 : 2;
  }
  try {
    const Drive drive = read_drive(first);
    write_bag(drive, argv[2]);
    const Geodetic& datum = drive.datum;
    std::printf("%s: %zu odometry, %zu measurements, %zu truth; datum [%.9f, %.9f, %.3f]\n", argv[2],
                drive.odometry.size(), drive.measurements.size(), drive.truth.size(), datum.latitude_deg,
                datum.longitude_deg, datum.altitude);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "drive_to_bag: " << error.what() << "\n";
    return 2;
  }
}
