#include "support/csv.hpp"

#include <cmath>
#include <fstream>

#include "support/plain_numbers.hpp"
namespace multipath_localization {

namespace {

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r\"";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, end == std::string::npos ? end : end - begin)));
    if (end == std::string::npos) return cells;
    begin = end + 1;
  }
}

}  // namespace

CsvTable::CsvTable(const std::string& file, const std::vector<std::string>& required) : file_(file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw DriveError(file + ": cannot be read or is empty");
  const std::vector<std::string> header = split(line);
  for (std::size_t i = 0; i < header.size(); ++i) columns_[header[i]] = i;
  for (const std::string& column : required) {
    if (!has(column)) throw DriveError(std::string(file).append(":1: no column ").append(column));
  }
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    if (trimmed(line).empty()) continue;
    cells_.push_back(split(line));
    lines_.push_back(number);
    if (cells_.back().size() != header.size()) {
      throw error(rows() - 1, std::to_string(cells_.back().size()) + " cells under " +
                                  std::to_string(header.size()) + " columns");
    }
  }
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
  const auto found = columns_.find(column);
  if (found == columns_.end()) throw error(row, "there is no column " + column);
  return cells_[row][found->second];
}

double CsvTable::number(std::size_t row, const std::string& column, double largest) const {
  const std::string& cell = text(row, column);
  const std::optional<double> value = parse_number(cell);
  if (!value || !std::isfinite(*value)) {
    throw error(row, column + " is '" + cell + "', not a finite number");
  }
  if (std::abs(*value) <= largest) return *value;
  throw error(row, plain_text(column, " is '", cell, "', beyond ", largest));
}

DriveError CsvTable::error(std::size_t row, const std::string& reason) const {
  DriveError located(file_ + ":" + std::to_string(lines_[row]) + ": " + reason);
  return located;
}

}  // namespace multipath_localization
