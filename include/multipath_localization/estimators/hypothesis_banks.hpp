#pragma once

#include <array>
#include <vector>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/belief.hpp"
#include "multipath_localization/estimators/fix_modes.hpp"

namespace multipath_localization {

/// One Rao-Blackwellised particle: sampled mode and receiver class, Kalman filter for the rest.
struct BeliefParticle {
  Belief belief;
  FixMode mode;
  std::size_t receiver = 0;  ///< index into ReceiverClasses
  double weight = 1.0;       ///< all sum to 1
};

/// One number per receiver class.
using PerClass = std::array<double, kReceiverClassCount>;
using ClassCounts = std::array<std::size_t, kReceiverClassCount>;

/// Sum of the weights of each class.
PerClass class_weights(const std::vector<BeliefParticle>& particles);

/// How many of `count` particles each class gets in proportion to `weights`, not less than one and the share
/// `floor` for any class with weight; the heaviest takes what is left.
ClassCounts class_counts(const PerClass& weights, std::size_t count, double floor);

/// Probability of each class at the start: as the priors say, but more than nothing for one that can be
/// entered. Throws ParameterError where no class can be.
PerClass prior_probabilities(const ReceiverClasses& classes);

/// Probability of changing into each class from another within `dt` seconds.
PerClass entry_probabilities(const ReceiverClasses& classes, double dt);

/// Lets the receiver class change, with these probabilities of entry, as a Markov chain on the weights of the
/// banks. A fraction of each receiving bank is replaced by draws from the giving ones, which keep their pose
/// and forget their bias: a beaten bank is re-seeded continually from the winner.
void mix_classes(std::vector<BeliefParticle>& particles, const ReceiverClasses& classes,
                 const PerClass& entry, RandomStream& random);

/// Multiplies the weights by exp(log_likelihood) and normalises. Within a class as they are; between classes
/// tempered by `exponent` in [0, 1]: errors of fixes a moment apart are no independent evidence of the class.
void reweigh(std::vector<BeliefParticle>& particles, const std::vector<double>& log_likelihood,
             double exponent);

/// Systematic resampling to `count` particles, bank by bank, when the effective sample size of one falls
/// below `ess_fraction` of it or its due count has moved far. Keeps the sum of weights of each class.
void resample_banks(std::vector<BeliefParticle>& particles, std::size_t count, double floor,
                    double ess_fraction, RandomStream& random);

}  // namespace multipath_localization
