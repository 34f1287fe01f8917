#include "multipath_localization/core/random.hpp"

#include <cmath>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

constexpr std::array<int, 8> kRotationEven = {10, 11, 13, 23, 6, 17, 25, 18};
constexpr std::array<int, 8> kRotationOdd = {26, 21, 27, 5, 20, 11, 10, 20};
constexpr std::uint32_t kParity = 0x1BD11BDAU;

std::uint32_t rotate_left(std::uint32_t x, int bits) { return (x << bits) | (x >> (32 - bits)); }

void mix(std::uint32_t& a, std::uint32_t& b, int bits) {
  a += b;
  b = rotate_left(b, bits) ^ a;
}

}  // namespace

template <int Rounds>
std::array<std::uint32_t, 4> threefry4x32(const std::array<std::uint32_t, 4>& counter,
                                          const std::array<std::uint32_t, 4>& key) {
  const std::array<std::uint32_t, 5> schedule = {key[0], key[1], key[2], key[3],
                                                 kParity ^ key[0] ^ key[1] ^ key[2] ^ key[3]};
  std::array<std::uint32_t, 4> x{};
  for (std::size_t i = 0; i < 4; ++i) x[i] = counter[i] + schedule[i];
  for (std::size_t round = 0; round < Rounds; ++round) {
    const bool swapped = round % 2 == 1;
    mix(x[0], swapped ? x[3] : x[1], kRotationEven[round % 8]);
    mix(x[2], swapped ? x[1] : x[3], kRotationOdd[round % 8]);
    if (round % 4 != 3) continue;
    const std::size_t injection = round / 4 + 1;
    for (std::size_t i = 0; i < 4; ++i) x[i] += schedule[(injection + i) % 5];
    x[3] += static_cast<std::uint32_t>(injection);
  }
  return x;
}

template std::array<std::uint32_t, 4> threefry4x32<12>(const std::array<std::uint32_t, 4>& counter,
                                                       const std::array<std::uint32_t, 4>& key);
template std::array<std::uint32_t, 4> threefry4x32<20>(const std::array<std::uint32_t, 4>& counter,
                                                       const std::array<std::uint32_t, 4>& key);

std::uint32_t RandomStream::word() {
  if (used_ == 4) {
    words_ =
        threefry4x32<12>({particle_, step_, block_++, 0},
                         {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32), 0, 0});
    used_ = 0;
  }
  return words_[static_cast<std::size_t>(used_++)];
}

double RandomStream::uniform() {
  const std::uint64_t high = word();
  const std::uint64_t low = word();
  return static_cast<double>(((high << 32) | low) >> 11) * 0x1p-53;
}

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  const double angle = 2.0 * kPi * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace multipath_localization
