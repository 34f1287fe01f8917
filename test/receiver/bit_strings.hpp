#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "multipath_localization/core/angle.hpp"
#include "rinex/gnss_time.hpp"

/// Words of a navigation message, made of bits.
namespace multipath_localization::ubx {

using Words = std::vector<std::uint32_t>;

/// Bits one after the other, as '0' and '1'.
class Bits {
 public:
  Bits& put(std::int64_t value, int width) {
    for (int i = width - 1; i >= 0; --i) text_ += (value >> i & 1) != 0 ? '1' : '0';
    return *this;
  }
  /// `value` in units of 2^`exponent`, in two's complement or without sign.
  Bits& scaled(double value, int width, int exponent) {
    return put(std::llround(std::ldexp(value, -exponent)), width);
  }
  Bits& angle(double radians, int width, int exponent) { return scaled(radians / kPi, width, exponent); }
  /// The first bit is the sign, the others the magnitude.
  Bits& sign_magnitude(double value, int width, int exponent) {
    put(std::signbit(value) ? 1 : 0, 1);
    return scaled(std::abs(value), width - 1, exponent);
  }
  Bits& add(const std::string& bits) {
    text_ += bits;
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::string part(std::size_t first, std::size_t count) const {
    return text_.substr(first, count);
  }

 private:
  std::string text_;
};

inline std::int64_t number_of(const std::string& bits) {
  std::int64_t value = 0;
  for (const char bit : bits) value = 2 * value + (bit - '0');
  return value;
}

/// Words of 32 bits, the last filled up.
inline Words words_of(std::string bits) {
  while (bits.size() % 32 != 0) bits += '0';
  Words words;
  for (std::size_t i = 0; i < bits.size(); i += 32) {
    words.push_back(static_cast<std::uint32_t>(number_of(bits.substr(i, 32))));
  }
  return words;
}

/// Padding and parity, of which nothing is to be assumed, are set to something.
inline std::uint32_t padded(const std::string& data, int parity) {
  const auto value = static_cast<std::uint32_t>(number_of(data));
  return 3U << 30 | value << parity | ((1U << parity) - 1U) / 3U;
}

inline std::int64_t week_second(const GnssTime& time) { return std::llround(time.second); }

}  // namespace multipath_localization::ubx
