#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "evaluation/batch.hpp"
#include "evaluation/random_drive.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "ros/bags/bag_topics.hpp"

namespace multipath_localization {

constexpr char kRandomSuite[] = "random";   ///< the suite of random robots
constexpr char kDrivesSuite[] = "drives:";  ///< before the directory of a suite of recordings

/// The command line of `evaluate`.
struct Options {
  std::string drive;
  std::string bag;
  std::string scenario;
  std::string suite;
  BagTopics topics;
  std::optional<Geodetic> datum;
  Batch batch;
  std::vector<std::string> assignments;
  std::string faults_file;
  std::string json_file;
  std::string plot_file;
  std::string report_file;
  std::string write_directory;
  std::vector<std::string> results_files;
  RandomExtras extras;
  RandomExtras left_aside;

  /// Whether the suite is made of many drives that are summed up, instead of scenarios.
  [[nodiscard]] bool over_drives() const;
  /// Whether nothing is to be run, but told what files of results hold.
  [[nodiscard]] bool sums_up() const { return suite.empty() && !results_files.empty(); }
  /// The directory of a suite of recordings; empty for others.
  [[nodiscard]] std::string drives_directory() const;
};

/// What is wrong with the command line.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Throws UsageError, or ParameterError on estimators that cannot be read.
Options read_options(const boost::program_options::variables_map& given);

}  // namespace multipath_localization
