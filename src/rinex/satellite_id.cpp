#include "rinex/satellite_id.hpp"

#include <string_view>

namespace multipath_localization {

namespace {

constexpr std::string_view kLetters = "GRECJ";  // in the order of Constellation

}  // namespace

std::optional<Constellation> constellation_of_letter(char letter) {
  const std::size_t place = kLetters.find(letter);
  if (place == std::string_view::npos) return std::nullopt;
  return static_cast<Constellation>(place);
}

char letter_of(Constellation constellation) { return kLetters[static_cast<std::size_t>(constellation)]; }

}  // namespace multipath_localization
