// Runs estimators over a recorded drive, a bag or a simulated scenario and says how far off they were.

#include <algorithm>
#include <boost/program_options.hpp>
#include <fstream>
#include <iostream>
#include <sstream>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/evaluation/parallel.hpp"
#include "multipath_localization/evaluation/parameter_overrides.hpp"
#include "multipath_localization/evaluation/progress.hpp"
#include "multipath_localization/evaluation/report.hpp"
#include "multipath_localization/evaluation/runner.hpp"
#include "nodes/bag_drive.hpp"

namespace multipath_localization {
namespace {

namespace po = boost::program_options;

constexpr char kLocalizer[] = "localizer";

struct Options {
  std::string drive;
  std::string bag;
  BagTopics topics;
  std::optional<Geodetic> datum;
  std::vector<std::string> estimators;
  std::uint64_t seeds = 1;
  std::size_t jobs = 1;
  std::string json_file;
  double score_from = 0.0;
  bool known_start = false;
  std::vector<std::string> assignments;
};

/// What is wrong with the command line.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

Geodetic parse_datum(const std::string& text) {
  const std::vector<std::string> parts = split(text);
  try {
    const Geodetic datum{std::stod(parts.at(0)), std::stod(parts.at(1)),
                         parts.size() > 2 ? std::stod(parts[2]) : 0.0};
    if (parts.size() <= 3 && valid(datum)) return datum;
  } catch (const std::logic_error&) {
  }
  throw UsageError("--datum " + text + " is not LATITUDE,LONGITUDE[,ALTITUDE]");
}

po::options_description describe_options() {
  po::options_description description(
      "evaluate: run estimators over the same stream and score them against truth");
  auto add = description.add_options();
  add("drive", po::value<std::string>(), "directory with odometry.csv, fix.csv and truth.csv");
  add("bag", po::value<std::string>(), "bag with NavSatFix, Odometry and truth (PoseStamped or Odometry)");
  add("estimators", po::value<std::string>(),
      "names, separated by commas, or 'all'; the default estimator if left out");
  add("seeds", po::value<int>()->default_value(1), "run seeds 1..N");
  add("jobs", po::value<int>()->default_value(1), "runs at a time; changes no result");
  add("score-from", po::value<double>()->default_value(0.0),
      "seconds after the start from which truth is scored");
  add("known-start", "give the true pose at the start; unknown otherwise");
  add("set", po::value<std::vector<std::string>>()->composing(),
      "key=value: a parameter of every estimator run, or of one as NAME.key=value, or of the stream they are "
      "put on as "
      "localizer.key=value; nested by dots; may be repeated");
  add("json", po::value<std::string>(), "write the figures of each run to this file");
  add("fix-topic", po::value<std::string>()->default_value(""),
      "of the bag; else gps/fix, else the only NavSatFix");
  add("odom-topic", po::value<std::string>()->default_value(""),
      "of the bag; else odom, else the only Odometry");
  add("truth-topic", po::value<std::string>()->default_value(""),
      "of the bag; else truth, else nothing is scored");
  add("shadow-topic", po::value<std::string>()->default_value(""),
      "of the bag, Vector3Stamped with z = 1 where fixes are biased; else truth/bias if there");
  add("datum", po::value<std::string>(),
      "LATITUDE,LONGITUDE[,ALTITUDE] of the bag's truth frame in degrees; else where the median of fix - "
      "truth is zero, "
      "over the fixes in open sky if a shadow topic tells which those are, over all if not");
  add("help", "this text");
  return description;
}

Options read_options(const po::variables_map& given) {
  Options options;
  const auto text = [&](const char* key) { return given.count(key) > 0 ? given[key].as<std::string>() : ""; };
  options.drive = text("drive");
  options.bag = text("bag");
  if (given.count("drive") + given.count("bag") != 1) throw UsageError("give one of --drive, --bag");
  options.topics = {text("fix-topic"), text("odom-topic"), text("truth-topic"), text("shadow-topic")};
  if (given.count("datum") > 0) options.datum = parse_datum(text("datum"));
  options.estimators = split(text("estimators"));
  if (options.estimators.empty() && !estimator_names().empty()) options.estimators = {estimator_names().front()};
  if (text("estimators") == "all") options.estimators = estimator_names();
  const auto count = [&](const char* key) {
    if (given[key].as<int>() < 1) throw UsageError(std::string("--") + key + " is less than 1");
    return static_cast<std::size_t>(given[key].as<int>());
  };
  options.seeds = count("seeds");
  options.jobs = count("jobs");
  options.json_file = text("json");
  options.score_from = given["score-from"].as<double>();
  options.known_start = given.count("known-start") > 0;
  if (given.count("set") > 0) options.assignments = given["set"].as<std::vector<std::string>>();
  return options;
}

/// One run to be made, and what came of it.
struct Run {
  std::string estimator;
  std::string parameters;  ///< YAML as text: nodes are not for sharing between threads
  RunRecord record;
  std::vector<Epoch> epochs;
  std::string failure;  ///< empty when the run ended
};

std::vector<Run> plan(const Options& options, const ParameterOverrides& overrides) {
  for (const std::string& owner : overrides.owners()) {
    const auto& names = options.estimators;
    if (owner != kLocalizer && std::find(names.begin(), names.end(), owner) == names.end()) {
      throw UsageError("--set is for " + owner + ", which is not run");
    }
  }
  std::vector<Run> runs;
  for (const std::string& name : options.estimators) {
    const YAML::Node parameters = overrides.over(YAML::Node(), name);
    make_estimator(name, parameters, 1);
    for (std::uint64_t seed = 1; seed <= options.seeds; ++seed) {
      Run run;
      run.estimator = name;
      run.parameters = YAML::Dump(parameters);
      run.record = {options.drive + options.bag, name, seed, {}, 0.0};
      runs.push_back(run);
    }
  }
  return runs;
}

void make(Run& run, const Drive& drive, const RunSettings& settings, double score_from,
          const ProgressReport& progress) {
  const double started = thread_cpu_time();
  try {
    const auto factory = [&] {
      return make_estimator(run.estimator, YAML::Load(run.parameters), run.record.seed);
    };
    run.epochs = run_drive(drive, factory, settings, progress);
    run.record.score = score(run.epochs, score_from);
  } catch (const std::exception& error) {
    run.failure = error.what();
  }
  run.record.cpu = thread_cpu_time() - started;
}

void write_file(const std::string& file, const std::string& content) {
  std::ofstream out(file);
  out << content;
  if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

int evaluate(const Options& options) {
  std::vector<std::string> owners = estimator_names();
  owners.emplace_back(kLocalizer);
  const ParameterOverrides overrides(options.assignments, owners);
  RunSettings settings;
  load(overrides.of(kLocalizer), settings.localizer, kLocalizer);
  settings.known_start = options.known_start;
  std::vector<Run> runs = plan(options, overrides);

  const Drive drive =
      options.bag.empty() ? read_drive(options.drive) : read_bag(options.bag, options.topics, options.datum);
  for (const std::string& notice : drive.notices) std::cerr << drive.name << ": " << notice << "\n";
  const double score_from = drive.start() + options.score_from;
  {
    ProgressBar bar(runs.size());
    for_each_index(runs.size(), options.jobs, [&](std::size_t i) {
      make(runs[i], drive, settings, score_from, [&](double fraction) { bar.update(i, fraction); });
      bar.update(i, 1.0);
    });
  }

  std::vector<RunRecord> records;
  bool all_ended = true;
  for (const Run& run : runs) {
    if (run.failure.empty()) {
      records.push_back(run.record);
    } else {
      all_ended = false;
      std::cerr << run.estimator << ", seed " << run.record.seed << ": " << run.failure << "\n";
    }
  }
  if (!options.json_file.empty()) write_file(options.json_file, to_json(records));
  records.insert(records.begin(),
                 {drive.name, "(fixes as they are)", 1, score_fixes(drive, score_from), 0.0});
  std::cout << to_table(records);
  return all_ended ? 0 : 1;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  using namespace multipath_localization;
  try {
    const po::options_description description = describe_options();
    po::variables_map given;
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::parse_command_line(argc, argv, description, style), given);
    if (given.count("help") > 0) {
      std::cout << description;
      return 0;
    }
    return evaluate(read_options(given));
  } catch (const std::exception& error) {
    std::cerr << "evaluate: " << error.what() << "\n";
    return 2;
  }
}
