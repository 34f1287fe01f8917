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

#include "evaluation/batch.hpp"
#include "evaluation/calibration_report.hpp"
#include "evaluation/drive_files.hpp"
#include "evaluation/progress.hpp"
#include "evaluation/report.hpp"
#include "evaluation/results_file.hpp"
#include "evaluation/shortcomings.hpp"
#include "evaluation/standings.hpp"
#include "evaluation/suite.hpp"
#include "evaluation/trace.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "ros/bags/bag_drive.hpp"
#include "ros/fault_injector_node/fault_injector.hpp"
#include "tools/evaluate/command_line.hpp"
#include "tools/evaluate/options.hpp"
#include "tools/evaluate/random_runs.hpp"

namespace multipath_localization {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

constexpr char kLocalizer[] = "localizer";
constexpr char kSimulator[] = "simulator";
constexpr char kSteering[] = "steering";

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
  if (!options.drives_directory().empty()) {
    FoundDrives found = read_drives(options.drives_directory(), options.batch.score_from);
    for (const std::string& drive : found.left_out) std::cerr << "left out: " << drive << "\n";
    for (Drive& drive : found.drives) {
      std::string name = drive.name;
      rows.push_back({std::move(name), std::move(drive)});
    }
    return rows;
  }
  for (Scenario& row : load_suite(named_file(options.suite, "config/suites"))) {
    std::string name = row.name;
    rows.push_back({std::move(name), std::move(row)});
  }
  return rows;
}

/// Leaves inputs of a recording aside.
void leave_aside(const RandomExtras& inputs, Drive& drive) {
  if (inputs.gyro) drive.yaw_rates.clear();
  const auto left_aside = [&](const RecordedMeasurement& recorded) {
    const auto* fix = std::get_if<GnssFix>(&recorded.measurement);
    return (inputs.heading && std::holds_alternative<Heading>(recorded.measurement)) ||
           (inputs.velocity && std::holds_alternative<GnssVelocity>(recorded.measurement)) ||
           (inputs.receivers && fix != nullptr && fix->receiver > 0);
  };
  auto& all = drive.measurements;
  for (RecordedMeasurement& recorded : all) {
    auto* fix = std::get_if<GnssFix>(&recorded.measurement);
    if (inputs.levels && fix != nullptr) fix->level = FixLevel::kUntold;
  }
  all.erase(std::remove_if(all.begin(), all.end(), left_aside), all.end());
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

/// Has a script of the package make a file of the trace.
void draw(const std::string& script, const std::string& trace, const std::string& file) {
  if (file.empty()) return;
  const std::string trace_file = file + ".trace.json";
  write_file(trace_file, trace);
  const bool drawn = run({package_file(script, "scripts/" + script), trace_file, file});
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

std::vector<RunRecord> run_random_robots(const Options& options) {
  Batch batch = options.batch;
  batch.source = kRandomSuite;
  Stream recording = Drive();
  const std::vector<std::string> parameters = settle_parameters(options.assignments, batch, recording);
  return make_random_runs(options, batch, parameters);
}

/// Prints what suites over drives end with, and writes what was asked for.
int report_standings(const Options& options, const std::vector<RunRecord>& runs) {
  if (runs.empty()) throw UsageError("there are no runs");
  std::cout << describe_standings(runs) << "\n" << describe_calibration(runs);
  if (!options.json_file.empty()) write_file(options.json_file, to_json(runs));
  return report_failures(runs) == 0 ? 0 : 1;
}

/// Writes what was asked for about the runs; those drawn went over the first stream.
void write_results(const Options& options, const Stream& first, const std::vector<RunRecord>& runs) {
  if (!options.json_file.empty()) write_file(options.json_file, to_json(runs));
  if (options.plot_file.empty() && options.report_file.empty()) return;
  const std::string title = std::visit([](const auto& s) { return s.name; }, first);
  const std::string trace = to_trace(title, first, runs);
  draw("plot_evaluation", trace, options.plot_file);
  draw("report", trace, options.report_file);
}

int evaluate(const Options& options) {
  if (!options.write_directory.empty()) return write_random_drives(options), 0;
  if (options.sums_up()) return report_standings(options, read_results(options.results_files));
  if (options.suite == kRandomSuite) return report_standings(options, run_random_robots(options));
  std::vector<NamedStream> streams = open_streams(options);
  for (NamedStream& named : streams) {
    auto* drive = std::get_if<Drive>(&named.stream);
    if (drive == nullptr) continue;
    leave_aside(options.left_aside, *drive);
    for (const std::string& notice : drive->notices) std::cerr << drive->name << ": " << notice << "\n";
  }
  const std::vector<RunRecord> runs = make_runs(options, streams);
  std::cout << to_table(runs);
  if (options.over_drives()) return report_standings(options, runs);
  if (!options.suite.empty()) {
    for (const std::string& sentence : shortcomings(runs)) std::cout << sentence << "\n";
  }
  std::cout << losses(runs);
  const int failed = report_failures(runs);
  write_results(options, streams.front().stream, runs);
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  using namespace multipath_localization;
  try {
    po::options_description description("Runs estimators over the same stream and scores them against truth");
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
