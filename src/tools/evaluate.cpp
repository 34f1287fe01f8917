// Runs estimators over a recorded drive, a bag or a simulated scenario and says how far off they were.

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/evaluation/batch.hpp"
#include "multipath_localization/evaluation/progress.hpp"
#include "multipath_localization/evaluation/report.hpp"
#include "multipath_localization/evaluation/shortcomings.hpp"
#include "multipath_localization/evaluation/suite.hpp"
#include "multipath_localization/evaluation/trace.hpp"
#include "nodes/bag_drive.hpp"
#include "nodes/fault_injector.hpp"
#include "tools/evaluate/options.hpp"

namespace multipath_localization {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

constexpr char kLocalizer[] = "localizer";
constexpr char kSimulator[] = "simulator";
constexpr char kSteering[] = "steering";

/// The command line.
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

std::vector<EstimatorVariant> chosen(const std::string& list) {
  if (list.empty()) return parse_variants(estimator_names().front());
  if (list != "all") return parse_variants(list);
  std::vector<EstimatorVariant> all;
  for (const std::string& name : estimator_names()) all.push_back({name, name, ""});
  return all;
}

Options read_options(const po::variables_map& given) {
  const auto text = [&](const char* key) { return given.count(key) > 0 ? given[key].as<std::string>() : ""; };
  const auto count = [&](const char* key) {
    if (given[key].as<int>() < 1) throw UsageError(std::string("--") + key + " is less than 1");
    return static_cast<std::size_t>(given[key].as<int>());
  };
  if (given.count("drive") + given.count("bag") + given.count("scenario") + given.count("suite") != 1) {
    throw UsageError("give one of --drive, --bag, --scenario, --suite; --help tells more");
  }
  if (given.count("suite") > 0 && given.count("plot") + given.count("faults") > 0) {
    throw UsageError("--plot and --faults are for one stream, not for a suite");
  }
  Options options;
  options.drive = text("drive");
  options.bag = text("bag");
  options.scenario = text("scenario");
  options.suite = text("suite");
  options.topics = {text("fix-topic"),   text("odom-topic"), text("truth-topic"), text("shadow-topic"),
                    text("epoch-topic"), text("left-topic"), text("right-topic")};
  if (given.count("datum") > 0) options.datum = parse_datum(text("datum"));
  if (given.count("set") > 0) options.assignments = given["set"].as<std::vector<std::string>>();
  options.faults_file = text("faults");
  options.json_file = text("json");
  options.plot_file = text("plot");

  Batch& batch = options.batch;
  batch.estimators = chosen(text("estimators"));
  batch.seeds = count("seeds");
  batch.jobs = count("jobs");
  batch.score_from = given["score-from"].as<double>();
  batch.off_from = given["off-from"].as<double>();
  batch.settings.known_start = given.count("known-start") > 0;
  return options;
}

/// A file of the package, installed or in the source tree.
std::string package_file(const std::string& installed, const std::string& source) {
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& candidate : {here / installed, fs::path(SOURCE_DIR) / source}) {
    if (fs::exists(candidate)) return candidate.lexically_normal();
  }
  throw UsageError("cannot find " + source);
}

/// A file the user names: by its path, or by its name in a folder of the package.
std::string named_file(const std::string& name, const std::string& folder) {
  if (fs::path(name).extension() == ".yaml") return name;
  const std::string file = folder + "/" + name + ".yaml";
  return package_file("../../share/multipath_localization/" + file, file);
}

/// A stream and what the user calls it.
struct NamedStream {
  std::string name;
  Stream stream;
};

std::vector<NamedStream> open_streams(const Options& options) {
  if (!options.drive.empty()) return {{options.drive, read_drive(options.drive)}};
  if (!options.bag.empty()) return {{options.bag, read_bag(options.bag, options.topics, options.datum)}};
  if (!options.scenario.empty()) {
    return {{options.scenario, load_scenario(named_file(options.scenario, "config/scenarios"))}};
  }
  std::vector<NamedStream> rows;
  for (Scenario& row : load_suite(named_file(options.suite, "config/suites"))) {
    std::string name = row.name;
    rows.push_back({std::move(name), std::move(row)});
  }
  return rows;
}

/// Whose parameters count in this evaluation.
std::vector<std::string> owners_run(const Batch& batch, const Stream& stream) {
  std::vector<std::string> owners = {kLocalizer};
  for (const EstimatorVariant& variant : batch.estimators) owners.push_back(variant.name);
  if (std::holds_alternative<Scenario>(stream)) owners.insert(owners.end(), {kSimulator, kSteering});
  return owners;
}

