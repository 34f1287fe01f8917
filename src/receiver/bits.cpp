#include "receiver/bits.hpp"

#include <cmath>

namespace multipath_localization {

void BitString::append(std::uint64_t value, int width) {
  for (int i = width - 1; i >= 0; --i) bits_.push_back((value >> i & 1U) != 0);
}

void BitString::append(const BitString& other, std::size_t first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bits_.push_back(other.at(first + i));
}

std::uint64_t BitReader::whole(int width) {
  std::uint64_t value = 0;
  for (int i = 0; i < width; ++i) value = value << 1 | (bits_.at(place_++) ? 1U : 0U);
  return value;
}

double BitReader::scaled(int width, int exponent) {
  return std::ldexp(static_cast<double>(whole(width)), exponent);
}

double BitReader::scaled_signed(int width, int exponent) {
  const auto value = static_cast<std::int64_t>(whole(width));
  const std::int64_t range = std::int64_t{1} << width;
  const std::int64_t folded = value >= range / 2 ? value - range : value;
  return std::ldexp(static_cast<double>(folded), exponent);
}

double BitReader::scaled_sign_magnitude(int width, int exponent) {
  const bool negative = flag();
  const double magnitude = scaled(width - 1, exponent);
  return negative ? -magnitude : magnitude;
}

std::uint32_t crc24q(const BitString& bits, std::size_t first, std::size_t count) {
  constexpr std::uint32_t kGenerator = 0x864CFB;
  constexpr std::uint32_t kHighest = 1U << 23;
  std::uint32_t crc = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    const bool divides = ((crc & kHighest) != 0) != bits.at(i);
    crc = (crc << 1 & 0xFFFFFF) ^ (divides ? kGenerator : 0U);
  }
  return crc;
}

}  // namespace multipath_localization
