#include "multipath_localization/filters/block_resampling.hpp"

#include <array>

namespace multipath_localization {

namespace {

/// The comb's teeth stand at (k + uniform) / count of the total, k = 0 .. count - 1.
struct Comb {
  double teeth_per_weight;
  double uniform;
  double count;
};

/// How many teeth lie below each cumulated weight of a block.
void teeth_below(const double* cumulated, double scale, double base, Comb comb, std::int32_t* teeth) {
#pragma omp simd
  for (std::size_t i = 0; i < kBlockSize; ++i) {
    const double place = (base + scale * cumulated[i]) * comb.teeth_per_weight - comb.uniform;
    const auto whole = static_cast<double>(static_cast<std::int32_t>(place));
    const double below = whole < place ? whole + 1.0 : whole;
    teeth[i] = static_cast<std::int32_t>(below < comb.count ? below : comb.count);
  }
}

/// Each particle marks the first of its teeth; one that has none marks that of its successor, which then
/// overwrites it. Gives the teeth that are taken.
std::int32_t mark_first_teeth(const std::int32_t* teeth, std::int32_t taken, std::uint32_t first,
                              std::size_t size, std::uint32_t* ancestors) {
  for (std::size_t i = 0; i < size; ++i) {
    ancestors[taken] = first + static_cast<std::uint32_t>(i);
    taken = teeth[i] > taken ? teeth[i] : taken;
  }
  return taken;
}

std::uint32_t last_with_weight(const BlockWeights& weights) {
  std::size_t i = weights.size() - 1;
  while (i > 0 && !(weights[i] > 0.0)) --i;
  return static_cast<std::uint32_t>(i);
}

/// The teeth between two marks belong to the earlier.
void fill_between_marks(std::vector<std::uint32_t>& ancestors) {
  std::uint32_t latest = 0;
  for (std::uint32_t& ancestor : ancestors) ancestor = latest = ancestor > latest ? ancestor : latest;
}

}  // namespace

void systematic_resampling(InstructionSet set, const BlockWeights& weights, std::size_t count, double uniform,
                           std::vector<std::uint32_t>& ancestors) {
  const Comb comb{static_cast<double>(count) / weights.total(), uniform, static_cast<double>(count)};
  ancestors.assign(count + 1, 0);
  std::int32_t taken = 0;
  std::array<std::int32_t, kBlockSize> teeth;
  for (std::size_t block = 0; block < blocks_of(weights.size()); ++block) {
    run<teeth_below>(set, weights.cumulated(block), weights.scale(block), weights.base(block), comb,
                     teeth.data());
    taken = mark_first_teeth(teeth.data(), taken, static_cast<std::uint32_t>(block_begin(block)),
                             block_length(block, weights.size()), ancestors.data());
  }
  // Rounding may leave the sum short of the last tooth, which then belongs to the last positive weight.
  if (taken < static_cast<std::int32_t>(count))
    ancestors[static_cast<std::size_t>(taken)] = last_with_weight(weights);
  ancestors.resize(count);
  fill_between_marks(ancestors);
}

}  // namespace multipath_localization
