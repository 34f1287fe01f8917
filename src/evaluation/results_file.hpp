#pragma once

#include <cstdint>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// A file of results cannot be read or written, or holds those of another evaluation.
class ResultsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What runs were made of: what has to be the same for all runs of a file. Anything that two texts compare.
struct Evaluation {
  std::string suite;
  std::vector<std::string> inputs;      ///< beside odometry and fixes
  std::vector<std::string> estimators;  ///< with the parameters of their own
  std::vector<std::string> parameters;  ///< that were set for it
  double score_from = 0.0;              ///< [s]
};

/// Runs as they end, a line of JSON each behind a first line that says what they were made of: what is there
/// survives the end of the program, and the next one goes on from there.
class ResultsFile {
 public:
  /// Reads a file or begins it. A last line that was cut off is made again. Throws ResultsError.
  ResultsFile(const std::string& file, const Evaluation& evaluation);

  /// Whether the runs with that seed are there.
  [[nodiscard]] bool holds(std::uint64_t seed) const { return seeds_.count(seed) > 0; }
  /// The runs that were there when it was opened.
  [[nodiscard]] const std::vector<RunRecord>& runs() const { return runs_; }

  /// Adds the runs with one seed, all of them. From any thread. Throws ResultsError.
  void add(const std::vector<RunRecord>& runs);

 private:
  std::string file_;
  std::vector<RunRecord> runs_;
  std::set<std::uint64_t> seeds_;
  std::mutex mutex_;
  std::ofstream out_;
};

/// The runs of several files of one evaluation, a seed that is in several once. Throws ResultsError.
std::vector<RunRecord> read_results(const std::vector<std::string>& files);

}  // namespace multipath_localization
