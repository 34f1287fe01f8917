#include "support/csv.hpp"

#include <cmath>
#include <string_view>

#include "support/plain_numbers.hpp"
#include "support/text.hpp"

namespace multipath_localization {

bool CsvReader::read(std::vector<std::string>& cells) {
  constexpr std::string_view kBlanks = " \t\r\"";
  cells.clear();
  for (std::string text; cells.empty() && std::getline(in_, text);) {
    if (++line_ == 1 && text.rfind(kByteOrderMark, 0) == 0) text.erase(0, kByteOrderMark.size());
    std::string_view rest = std::string_view(text).substr(0, text.find('#'));
    if (trimmed(rest, kBlanks).empty()) continue;
    for (std::size_t comma = rest.find(','); comma != std::string_view::npos; comma = rest.find(',')) {
      cells.emplace_back(trimmed(rest.substr(0, comma), kBlanks));
      rest.remove_prefix(comma + 1);
    }
    cells.emplace_back(trimmed(rest, kBlanks));
  }
  return !cells.empty();
}

CsvTable::CsvTable(const std::string& file, const std::vector<std::string>& required) : file_(file) {
  CsvReader in(file);
  std::vector<std::string> header;
  if (!in.read(header)) throw DriveError(file + ": cannot be read or is empty");
  for (std::size_t i = 0; i < header.size(); ++i) columns_[header[i]] = i;
  for (const std::string& column : required) {
    if (!has(column)) throw DriveError(file + ":" + std::to_string(in.line()) + ": no column " + column);
  }
  for (std::vector<std::string> cells; in.read(cells);) {
    cells_.push_back(cells);
    lines_.push_back(in.line());
    if (cells.size() != header.size()) {
      throw error(rows() - 1, std::to_string(cells.size()) + " cells under " + std::to_string(header.size()) +
                                  " columns");
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
