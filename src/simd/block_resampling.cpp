#include "simd/block_resampling.hpp"

#include <algorithm>
#include <array>

namespace multipath_localization {

namespace {

constexpr std::int32_t kAtOnce = 8;  ///< teeth that are written for each particle, a vector of them

/// The comb's teeth stand at (k + uniform) / count of the total, k = 0 .. count - 1.
struct Comb {
  double teeth_per_weight;
  double uniform;
  double count;
};

/// How many teeth lie below each cumulated weight of a block, and not fewer than were taken before it.
void teeth_below(const double* cumulated, double scale, double base, Comb comb, std::int32_t taken,
                 std::int32_t* teeth) {
  const auto least = static_cast<double>(taken);
#pragma omp simd
  for (std::size_t i = 0; i < kBlockSize; ++i) {
    const double place = (base + scale * cumulated[i]) * comb.teeth_per_weight - comb.uniform;
    const auto whole = static_cast<double>(static_cast<std::int32_t>(place));
    const double below = whole < place ? whole + 1.0 : whole;
    const double in_comb = below < comb.count ? below : comb.count;
    teeth[i] = static_cast<std::int32_t>(in_comb > least ? in_comb : least);
  }
}

/// Each particle takes its teeth: so many at once, whether they are its own or not, since its successor
/// overwrites those that are not; of more, the rest. Gives the teeth that are taken.
std::int32_t take_teeth(const std::int32_t* teeth, std::int32_t taken, std::uint32_t first, std::size_t size,
                        std::uint32_t* ancestors) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t particle = first + static_cast<std::uint32_t>(i);
    std::uint32_t* own = ancestors + taken;
    for (std::int32_t k = 0; k < kAtOnce; ++k) own[k] = particle;
    if (teeth[i] - taken > kAtOnce) std::fill(own + kAtOnce, ancestors + teeth[i], particle);
    taken = teeth[i];
  }
  return taken;
}

std::uint32_t last_with_weight(const BlockWeights& weights) {
  std::size_t i = weights.size() - 1;
  while (i > 0 && !(weights[i] > 0.0)) --i;
  return static_cast<std::uint32_t>(i);
}

}  // namespace

void systematic_resampling(InstructionSet set, const BlockWeights& weights, std::size_t count, double uniform,
                           std::vector<std::uint32_t>& ancestors) {
  const Comb comb{static_cast<double>(count) / weights.total(), uniform, static_cast<double>(count)};
  ancestors.resize(count + kAtOnce);
  std::int32_t taken = 0;
  std::array<std::int32_t, kBlockSize> teeth;
  for (std::size_t block = 0; block < blocks_of(weights.size()); ++block) {
    run<teeth_below>(set, weights.cumulated(block), weights.scale(block), weights.base(block), comb, taken,
                     teeth.data());
    taken = run<take_teeth>(set, teeth.data(), taken, static_cast<std::uint32_t>(block_begin(block)),
                            block_length(block, weights.size()), ancestors.data());
  }
  ancestors.resize(count);
  // Rounding may leave the sum short of the last tooth, which then belongs to the last positive weight.
  if (taken < static_cast<std::int32_t>(count))
    std::fill(ancestors.begin() + taken, ancestors.end(), last_with_weight(weights));
}

}  // namespace multipath_localization
