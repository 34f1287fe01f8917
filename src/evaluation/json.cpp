#include "evaluation/json.hpp"

#include <string_view>

namespace multipath_localization {

std::string quoted(const std::string& text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (code < 0x20) {
      out += "\\u00";
      out += {kHex[code / 16], kHex[code % 16]};
    } else {
      out += c;
    }
  }
  return out + "\"";
}

}  // namespace multipath_localization
