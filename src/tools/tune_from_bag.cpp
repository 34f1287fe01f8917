// Tells from a bag of fixes and odometry how noisy a robot's sensors are, as parameters to load.

#include <boost/program_options.hpp>
#include <iostream>

#include "multipath_localization/core/reason_tally.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "ros/bags/bag_drive.hpp"
#include "ros/messages/gnss_message.hpp"
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

/// What the localization node would do with the fixes, by what the reader left out and by their stamps.
ReasonTally fates_of_fixes(const Drive& drive) {
  ReasonTally fates = drive.left_out[kFixKind];
  const LocalizerParameters node;
  for (const RecordedMeasurement& recorded : drive.measurements) {
    if (recorded.measurement.index() != kFixKind) continue;
    const double late = recorded.arrival - stamp_of(recorded.measurement);
    fates.count(late > node.history_length      ? Reason::kOldStamp
                : late < -node.future_tolerance ? Reason::kFutureStamp
                                                : Reason::kAccepted);
  }
  return fates;
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
  const ReasonTally fates = fates_of_fixes(drive);
  if (fates.falls_short())
    std::cerr << "tune_from_bag: the node, of fixes: " << fates.explained_sum() << "\n";
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
