#include "receiver/glonass_message.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr std::size_t kWords = 3;
constexpr std::size_t kStringBits = 85;
constexpr std::size_t kCheckBits = 8;     // the last ones, the one over all of the string before the others
constexpr double kFrame = 30.0;           // strings 1 to 4 take the first 8 of these seconds
constexpr double kMoscow = 3.0 * 3600.0;  // ahead of UTC [s]
constexpr double kQuarterOfAnHour = 900.0;
constexpr double kKilometre = 1e3;

/// Where the data bit number `i` after the last check bit stands in a Hamming code: the places that are
/// powers of two are those of check bits.
std::size_t hamming_place(std::size_t i) {
  std::size_t place = 0;
  for (std::size_t left = i + 1; left > 0; --left) {
    ++place;
    while ((place & (place - 1)) == 0) ++place;
  }
  return place;
}

/// One axis of place, speed and acceleration, as strings 1 to 3 have it.
void read_axis(const BitString& bits, Eigen::Index axis, GlonassOrbit& orbit) {
  BitReader in(bits, 21);
  orbit.velocity(axis) = kKilometre * in.scaled_sign_magnitude(24, -20);
  orbit.acceleration(axis) = kKilometre * in.scaled_sign_magnitude(5, -30);
  orbit.position(axis) = kKilometre * in.scaled_sign_magnitude(27, -11);
}

}  // namespace

bool glonass_string_holds(const BitString& bits) {
  std::size_t syndrome = 0;
  bool odd = false;
  const std::size_t data = kStringBits - kCheckBits;
  for (std::size_t i = 0; i < data; ++i) {
    if (!bits.at(data - 1 - i)) continue;
    syndrome ^= hamming_place(i);
    odd = !odd;
  }
  // Bits 1 to 7 by the ICD's count, from the end, are those of the code; bit 8 makes the sum of all even.
  for (std::size_t i = 0; i < kCheckBits; ++i) {
    if (!bits.at(kStringBits - 1 - i)) continue;
    if (i + 1 < kCheckBits) syndrome ^= std::size_t{1} << i;
    odd = !odd;
  }
  return syndrome == 0 && !odd;
}

std::optional<GlonassOrbit> GlonassMessage::add(const Subframe& subframe, const ReceptionTime& now) {
  if (subframe.words.size() < kWords) return std::nullopt;
  BitString bits;
  for (std::size_t i = 0; i < kWords; ++i) bits.append(subframe.words[i], 32);
  if (!glonass_string_holds(bits)) return std::nullopt;
  BitReader in(bits, 1);
  const std::uint64_t number = in.whole(4);
  if (number < 1 || number > strings_.size()) return std::nullopt;
  strings_.at(number - 1) = String{bits, now.gps};
  const bool whole = std::all_of(strings_.begin(), strings_.end(), [&](const std::optional<String>& string) {
    return string && std::abs(now.gps - string->received) < kFrame / 2.0;
  });
  if (!whole) return std::nullopt;
  GlonassOrbit found = orbit(now);
  found.satellite = subframe.satellite;
  found.channel = subframe.channel;
  strings_ = {};
  return found;
}

GlonassOrbit GlonassMessage::orbit(const ReceptionTime& now) const {
  GlonassOrbit orbit;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    read_axis(strings_.at(axis)->bits, static_cast<Eigen::Index>(axis), orbit);
  }
  BitReader second(strings_[1]->bits, 5);
  const bool unhealthy = second.flag();
  second.skip(3);  // the other bits of B_n, P2
  const double of_day = kQuarterOfAnHour * second.scaled(7, 0) - kMoscow + now.leap_seconds;
  orbit.reference = nearest(now.gps, of_day, kSecondsOfDay);

  BitReader third(strings_[2]->bits, 6);
  orbit.clock_drift = third.scaled_sign_magnitude(11, -40);
  third.skip(3);  // P
  orbit.healthy = !unhealthy && !third.flag();

  BitReader fourth(strings_[3]->bits, 5);
  orbit.clock = -fourth.scaled_sign_magnitude(22, -30);
  orbit.sent = now.gps - orbit.reference;
  return orbit;
}

}  // namespace multipath_localization
