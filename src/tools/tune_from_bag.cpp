// Measures the noise of a robot's sensors from a bag and prints parameters for localization_node.

#include <boost/program_options.hpp>
#include <iostream>

#include "nodes/bag_drive.hpp"
#include "tools/tune_from_bag/tuning.hpp"

namespace multipath_localization {
namespace {

namespace po = boost::program_options;

struct Request {
  std::string bag;
  BagTopics topics;
  double stretch = 60.0;
};

po::options_description options_of(Request& request) {
  po::options_description options("tune_from_bag FILE.bag [options] >> params.yaml", 110);
  const auto add = [&](auto... arguments) { options.add_options()(arguments...); };
  add("bag", po::value(&request.bag),
      "with NavSatFix and Odometry; drive under open sky, with turns and changes of speed");
  add("fix-topic", po::value(&request.topics.fix), "gps/fix, or the only NavSatFix");
  add("odom-topic", po::value(&request.topics.odometry), "odom, or the only Odometry");
  add("stretch", po::value(&request.stretch)->default_value(request.stretch),
      "length of the stretches that are looked at [s]");
  add("help", "print this");
  return options;
}

int tune(const Request& request) {
  if (request.stretch < 10.0) throw std::invalid_argument("--stretch is less than 10 s");
  const Drive drive = read_bag(request.bag, request.topics, std::nullopt);
  for (const std::string& notice : drive.notices) std::cerr << drive.name << ": " << notice << "\n";
  const SensorNoise noise = sensor_noise(drive, request.stretch);
  std::cout << tuning(noise, drive.name);
  return noise.fix ? 0 : 1;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  namespace ml = multipath_localization;
  try {
    ml::Request request;
    const auto description = ml::options_of(request);
    ml::po::positional_options_description positional;
    positional.add("bag", 1);
    ml::po::variables_map given;
    ml::po::store(ml::po::command_line_parser(argc, argv).options(description).positional(positional).run(),
                  given);
    ml::po::notify(given);
    if (given.count("help") > 0 || request.bag.empty()) {
      std::cout << description
                << "Exit status: 0 when there is something to print, 1 when the bag tells nothing, 2 on an "
                   "error.\n";
      return given.count("help") > 0 ? 0 : 2;
    }
    return ml::tune(request);
  } catch (const std::exception& error) {
    std::cerr << "tune_from_bag: " << error.what() << "\n";
    return 2;
  }
}
