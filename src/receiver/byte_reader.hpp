#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace multipath_localization {

/// Reads numbers one after the other, the lowest byte of each first, whatever this machine's order is.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  /// An integer or a floating-point number (IEEE 754). Throws std::out_of_range at the end.
  template <class Number>
  Number take();

  void skip(std::size_t count) { place_ += count; }

  [[nodiscard]] std::size_t left() const { return place_ < bytes_.size() ? bytes_.size() - place_ : 0; }

 private:
  std::string_view bytes_;
  std::size_t place_ = 0;
};

template <class Number>
Number ByteReader::take() {
  if (left() < sizeof(Number)) throw std::out_of_range("the bytes end within a number");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[place_ + i])) << (8 * i);
  }
  place_ += sizeof(Number);
  if constexpr (std::is_integral_v<Number>) {
    return static_cast<Number>(bits);
  } else {
    using Whole = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
    const auto whole = static_cast<Whole>(bits);
    Number number;
    std::memcpy(&number, &whole, sizeof(number));
    return number;
  }
}

}  // namespace multipath_localization
