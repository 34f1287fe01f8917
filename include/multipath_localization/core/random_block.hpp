#pragma once

#include "multipath_localization/core/block.hpp"
#include "multipath_localization/core/instruction_set.hpp"

namespace multipath_localization {

/// Four random words of each particle of a block.
struct RandomWords {
  std::array<std::array<std::uint32_t, kBlockSize>, 4> word;
};

/// The first four words of `RandomStream(seed, step, i)` for the particles i = first, first + 1, ...
void random_words(InstructionSet set, std::uint64_t seed, std::uint32_t step, std::uint32_t first,
                  RandomWords& words);

/// Three standard normals of each particle of a block, to the 24 bits of single precision.
struct Normals {
  using Values = std::array<float, kBlockSize>;
  Values first;
  Values second;
  Values third;
};

/// By Box-Muller: nothing lies beyond 6.7 sigma. The pair that the last two words make is shared by particles
/// i and i + kBlockSize / 2.
void standard_normals(InstructionSet set, const RandomWords& words, Normals& normals);

}  // namespace multipath_localization
