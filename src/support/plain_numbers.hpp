#pragma once

#include <optional>
#include <sstream>
#include <string>

namespace multipath_localization {

// Numbers as text with a decimal point, whatever locale the program around this library has set: a GUI that
// sets the user's writes and reads a comma by printf, strtod and streams.

/// A stream that writes numbers so.
class PlainStream : public std::ostringstream {
 public:
  PlainStream() { imbue(std::locale::classic()); }
};

/// The parts one after the other, numbers by up to six significant digits.
template <class... Parts>
std::string plain_text(const Parts&... parts) {
  PlainStream out;
  (out << ... << parts);
  return out.str();
}

/// With that many digits after the point.
std::string fixed_text(double value, int digits);

/// What strtod reads in the C locale, if that is all of the text.
std::optional<double> parse_number(const std::string& text);

}  // namespace multipath_localization
