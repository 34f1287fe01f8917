#include "estimators/pseudorange_mixture/receiver_prior.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

using State = PseudorangeBelief;

constexpr double kWidening = 4.0;  // of variances: of 2 sigma
constexpr double kSlope = 0.05;    // of roads, steep ones among them

}  // namespace

ReceiverPrior receiver_prior(const PseudorangeBelief& followed, const SatelliteSlots& slots,
                             const ReceiverPrior& unknown, double position_variance) {
  const auto widened = [&](int state, double most) {
    return std::min(kWidening * followed.covariance(state, state), most);
  };
  ReceiverPrior prior = unknown;
  prior.up = followed.mean(State::kUp);
  prior.up_variance = std::min(widened(State::kUp, unknown.up_variance) + square(kSlope) * position_variance,
                               unknown.up_variance);
  prior.zenith_delay = followed.mean(State::kZenithDelay);
  prior.zenith_delay_variance = widened(State::kZenithDelay, unknown.zenith_delay_variance);
  for (int slot = 0; slot < slots.size(); ++slot) {
    const SlotOwner& owner = slots.owner(slot);
    if (owner.satellite) continue;
    const auto k = static_cast<std::size_t>(owner.constellation);
    prior.offset[k] = followed.mean(State::state_of(slot));
    prior.offset_variance[k] = widened(State::state_of(slot), unknown.offset_variance[k]);
  }
  return prior;
}

void make_as_sure(PseudorangeBelief& belief, const SatelliteSlots& slots, const ReceiverPrior& prior) {
  auto& P = belief.covariance;
  // What lengthens all ranges alike stays as correlated with the height as it was.
  const double factor = std::sqrt(prior.up_variance / P(State::kUp, State::kUp));
  P.row(State::kUp) *= factor;
  P.col(State::kUp) *= factor;
  belief.renew(State::kZenithDelay, prior.zenith_delay, prior.zenith_delay_variance);
  for (int slot = 0; slot < slots.size(); ++slot) {
    const SlotOwner& owner = slots.owner(slot);
    const int state = State::state_of(slot);
    if (owner.satellite) continue;
    belief.renew(state, belief.mean(state),
                 prior.offset_variance[static_cast<std::size_t>(owner.constellation)]);
  }
}

}  // namespace multipath_localization
