#include "support/plain_numbers.hpp"

#include <locale.h>  // NOLINT(modernize-deprecated-headers): newlocale is POSIX, <clocale> does not name it
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): nor <cstdlib> strtod_l

namespace multipath_localization {

std::string fixed_text(double value, int digits) {
  PlainStream out;
  out.precision(digits);
  out << std::fixed << value;
  return out.str();
}

std::optional<double> parse_number(const std::string& text) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  char* end = nullptr;
  const double value = strtod_l(text.c_str(), &end, plain);
  if (text.empty() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace multipath_localization
