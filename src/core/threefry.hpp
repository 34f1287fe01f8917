#pragma once

#include <array>
#include <cstdint>

/// The rounds of Threefry (Salmon et al., SC 2011), which are additions, rotations and exclusive-ors alone:
/// every instruction set has these for vectors.
namespace multipath_localization::threefry {

inline constexpr std::array<int, 8> kRotationEven = {10, 11, 13, 23, 6, 17, 25, 18};
inline constexpr std::array<int, 8> kRotationOdd = {26, 21, 27, 5, 20, 11, 10, 20};
inline constexpr std::uint32_t kParity = 0x1BD11BDAU;

template <int Bits>
inline void mix(std::uint32_t& a, std::uint32_t& b) {
  a += b;
  b = ((b << Bits) | (b >> (32 - Bits))) ^ a;
}

/// Round `Round` and all after it, up to `Rounds`. Words apart, not in an array, which would stop a loop over
/// particles from being vectorised.
template <int Round, int Rounds>
inline void rounds(std::uint32_t& x0, std::uint32_t& x1, std::uint32_t& x2, std::uint32_t& x3,
                   const std::array<std::uint32_t, 5>& schedule) {
  if constexpr (Round < Rounds) {
    constexpr bool kSwapped = Round % 2 == 1;
    mix<kRotationEven[Round % 8]>(x0, kSwapped ? x3 : x1);
    mix<kRotationOdd[Round % 8]>(x2, kSwapped ? x1 : x3);
    if constexpr (Round % 4 == 3) {
      constexpr int kInjection = Round / 4 + 1;
      x0 += schedule[kInjection % 5];
      x1 += schedule[(kInjection + 1) % 5];
      x2 += schedule[(kInjection + 2) % 5];
      x3 += schedule[(kInjection + 3) % 5] + std::uint32_t{kInjection};
    }
    rounds<Round + 1, Rounds>(x0, x1, x2, x3, schedule);
  }
}

inline std::array<std::uint32_t, 5> schedule(const std::array<std::uint32_t, 4>& key) {
  return {key[0], key[1], key[2], key[3], kParity ^ key[0] ^ key[1] ^ key[2] ^ key[3]};
}

}  // namespace multipath_localization::threefry
