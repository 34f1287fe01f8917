#include <cstdio>

#include "ros/gnss_epoch_node/gnss_epoch_node.hpp"
#include "ros/parameters/parameter_server.hpp"

namespace {

/// For a launch file that has to tell localization_node where the drive's map is.
int print_datum(const std::string& directory) {
  const multipath_localization::Geodetic datum = multipath_localization::read_drive(directory).datum;
  std::printf("[%.10f, %.10f, 0.0, %.4f]\n", datum.latitude_deg, datum.longitude_deg, datum.altitude);
  return 0;
}

int play(int argc, char** argv) {
  ros::init(argc, argv, "gnss_epoch");
  multipath_localization::GnssEpochNodeParameters parameters;
  load(multipath_localization::read_parameters(ros::NodeHandle("~")), parameters);
  const multipath_localization::GnssEpochNode node(ros::NodeHandle(), parameters);
  ros::spin();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const bool asks_for_datum = argc == 3 && std::string(argv[1]) == "--datum";
    return asks_for_datum ? print_datum(argv[2]) : play(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gnss_epoch_node: %s\n", error.what());
    return 1;
  }
}
