#include "simd/random_block.hpp"

#include <cmath>

#include "core/threefry.hpp"
#include "simd/elementary.hpp"

namespace multipath_localization {

namespace {

void threefry_block(std::uint64_t seed, std::uint32_t step, std::uint32_t first, RandomWords* words) {
  const auto schedule =
      threefry::schedule({static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U), 0, 0});
#pragma omp simd
  for (std::size_t i = 0; i < kBlockStreams; ++i) {
    std::uint32_t x0 = first + static_cast<std::uint32_t>(i) + schedule[0];
    std::uint32_t x1 = step + schedule[1];
    std::uint32_t x2 = schedule[2];
    std::uint32_t x3 = schedule[3];
    threefry::rounds<0, 12>(x0, x1, x2, x3, schedule);
    words->word[0][i] = x0;
    words->word[1][i] = x1;
    words->word[2][i] = x2;
    words->word[3][i] = x3;
  }
}

/// Box and Muller's pair: the radius by one uniform number in (0, 1], the angle by another in [-pi, pi].
void box_muller(const std::uint32_t* radius, const std::uint32_t* angle, float* a, float* b) {
#pragma omp simd
  for (std::size_t i = 0; i < kBlockStreams; ++i) {
    const float u = static_cast<float>(static_cast<std::int32_t>(radius[i] >> 1U)) * 0x1p-31F + 0x1p-32F;
    const float r = std::sqrt(-2.0F * elementary::single::log(u));
    const auto [s, c] =
        elementary::single::sincos_pi(static_cast<float>(static_cast<std::int32_t>(angle[i])) * 0x1p-31F);
    a[i] = r * c;
    b[i] = r * s;
  }
}

}  // namespace

void random_words(InstructionSet set, std::uint64_t seed, std::uint32_t step, std::uint32_t first,
                  RandomWords& words) {
  run<threefry_block>(set, seed, step, first, &words);
}

void standard_normals(InstructionSet set, const RandomWords& words, Normals& normals) {
  for (std::size_t pair = 0; pair < 2; ++pair) {
    float* a = normals.all.data() + 2 * pair * kBlockStreams;
    run<box_muller>(set, words.word[2 * pair].data(), words.word[2 * pair + 1].data(), a, a + kBlockStreams);
  }
}

}  // namespace multipath_localization
