#include "multipath_localization/estimators/hypothesis_banks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

constexpr double kMinLogWeight = -600.0;  ///< keeps every hypothesis representable
constexpr double kLeastPrior = 1e-9;
constexpr double kCountTolerance = 0.15;  ///< of all particles, before a bank is resized

std::size_t draw(const std::vector<double>& cumulative, double u) {
  const auto place = std::upper_bound(cumulative.begin(), cumulative.end(), u * cumulative.back());
  return std::min(static_cast<std::size_t>(place - cumulative.begin()), cumulative.size() - 1);
}

/// Particles of one class and the running sum of their weights.
struct Bank {
  std::vector<std::size_t> members;
  std::vector<double> cumulative;
};

std::array<Bank, kReceiverClassCount> banks_of(const std::vector<BeliefParticle>& particles) {
  std::array<Bank, kReceiverClassCount> banks;
  ClassCounts sizes{};
  for (const BeliefParticle& particle : particles) ++sizes[particle.receiver];
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    banks[k].members.reserve(sizes[k]);
    banks[k].cumulative.reserve(sizes[k]);
  }
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Bank& bank = banks[particles[i].receiver];
    const double before = bank.cumulative.empty() ? 0.0 : bank.cumulative.back();
    bank.members.push_back(i);
    bank.cumulative.push_back(before + particles[i].weight);
  }
  return banks;
}

/// A newcomer to a class: pose and odometry constants kept, bias forgotten.
BeliefParticle converted(BeliefParticle particle, std::size_t to, const ReceiverClass& receiver,
                         RandomStream& random) {
  particle.receiver = to;
  particle.mode.shadow = random.uniform() < receiver.shadow_at_start;
  particle.mode.noisy = receiver.always_shadow || random.uniform() < receiver.shadow_at_start;
  particle.mode.slipping = false;
  const double sigma = particle.mode.shadow ? receiver.shadow_bias_sigma : receiver.open_bias_sigma;
  particle.belief.renew_bias(sigma * sigma);
  return particle;
}

double effective_size(const Bank& bank, const std::vector<BeliefParticle>& particles) {
  double squares = 0.0;
  for (const std::size_t i : bank.members) squares += particles[i].weight * particles[i].weight;
  return bank.cumulative.back() * bank.cumulative.back() / squares;
}

void append_resampled(const Bank& bank, std::size_t count, const std::vector<BeliefParticle>& from, double u,
                      std::vector<BeliefParticle>& to) {
  std::size_t j = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double target = (static_cast<double>(i) + u) / static_cast<double>(count) * bank.cumulative.back();
    while (j + 1 < bank.members.size() && bank.cumulative[j] <= target) ++j;
    to.push_back(from[bank.members[j]]);
    to.back().weight = bank.cumulative.back() / static_cast<double>(count);
  }
}

using Banks = std::array<Bank, kReceiverClassCount>;

/// Weight that passes between classes in one step.
struct ClassFlow {
  std::array<PerClass, kReceiverClassCount> between{};  ///< [from][to]
  PerClass received{};
  PerClass after{};

  ClassFlow(const PerClass& before, const Banks& banks, const PerClass& entry) : after(before) {
    for (std::size_t from = 0; from < kReceiverClassCount; ++from) {
      for (std::size_t to = 0; to < kReceiverClassCount; ++to) {
        if (from == to || banks[to].members.empty()) continue;
        between[from][to] = before[from] * entry[to];
        after[from] -= between[from][to];
        after[to] += between[from][to];
        received[to] += between[from][to];
      }
    }
  }

  /// Draws the class that a newcomer to `to` comes from.
  [[nodiscard]] std::size_t giver(std::size_t to, double u) const {
    double share = u * received[to];
    std::size_t from = 0;
    for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
      if (between[k][to] <= 0.0) continue;
      from = k;
      share -= between[k][to];
      if (share < 0.0) break;
    }
    return from;
  }
};

/// Scales the weights of these members to this sum.
void scale_to(double total, const std::vector<std::size_t>& members, std::vector<BeliefParticle>& particles) {
  double sum = 0.0;
  for (const std::size_t i : members) sum += particles[i].weight;
  for (const std::size_t i : members) particles[i].weight *= total / sum;
}

/// Which banks have too few effective members; nothing when no bank is due for resampling or resizing.
std::optional<std::array<bool, kReceiverClassCount>> depleted_banks(
    const Banks& banks, const ClassCounts& counts, const std::vector<BeliefParticle>& particles,
    double ess_fraction) {
  const double tolerance = kCountTolerance * static_cast<double>(particles.size());
  std::array<bool, kReceiverClassCount> depleted{};
  bool due = false;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    if (banks[k].members.empty()) continue;
    const auto size = static_cast<double>(banks[k].members.size());
    depleted[k] = effective_size(banks[k], particles) < ess_fraction * size;
    due = due || depleted[k] || std::abs(static_cast<double>(counts[k]) - size) > tolerance;
  }
  if (!due) return std::nullopt;
  return depleted;
}

}  // namespace

