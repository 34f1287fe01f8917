#pragma once

#include <optional>
#include <string_view>

namespace multipath_localization {

/// Satellite systems. The clocks of two of them differ by an offset of their own, as a receiver sees them.
enum class Constellation { kGps, kGlonass, kGalileo, kBeidou, kQzss };

constexpr int kConstellations = 5;

/// "GPS", "GLONASS", "GALILEO", "BEIDOU", "QZSS".
std::string_view to_string(Constellation constellation);

/// The constellation of that name, whatever its case; nothing for any other text.
std::optional<Constellation> constellation_of(std::string_view name);

}  // namespace multipath_localization
