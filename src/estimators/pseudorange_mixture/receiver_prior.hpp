#pragma once

#include <array>

#include "estimators/pseudorange_mixture/pseudorange_belief.hpp"
#include "estimators/pseudorange_mixture/satellite_slots.hpp"
#include "multipath_localization/core/constellation.hpp"

namespace multipath_localization {

/// What is known of height, clocks and sky before an epoch, which hardly depends on where the robot is.
struct ReceiverPrior {
  double up = 0.0;                                        ///< of the antenna in map [m]
  double up_variance = 0.0;                               ///< [m^2]
  std::array<double, kConstellations> offset{};           ///< of the other clocks against that of GPS [m]
  std::array<double, kConstellations> offset_variance{};  ///< [m^2]
  double zenith_delay = 0.0;                              ///< [m]
  double zenith_delay_variance = 0.0;                     ///< [m^2]
};

/// What a hypothesis at another place may take over of one that has followed the receiver, with twice its
/// standard deviations, as where that one is wrong it has height and clocks wrong as well, but never more
/// than those of `unknown`. `position_variance` is how far off the other place may be, whose height differs
/// by the slope of roads [m^2].
ReceiverPrior receiver_prior(const PseudorangeBelief& followed, const SatelliteSlots& slots,
                             const ReceiverPrior& unknown, double position_variance);

/// Makes a belief that starts at a place as sure of height, clocks and sky as the prior is: variances of all
/// of them, and the mean of the delay at the zenith; the belief's place goes with heights and clocks of its
/// own.
void make_as_sure(PseudorangeBelief& belief, const SatelliteSlots& slots, const ReceiverPrior& prior);

}  // namespace multipath_localization
