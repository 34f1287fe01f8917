#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath_localization {

/// Bits in the order in which they were sent.
class BitString {
 public:
  /// Appends the lowest `width` bits (up to 64) of `value`, the highest of them first.
  void append(std::uint64_t value, int width);

  /// Appends `count` bits of `other` from `first` on. Throws std::out_of_range where it has not so many.
  void append(const BitString& other, std::size_t first, std::size_t count);

  [[nodiscard]] std::size_t size() const { return bits_.size(); }

  /// Throws std::out_of_range.
  [[nodiscard]] bool at(std::size_t place) const { return bits_.at(place); }

 private:
  std::vector<bool> bits_;
};

/// Reads a BitString field after field, as interface specifications list them. All that read throw
/// std::out_of_range at its end.
class BitReader {
 public:
  /// `bits` have to outlive it; reading begins at `first`.
  explicit BitReader(const BitString& bits, std::size_t first = 0) : bits_(bits), place_(first) {}

  /// The next `width` bits, up to 63, as a whole number.
  std::uint64_t whole(int width);

  bool flag() { return whole(1) != 0; }

  /// A number without sign, times 2^`exponent`.
  double scaled(int width, int exponent);

  /// A number in two's complement, times 2^`exponent`.
  double scaled_signed(int width, int exponent);

  /// A number whose first bit is its sign and whose others are its magnitude, times 2^`exponent`.
  double scaled_sign_magnitude(int width, int exponent);

  void skip(std::size_t width) { place_ += width; }

  /// Of the next bit.
  [[nodiscard]] std::size_t place() const { return place_; }

 private:
  const BitString& bits_;
  std::size_t place_;
};

/// The CRC-24Q of `count` bits from `first` on, of generator 0x864CFB, that Galileo and RTCM 3 end their
/// messages with. Throws std::out_of_range.
std::uint32_t crc24q(const BitString& bits, std::size_t first, std::size_t count);

}  // namespace multipath_localization
