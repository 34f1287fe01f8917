// Tells from a bag of fixes and odometry how noisy a robot's sensors are, as parameters to load.

#include <boost/program_options.hpp>
#include <iostream>

#include "nodes/bag_drive.hpp"
#include "tools/tuning/tuning.hpp"

namespace multipath_localization {
namespace {

namespace po = boost::program_options;

po::options_description options_of(BagTopics& topics) {
  po::options_description options("What to tune by", 110);
  const auto add = [&](auto... arguments) { options.add_options()(arguments...); };
  add("bag", po::value<std::string>(), "a bag of some minutes of driving, part of it under open sky");
  add("fix-topic", po::value(&topics.fix), "of sensor_msgs/NavSatFix");
  add("odom-topic", po::value(&topics.odometry), "of nav_msgs/Odometry");
  add("help", "print this");
  return options;
}

int run(int argc, char** argv) {
  BagTopics topics;
  const po::options_description options = options_of(topics);
  po::variables_map given;
  po::store(po::parse_command_line(argc, argv, options), given);
  po::notify(given);
  if (given.count("help") > 0) {
    std::cout << options
              << "Prints YAML to load after config/robot.yaml; truth in the bag is not looked at.\n";
    return 0;
  }
  if (given.count("bag") == 0) throw std::runtime_error("--bag FILE is needed; --help says the rest");
  const auto file = given["bag"].as<std::string>();
  const Drive drive = read_bag(file, topics, std::nullopt);
  for (const std::string& notice : drive.notices) std::cerr << "tune_from_bag: " << notice << "\n";
  std::cout << "# tune_from_bag --bag " << file << "\n" << to_yaml(tune(drive));
  return 0;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  try {
    return multipath_localization::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "tune_from_bag: " << error.what() << "\n";
    return 2;
  }
}
