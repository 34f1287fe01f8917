#pragma once

#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace multipath_localization {

/// A recording that cannot be used. The text names the file, the line where there is one, and the reason.
class DriveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr double kLatestTime = 1e11;  ///< of a recording [s]: those that count milliseconds are refused

/// Reads a comma-separated file line by line. A byte-order mark, comments from `#` on, blanks and quotes
/// round a cell, and lines that then hold nothing are left out.
class CsvReader {
 public:
  explicit CsvReader(const std::string& file) : in_(file) {}

  /// Whether the file could be opened.
  [[nodiscard]] bool open() const { return in_.is_open(); }

  /// Reads the next line's cells; false at the end of the file.
  bool read(std::vector<std::string>& cells);

  /// Of the file, from 1: that of the cells read last.
  [[nodiscard]] int line() const { return line_; }

 private:
  std::ifstream in_;
  int line_ = 0;
};

/// A comma-separated table with a header line. Columns go by name, in any order; text cells are allowed where
/// nobody asks for a number.
class CsvTable {
 public:
  /// Throws DriveError when the file cannot be read, lacks one of the `required` columns or has a ragged
  /// line.
  CsvTable(const std::string& file, const std::vector<std::string>& required);

  [[nodiscard]] std::size_t rows() const { return cells_.size(); }
  [[nodiscard]] bool has(const std::string& column) const { return columns_.count(column) > 0; }

  /// The finite number in that cell, up to `largest` either way. Throws DriveError when it is none.
  [[nodiscard]] double number(std::size_t row, const std::string& column,
                              double largest = std::numeric_limits<double>::max()) const;

  /// The cell as it stands, without blanks and quotes round it. Throws DriveError where the file has no such
  /// column.
  [[nodiscard]] const std::string& text(std::size_t row, const std::string& column) const;

  /// A DriveError at the row's line of the file.
  [[nodiscard]] DriveError error(std::size_t row, const std::string& reason) const;

 private:
  std::string file_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<std::string>> cells_;
  std::vector<int> lines_;  ///< of the file, from 1
};

}  // namespace multipath_localization
