#include "evaluation/results_file.hpp"

#include <filesystem>
#include <map>
#include <optional>

#include "evaluation/run_json.hpp"

namespace multipath_localization {

namespace {

using nlohmann::json;

/// What is in a file: what its runs were made of, and those of each seed.
struct Content {
  json evaluation;
  std::map<std::uint64_t, std::vector<RunRecord>> runs;
  std::uintmax_t whole = 0;  ///< bytes up to the end of the last whole line
};

json to_json(const Evaluation& evaluation) {
  return {{"suite", evaluation.suite},
          {"inputs", evaluation.inputs},
          {"estimators", evaluation.estimators},
          {"parameters", evaluation.parameters},
          {"score_from", evaluation.score_from}};
}

void read_line(const std::string& line, Content& content) {
  const json read = json::parse(line);
  if (content.evaluation.is_null()) {
    content.evaluation = read.at("evaluation");
    return;
  }
  std::vector<RunRecord> runs;
  for (const json& run : read.at("runs")) runs.push_back(run_from_json(run));
  if (!runs.empty()) content.runs.emplace(runs.front().seed, std::move(runs));
}

Content read_content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ResultsError("cannot read " + file);
  Content content;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line) && !in.eof(); content.whole += line.size() + 1) {
    ++number;
    try {
      read_line(line, content);
    } catch (const json::exception& error) {
      throw ResultsError(file + ", line " + std::to_string(number) + ": no results: " + error.what());
    }
  }
  return content;
}

std::vector<RunRecord> in_order(std::map<std::uint64_t, std::vector<RunRecord>>&& by_seed) {
  std::vector<RunRecord> all;
  for (auto& [seed, runs] : by_seed) {
    for (RunRecord& run : runs) all.push_back(std::move(run));
  }
  return all;
}

void refuse_other(const std::string& file, const json& theirs, const json& ours) {
  if (theirs == ours) return;
  throw ResultsError(file + " holds results of " + theirs.dump() + ", not of " + ours.dump());
}

}  // namespace

ResultsFile::ResultsFile(const std::string& file, const Evaluation& evaluation) : file_(file) {
  const json ours = to_json(evaluation);
  bool begun = false;
  if (std::filesystem::exists(file)) {
    Content content = read_content(file);
    begun = !content.evaluation.is_null();
    if (begun) refuse_other(file, content.evaluation, ours);
    std::filesystem::resize_file(file, content.whole);
    for (const auto& [seed, runs] : content.runs) seeds_.insert(seed);
    runs_ = in_order(std::move(content.runs));
  }
  out_.open(file, std::ios::app | std::ios::binary);
  if (!begun) out_ << json{{"evaluation", ours}}.dump() << '\n' << std::flush;
  if (!out_) throw ResultsError("cannot write " + file);
}

void ResultsFile::add(const std::vector<RunRecord>& runs) {
  json lines = json::array();
  for (const RunRecord& run : runs) lines.push_back(run_to_json(run));
  const std::string line = json{{"runs", lines}}.dump() + "\n";
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << line << std::flush;
  if (!out_) throw ResultsError("cannot write " + file_);
}

std::vector<RunRecord> read_results(const std::vector<std::string>& files) {
  std::optional<json> evaluation;
  std::map<std::uint64_t, std::vector<RunRecord>> all;
  for (const std::string& file : files) {
    Content content = read_content(file);
    if (evaluation) refuse_other(file, content.evaluation, *evaluation);
    evaluation = content.evaluation;
    all.merge(content.runs);
  }
  return in_order(std::move(all));
}

}  // namespace multipath_localization
