#include "tools/evaluate/command_line.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "multipath_localization/estimators/make_estimator.hpp"

namespace multipath_localization {

namespace {

namespace po = boost::program_options;

constexpr double kSettled = 60.0;  ///< drives of a suite are scored from then on [s]
constexpr std::uint64_t kLargestSeed = 1000000000;

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

std::vector<EstimatorVariant> chosen(const std::string& list, bool over_drives) {
  if (list.empty()) {
    return parse_variants(estimator_names().front() + (over_drives ? ",gated_ekf,two_stage_ekf" : ""));
  }
  if (list != "all") return parse_variants(list);
  std::vector<EstimatorVariant> all;
  for (const std::string& name : estimator_names()) all.push_back({name, name, ""});
  return all;
}

std::uint64_t parse_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc() && rest == end && seed >= 1 && seed <= kLargestSeed) return seed;
  throw UsageError("--seeds: '" + text + "' is not a number from 1 to " + std::to_string(kLargestSeed));
}

/// N for the seeds 1..N, or FIRST..LAST.
void read_seeds(const std::string& text, Batch& batch) {
  const std::size_t dots = text.find("..");
  batch.first_seed = dots == std::string::npos ? 1 : parse_seed(text.substr(0, dots));
  const std::uint64_t last = parse_seed(dots == std::string::npos ? text : text.substr(dots + 2));
  if (last < batch.first_seed) throw UsageError("--seeds " + text + " ends before it begins");
  batch.seeds = last - batch.first_seed + 1;
}

/// A list of inputs beside odometry and fixes.
RandomExtras parse_extras(const std::string& list) {
  RandomExtras extras;
  for (const std::string& name : split(list)) {
    const auto* const extra = std::find_if(kExtras.begin(), kExtras.end(),
                                           [&](const NamedExtra& known) { return known.name == name; });
    if (extra == kExtras.end())
      throw UsageError(name + " is none of gyro, velocity, receivers, heading, levels");
    extras.*extra->given = true;
  }
  return extras;
}

/// One stream, or results of runs.
void require_a_stream(const po::variables_map& given, const Options& options) {
  const std::size_t streams =
      given.count("drive") + given.count("bag") + given.count("scenario") + given.count("suite");
  if (streams > 1 || (streams == 0 && options.results_files.empty())) {
    throw UsageError(
        "give one of --drive, --bag, --scenario, --suite, or --results alone; --help tells more");
  }
}

/// What a suite over drives cannot be told.
void refuse_for_suites(const po::variables_map& given, const Options& options) {
  if (!options.suite.empty() && given.count("plot") + given.count("report") + given.count("faults") > 0) {
    throw UsageError("--plot, --report and --faults are for one stream, not for a suite");
  }
  if (options.suite != kRandomSuite && given.count("write") + given.count("with") > 0) {
    throw UsageError("--write and --with are for --suite random");
  }
  if (options.suite == kRandomSuite && given.count("known-start") > 0) {
    throw UsageError("--known-start: random robots start nowhere in particular");
  }
  const bool one_stream = given.count("drive") + given.count("bag") + given.count("scenario") > 0;
  if ((one_stream || (!options.suite.empty() && options.suite != kRandomSuite)) &&
      !options.results_files.empty()) {
    throw UsageError("--results is for --suite random, or alone");
  }
  if (options.suite == kRandomSuite && options.results_files.size() > 1) {
    throw UsageError("--suite random keeps its runs in one file of results");
  }
}

}  // namespace

bool Options::over_drives() const { return suite == kRandomSuite || !drives_directory().empty(); }

std::string Options::drives_directory() const {
  const std::string prefix = kDrivesSuite;
  return suite.rfind(prefix, 0) == 0 ? suite.substr(prefix.size()) : "";
}

Options read_options(const po::variables_map& given) {
  const auto text = [&](const char* key) { return given.count(key) > 0 ? given[key].as<std::string>() : ""; };
  const auto count = [&](const char* key) {
    if (given[key].as<int>() < 1) throw UsageError(std::string("--") + key + " is less than 1");
    return static_cast<std::size_t>(given[key].as<int>());
  };
  Options options;
  if (given.count("results") > 0) options.results_files = given["results"].as<std::vector<std::string>>();
  require_a_stream(given, options);
  options.drive = text("drive");
  options.bag = text("bag");
  options.scenario = text("scenario");
  options.suite = text("suite");
  std::vector<std::string> fixes = split(text("fix-topic"));
  if (fixes.empty()) fixes.emplace_back();
  options.topics = {fixes.front(),         text("odom-topic"),  text("truth-topic"),
                    text("shadow-topic"),  text("epoch-topic"), text("left-topic"),
                    text("right-topic"),   text("imu-topic"),   text("velocity-topic"),
                    text("heading-topic"), text("level-topic"), {std::next(fixes.begin()), fixes.end()}};
  if (given.count("datum") > 0) options.datum = parse_datum(text("datum"));
  if (given.count("set") > 0) options.assignments = given["set"].as<std::vector<std::string>>();
  options.faults_file = text("faults");
  options.json_file = text("json");
  options.plot_file = text("plot");
  options.report_file = text("report");
  options.write_directory = text("write");
  options.extras = parse_extras(text("with"));
  options.left_aside = parse_extras(text("without"));
  refuse_for_suites(given, options);

  Batch& batch = options.batch;
  batch.estimators = chosen(text("estimators"), options.over_drives());
  read_seeds(text("seeds"), batch);
  batch.jobs = count("jobs");
  batch.score_from = options.over_drives() ? kSettled : 0.0;
  if (given.count("score-from") > 0) batch.score_from = given["score-from"].as<double>();
  batch.off_from = given["off-from"].as<double>();
  batch.settings.known_start = given.count("known-start") > 0;
  return options;
}

}  // namespace multipath_localization