/// Puts faults on the stream.
void add_faults(const std::string& file, Batch& batch, Stream& stream) {
  if (file.empty()) return;
  FaultInjectorParameters parameters;
  load(read_yaml(file), parameters);
  if (parameters.datum.given()) throw UsageError(file + ": datum is the stream's, leave it out");
  batch.fault_seed = static_cast<std::uint64_t>(parameters.seed);
  if (auto* scenario = std::get_if<Scenario>(&stream)) {
    scenario->simulator.faults = parameters.faults;
  } else {
    batch.faults = parameters.faults;
  }
}

/// The parameters of each estimator; settles those of the localizer in the batch, of a scenario in the
/// stream.
std::vector<std::string> settle_parameters(const std::vector<std::string>& assignments, Batch& batch,
                                           Stream& stream) {
  std::vector<std::string> owners = estimator_names();
  owners.insert(owners.end(), {kLocalizer, kSimulator, kSteering});
  const ParameterOverrides overrides(assignments, owners);
  const std::vector<std::string> run = owners_run(batch, stream);
  for (const std::string& owner : overrides.owners()) {
    if (std::find(run.begin(), run.end(), owner) == run.end()) {
      throw UsageError("--set is for " + owner + ", which is not run");
    }
  }
  load(overrides.of(kLocalizer), batch.settings.localizer, kLocalizer);
  if (auto* scenario = std::get_if<Scenario>(&stream)) {
    load(overrides.of(kSimulator), scenario->simulator, kSimulator);
    load(overrides.of(kSteering), scenario->steering, kSteering);
  }
  return parameters_of(batch, stream, overrides);
}

void write_file(const std::string& file, const std::string& content) {
  std::ofstream out(file);
  out << content;
  if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

/// Runs a program with arguments, without a shell between; returns whether it ended well.
bool run(std::vector<std::string> command) {
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawn(&child, arguments.front(), nullptr, nullptr, arguments.data(), environ) != 0) return false;
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void plot(const std::string& file, const std::string& trace) {
  const std::string script = package_file("plot_evaluation", "scripts/plot_evaluation");
  const std::string trace_file = file + ".trace.json";
  write_file(trace_file, trace);
  const bool drawn = run({script, trace_file, file});
  fs::remove(trace_file);
  if (!drawn) throw std::runtime_error("cannot draw " + file);
}

std::vector<RunRecord> make_runs(const Options& options, std::vector<NamedStream>& streams) {
  const std::size_t runs_of_stream = options.batch.estimators.size() * options.batch.seeds;
  ProgressBar bar(runs_of_stream * streams.size(), isatty(STDERR_FILENO) != 0);
  std::vector<RunRecord> runs;
  for (auto& [name, stream] : streams) {
    Batch batch = options.batch;
    batch.source = name;
    add_faults(options.faults_file, batch, stream);
    const std::vector<std::string> parameters = settle_parameters(options.assignments, batch, stream);
    const std::size_t before = runs.size();
    const auto progress = [&](std::size_t run, double part) { bar.update(before + run, part); };
    for (RunRecord& run : run_batch(batch, stream, parameters, progress)) runs.push_back(std::move(run));
  }
  return runs;
}

/// How many runs did not end, and says why.
int report_failures(const std::vector<RunRecord>& runs) {
  int failed = 0;
  for (const RunRecord& run : runs) {
    if (run.failure.empty()) continue;
    std::cerr << run.source << ": " << run.estimator << ", seed " << run.seed
              << ", did not end: " << run.failure << "\n";
    ++failed;
  }
  return failed;
}

int evaluate(const Options& options) {
  std::vector<NamedStream> streams = open_streams(options);
  const Stream& first = streams.front().stream;
  const std::string title = std::visit([](const auto& s) { return s.name; }, first);
  if (const auto* drive = std::get_if<Drive>(&first)) {
    for (const std::string& notice : drive->notices) std::cerr << title << ": " << notice << "\n";
  }
  const std::vector<RunRecord> runs = make_runs(options, streams);
  std::cout << to_table(runs);
  if (!options.suite.empty()) {
    for (const std::string& sentence : shortcomings(runs)) std::cout << sentence << "\n";
  }
  if (!options.json_file.empty()) write_file(options.json_file, to_json(runs));
  if (!options.plot_file.empty()) plot(options.plot_file, to_trace(title, first, runs));
  return report_failures(runs) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  using namespace multipath_localization;
  try {
    po::options_description description(
        "Runs estimators over the same stream and scores them against truth.");
    description.add(stream_options()).add(run_options());
    po::variables_map given;
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::parse_command_line(argc, argv, description, style), given);
    if (given.count("help") > 0) {
      std::cout << description << kAfterwards;
      return 0;
    }
    return evaluate(read_options(given));
  } catch (const std::exception& error) {
    std::cerr << "evaluate: " << error.what() << "\n";
    return 2;
  }
}
