#pragma once

#include <string_view>

namespace multipath_localization {

/// What some programs begin a file of UTF-8 by.
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The text without any of `blanks` at its ends.
inline std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace multipath_localization
