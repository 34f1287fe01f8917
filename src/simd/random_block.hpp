#pragma once

#include "simd/block.hpp"
#include "simd/instruction_set.hpp"

namespace multipath_localization {

/// Streams whose four words make a block's normals, three a particle.
inline constexpr std::size_t kBlockStreams = kBlockSize * 3 / 4;

/// Four random words of each of a block's streams.
struct RandomWords {
  std::array<std::array<std::uint32_t, kBlockStreams>, 4> word;
};

/// The first four words of `RandomStream(seed, step, i)` for i = first, first + 1, ...
void random_words(InstructionSet set, std::uint64_t seed, std::uint32_t step, std::uint32_t first,
                  RandomWords& words);

/// Three standard normals of each particle of a block, to the 24 bits of single precision.
struct Normals {
  std::array<float, 3 * kBlockSize> all;

  [[nodiscard]] const float* first() const { return all.data(); }
  [[nodiscard]] const float* second() const { return all.data() + kBlockSize; }
  [[nodiscard]] const float* third() const { return all.data() + 2 * kBlockSize; }
};

/// By Box-Muller, of each two words a pair: nothing lies beyond 6.7 sigma.
void standard_normals(InstructionSet set, const RandomWords& words, Normals& normals);

}  // namespace multipath_localization