PerClass class_weights(const std::vector<BeliefParticle>& particles) {
  PerClass weights{};
  for (const BeliefParticle& particle : particles) weights[particle.receiver] += particle.weight;
  return weights;
}

ClassCounts class_counts(const PerClass& weights, std::size_t count, double floor) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto heaviest =
      static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  const auto share = static_cast<std::size_t>(std::ceil(floor * static_cast<double>(count)));
  const std::size_t least = std::max<std::size_t>(1, share);
  ClassCounts counts{};
  std::size_t used = 0;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    if (k == heaviest || weights[k] <= 0.0) continue;
    const auto due = static_cast<std::size_t>(std::lround(static_cast<double>(count) * weights[k] / total));
    counts[k] = std::max(least, due);
    used += counts[k];
  }
  counts[heaviest] = count - std::min(count, used);
  return counts;
}

PerClass prior_probabilities(const ReceiverClasses& classes) {
  PerClass probability{};
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    const bool possible = classes[k].prior > 0.0 || classes[k].entry_rate > 0.0;
    probability[k] = possible ? std::max(kLeastPrior, classes[k].prior) : 0.0;
  }
  const double total = std::accumulate(probability.begin(), probability.end(), 0.0);
  if (total <= 0.0) throw ParameterError("no receiver class has a prior or an entry_rate above 0");
  for (double& one : probability) one /= total;
  return probability;
}

PerClass entry_probabilities(const ReceiverClasses& classes, double dt) {
  PerClass entry{};
  for (std::size_t k = 0; k < kReceiverClassCount; ++k)
    entry[k] = 1.0 - std::exp(-classes[k].entry_rate * dt);
  return entry;
}

void mix_classes(std::vector<BeliefParticle>& particles, const ReceiverClasses& classes,
                 const PerClass& entry, RandomStream& random) {
  const auto banks = banks_of(particles);
  const ClassFlow flow(class_weights(particles), banks, entry);
  const std::vector<BeliefParticle> old = particles;
  for (std::size_t to = 0; to < kReceiverClassCount; ++to) {
    const std::vector<std::size_t>& members = banks[to].members;
    if (members.empty() || flow.after[to] <= 0.0) continue;
    const auto size = static_cast<double>(members.size());
    const auto newcomers =
        static_cast<std::size_t>(flow.received[to] / flow.after[to] * size + random.uniform());
    for (std::size_t n = 0; n < newcomers; ++n) {
      const auto victim = members[static_cast<std::size_t>(random.uniform() * size)];
      const std::size_t from = flow.giver(to, random.uniform());
      if (flow.between[from][to] <= 0.0) continue;
      const std::size_t parent = banks[from].members[draw(banks[from].cumulative, random.uniform())];
      particles[victim] = converted(old[parent], to, classes[to], random);
      particles[victim].weight = flow.after[to] / size;
    }
    scale_to(flow.after[to], members, particles);
  }
}

void reweigh(std::vector<BeliefParticle>& particles, const std::vector<double>& log_likelihood,
             double exponent) {
  PerClass highest;
  highest.fill(-std::numeric_limits<double>::infinity());
  std::vector<double> log_weight(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    log_weight[i] = std::log(particles[i].weight) + log_likelihood[i];
    highest[particles[i].receiver] = std::max(highest[particles[i].receiver], log_weight[i]);
  }
  const PerClass before = class_weights(particles);
  PerClass sum{};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    sum[particles[i].receiver] += std::exp(log_weight[i] - highest[particles[i].receiver]);
  }
  double peak = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const std::size_t k = particles[i].receiver;
    const double evidence = highest[k] + std::log(sum[k]) - std::log(before[k]);
    log_weight[i] += (exponent - 1.0) * evidence;
    peak = std::max(peak, log_weight[i]);
  }
  double total = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles[i].weight = std::exp(std::max(log_weight[i] - peak, kMinLogWeight));
    total += particles[i].weight;
  }
  for (BeliefParticle& particle : particles) particle.weight /= total;
}

void resample_banks(std::vector<BeliefParticle>& particles, std::size_t count, double floor,
                    double ess_fraction, RandomStream& random) {
  const auto banks = banks_of(particles);
  const ClassCounts counts = class_counts(class_weights(particles), count, floor);
  const auto depleted = depleted_banks(banks, counts, particles, ess_fraction);
  if (!depleted) return;
  std::vector<BeliefParticle> next;
  next.reserve(count);
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    const double u = random.uniform();
    if (counts[k] == 0) continue;
    if (counts[k] == banks[k].members.size() && !(*depleted)[k]) {
      for (const std::size_t i : banks[k].members) next.push_back(particles[i]);
    } else {
      append_resampled(banks[k], counts[k], particles, u, next);
    }
  }
  particles.swap(next);
}

}  // namespace multipath_localization
