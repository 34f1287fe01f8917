#include <algorithm>
#include <cmath>
#include <utility>

#include "estimators/multipath/hypothesis_cloud.hpp"
#include "estimators/multipath/receiver_watch.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr std::uint64_t kReceiverSeed = 0xA0761D6478BD642FU;  ///< draws that one receiver alone does not take
/// One that is silent for longer beside others is forgotten, and begins anew when it comes back [s].
constexpr double kForgotten = 20.0;

/// Errors of a receiver whose first fix declares `sigma` [m].
ReceiverErrors draw_receiver(double sigma, double largest_bias, RandomStream& random) {
  ReceiverErrors errors;
  errors.law = draw_fix_law(random);
  errors.level = sigma;
  errors.in_shadow = random.uniform() < kShadowAtStart;
  errors.shadow_law = draw_shadow_law(errors.law.open_sigma() * sigma, largest_bias, random);
  return errors;
}

}  // namespace

FixErrors errors_of_other(const std::vector<Hypothesis>& hypotheses, std::size_t k) {
  FixErrors all;
  for (const Hypothesis& h : hypotheses) {
    const double w = std::exp(h.log_weight);
    const ReceiverErrors& errors = h.others.errors[k];
    const double noise = errors.in_shadow ? errors.shadow_law.noise : 0.0;
    all.bias += w * h.others.bias(k);
    all.white_variance += w * (errors.law.white_variance() * square(errors.level) + square(noise));
    all.slow_variance += w * square(errors.law.slow_sigma() * errors.level);
    all.shadow += errors.in_shadow ? w : 0.0;
  }
  for (const Hypothesis& h : hypotheses) {
    const Eigen::Vector2d off = h.others.bias(k) - all.bias;
    all.bias_covariance += std::exp(h.log_weight) * (h.others.bias_covariance(k) + off * off.transpose());
  }
  return all;
}

double Mixture::least_shadow() const {
  double least = shadow;
  for (const FixErrors& other : others) least = std::min(least, other.shadow);
  return least;
}

FixErrors HypothesisCloud::errors_of(std::size_t receiver) const {
  if (receivers_.attended.value_or(receiver) == receiver) {
    return {mixture_.bias, mixture_.bias_covariance, mixture_.white_variance, mixture_.slow_variance,
            mixture_.shadow};
  }
  const std::size_t place = receivers_.place_of(receiver);
  return place < mixture_.others.size() ? mixture_.others[place] : FixErrors{};
}

std::size_t followed(const HypothesisCloud& cloud) {
  const auto error = [&](std::size_t receiver) {
    const FixErrors errors = cloud.errors_of(receiver);
    return errors.white_variance + errors.slow_variance + errors.bias.squaredNorm();
  };
  std::size_t best = cloud.receivers().attended.value_or(0);
  for (const ReceiverRoster::Other& other : cloud.receivers().others) {
    if (other.silence <= kOutage && error(other.receiver) < error(best)) best = other.receiver;
  }
  return best;
}

void tell_receivers(const HypothesisCloud& cloud, PoseEstimate& estimate) {
  const std::vector<std::size_t> known = cloud.receivers().known();
  const FixErrors first = cloud.errors_of(known.empty() ? 0 : known.front());
  estimate.bias = first.bias;
  estimate.bias_covariance = first.bias_covariance;
  if (known.size() < 2) return;
  for (const std::size_t receiver : known) {
    const FixErrors errors = cloud.errors_of(receiver);
    estimate.receivers.push_back({receiver, errors.shadow, errors.bias});
  }
}

/// Lets the state of each hypothesis hold the errors of the receiver of a fix.
void HypothesisCloud::attend(const Sighting& sighting) {
  const std::size_t receiver = sighting.fix.receiver;
  std::vector<ReceiverRoster::Other>& others = receivers_.others;
  if (!receivers_.attended) receivers_.attended = receiver;
  for (ReceiverRoster::Other& other : others) other.silence += sighting.unseen();
  if (receivers_.attended != receiver) {
    const std::size_t place = receivers_.place_of(receiver);
    const double sigma = mean_sigma(sighting.fix.covariance);
    if (place == others.size()) others.push_back({receiver, sigma, 0.0});
    for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
      Hypothesis& h = hypotheses_[i];
      RandomStream random(seed_ ^ kReceiverSeed, step_, static_cast<std::uint32_t>(i));
      if (place == h.others.errors.size()) {
        add_receiver(h, draw_receiver(sigma, sighting.largest_bias, random));
      }
      multipath::attend(h, place);
    }
    others[place] = {*std::exchange(receivers_.attended, receiver),
                     std::exchange(receivers_.level, others[place].level), sighting.unseen(),
                     std::exchange(receivers_.told, others[place].told)};
    refresh();
  }
  const auto silent = std::find_if(others.begin(), others.end(), [](const ReceiverRoster::Other& other) {
    return other.silence > kForgotten;
  });
  if (silent == others.end()) return;
  for (Hypothesis& h : hypotheses_) {
    forget_receiver(h, static_cast<std::size_t>(silent - others.begin()));
  }
  *silent = others.back();
  others.pop_back();
  refresh();
}

}  // namespace multipath_localization::multipath
