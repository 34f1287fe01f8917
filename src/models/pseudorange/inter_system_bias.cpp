#include "multipath_localization/models/pseudorange/inter_system_bias.hpp"

#include <cmath>
#include <limits>

namespace multipath_localization {

namespace {

constexpr double kWalk = 0.01;  // [m/sqrt(s)]
constexpr double kUnknown = std::numeric_limits<double>::infinity();

std::size_t index(Constellation constellation) { return static_cast<std::size_t>(constellation); }

}  // namespace

void InterSystemBias::forget() {
  reference_.reset();
  mean_.fill(0.0);
  variance_.fill(kUnknown);
}

void InterSystemBias::adopt(const PseudorangeSolution& solution) {
  if (std::isinf(sigma_)) return;
  for (std::size_t k = 0; k < solution.clock.size() && !reference_; ++k) {
    if (std::isfinite(solution.clock[k])) reference_ = static_cast<Constellation>(k);
  }
  if (!reference_) return;
  const double reference_clock = solution.clock[index(*reference_)];
  variance_[index(*reference_)] = 0.0;
  for (std::size_t k = 0; k < solution.clock.size(); ++k) {
    const double difference = solution.clock[k] - reference_clock;
    if (std::isfinite(variance_[k]) || !std::isfinite(difference)) continue;
    mean_[k] = difference;
    variance_[k] = sigma_ * sigma_;
  }
}

void InterSystemBias::wander(double duration) {
  if (!reference_) return;
  for (std::size_t k = 0; k < variance_.size(); ++k) {
    if (k != index(*reference_)) variance_[k] += kWalk * kWalk * duration;
  }
}

void InterSystemBias::correct(Constellation constellation, double difference, double variance) {
  double& P = variance_[index(constellation)];
  if (!std::isfinite(P) || !std::isfinite(difference) || !(variance > 0.0)) return;
  const double K = P / (P + variance);
  mean_[index(constellation)] += K * difference;
  P *= 1.0 - K;
}

double InterSystemBias::mean(Constellation constellation) const { return mean_[index(constellation)]; }

double InterSystemBias::variance(Constellation constellation) const {
  return variance_[index(constellation)];
}

}  // namespace multipath_localization
