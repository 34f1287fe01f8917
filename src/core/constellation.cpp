#include "multipath_localization/core/constellation.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace multipath_localization {

namespace {

constexpr std::array<std::string_view, kConstellations> kNames = {"GPS", "GLONASS", "GALILEO", "BEIDOU",
                                                                  "QZSS"};

bool same_letter(char a, char b) {
  return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
}

}  // namespace

std::string_view to_string(Constellation constellation) {
  return kNames[static_cast<std::size_t>(constellation)];
}

std::optional<Constellation> constellation_of(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (std::equal(name.begin(), name.end(), kNames[i].begin(), kNames[i].end(), same_letter)) {
      return static_cast<Constellation>(i);
    }
  }
  return std::nullopt;
}

}  // namespace multipath_localization
