#include "estimators/pseudorange_mixture/hypothesis_bank.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kSamePlace = 0.3;      // of the smaller standard deviation
constexpr double kSameHeading = 0.3;    // likewise
constexpr double kLeastDistance = 0.3;  // [m]
constexpr double kLeastTurn = 0.01;     // [rad]

double position_sigma(const Belief& belief) {
  return std::sqrt(0.5 * (belief.covariance(kX, kX) + belief.covariance(kY, kY)));
}

double yaw_sigma(const Belief& belief) { return std::sqrt(belief.covariance(kYaw, kYaw)); }

bool agree(const Belief& a, const Belief& b) {
  const double turn = std::abs(angle_difference(a.mean(kYaw), b.mean(kYaw)));
  const double distance = (a.mean.head<2>() - b.mean.head<2>()).norm();
  return turn < std::max(kLeastTurn, kSameHeading * std::min(yaw_sigma(a), yaw_sigma(b))) &&
         distance < std::max(kLeastDistance, kSamePlace * std::min(position_sigma(a), position_sigma(b)));
}

}  // namespace

std::vector<double> weights_of(const std::vector<PseudorangeHypothesis>& bank) {
  double highest = bank.front().log_weight;
  for (const auto& hypothesis : bank) highest = std::max(highest, hypothesis.log_weight);
  std::vector<double> weights;
  weights.reserve(bank.size());
  double sum = 0.0;
  for (const auto& hypothesis : bank) {
    weights.push_back(std::exp(hypothesis.log_weight - highest));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

void thin_out(std::vector<PseudorangeHypothesis>& bank, double least) {
  double highest = bank.front().log_weight;
  for (const auto& hypothesis : bank) highest = std::max(highest, hypothesis.log_weight);
  std::vector<std::size_t> order;
  order.reserve(bank.size());
  for (std::size_t i = 0; i < bank.size(); ++i) {
    if (bank[i].log_weight >= highest + std::log(least)) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return bank[a].log_weight > bank[b].log_weight; });
  std::vector<std::size_t> kept;
  kept.reserve(order.size());
  const std::vector<WeightedBelief> particles = planar(bank);
  for (const std::size_t i : order) {
    const auto heir = std::find_if(kept.begin(), kept.end(), [&](std::size_t k) {
      return agree(particles[k].belief, particles[i].belief);
    });
    if (heir == kept.end()) {
      kept.push_back(i);
    } else {
      bank[*heir].log_weight = log_sum(bank[*heir].log_weight, bank[i].log_weight);
    }
  }
  std::sort(kept.begin(), kept.end());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (kept[k] != k) bank[k] = bank[kept[k]];
  }
  bank.erase(bank.begin() + static_cast<std::ptrdiff_t>(kept.size()), bank.end());
  const std::vector<double> weights = weights_of(bank);
  for (std::size_t k = 0; k < bank.size(); ++k) bank[k].log_weight = std::log(weights[k]);
}

std::vector<WeightedBelief> planar(const std::vector<PseudorangeHypothesis>& bank) {
  const std::vector<double> weights = weights_of(bank);
  std::vector<WeightedBelief> particles;
  particles.reserve(bank.size());
  for (std::size_t i = 0; i < bank.size(); ++i) {
    WeightedBelief particle;
    particle.belief = bank[i].planar();
    particle.in_shadow = bank[i].line_of_sight_share() < 0.5;
    particle.weight = weights[i];
    particles.push_back(particle);
  }
  return particles;
}

}  // namespace multipath_localization
