#include "evaluation/text_table.hpp"

#include <algorithm>
#include <cmath>

#include "support/plain_numbers.hpp"

namespace multipath_localization {

std::string side_by_side(const std::vector<TextColumn>& columns, std::size_t names) {
  std::string out;
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      std::size_t width = 0;
      for (const std::string& cell : columns[i]) width = std::max(width, cell.size());
      const std::string padding(width - columns[i][row].size(), ' ');
      if (i > 0) out += "  ";
      out += i < names ? columns[i][row] + padding : padding + columns[i][row];
    }
    out += "\n";
  }
  return out;
}

std::string number(double value, int digits) {
  PlainStream out;
  out.precision(digits);
  out << (std::abs(value) < 1e6 ? std::fixed : std::scientific) << value;
  return out.str();
}

std::string figure(double value, int digits) {
  return number(value, digits == 2 && std::abs(value) < 0.0995 ? 3 : digits);
}

}  // namespace multipath_localization
