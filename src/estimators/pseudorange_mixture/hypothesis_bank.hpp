#pragma once

#include <vector>

#include "estimators/pseudorange_mixture/dominant_cluster.hpp"
#include "estimators/pseudorange_mixture/pseudorange_hypothesis.hpp"

namespace multipath_localization {

/// exp(log weight) of each, scaled to the sum 1. `bank` must not be empty.
std::vector<double> weights_of(const std::vector<PseudorangeHypothesis>& bank);

/// Scales the weights to the sum 1, drops hypotheses lighter than `least` of the heaviest, and lets the
/// heavier of two that agree, to a part of their own uncertainty, inherit the other's weight. Keeps the
/// order.
void thin_out(std::vector<PseudorangeHypothesis>& bank, double least);

/// The planar parts with their weights.
std::vector<WeightedBelief> planar(const std::vector<PseudorangeHypothesis>& bank);

}  // namespace multipath_localization
