#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "simd/block_weights.hpp"

namespace multipath_localization {

/// Systematic resampling, Eqs. (40), (43) of [NIS], of thousands of particles without a branch: the ancestors
/// of `count` particles, index i drawn weights[i] * count times, rounded up or down, and exactly that often
/// on average; in ascending order. Needs one uniform number in [0, 1).
void systematic_resampling(InstructionSet set, const BlockWeights& weights, std::size_t count, double uniform,
                           std::vector<std::uint32_t>& ancestors);

}  // namespace multipath_localization
