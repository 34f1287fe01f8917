#include "multipath_localization/models/pseudorange/los_subset.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "models/pseudorange/weighted_velocity.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "multipath_localization/models/pseudorange/signal_weights.hpp"

namespace multipath_localization {

namespace {

constexpr double kWorstGeometry = 1e-7;  // least pivot of the normal matrix, relative to its trace

std::size_t constellation_index(const SatelliteObservation& observation) {
  return static_cast<std::size_t>(observation.constellation);
}

/// High and strong, as far as both go together. Departs: [SUZ] does not say how one is weighed against the
/// other.
std::size_t best_signal(const std::vector<SatelliteObservation>& observations) {
  const std::vector<double> weights = signal_weights(observations);
  return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

}  // namespace

void LosSubsetParameters::fields(ParameterVisitor& field) {
  field("clock", clock, {"quantile", "reference"},
        "what Eq. (5) takes off the residuals: quantile = a low quantile of them; reference = that of one "
        "high and strong satellite, as printed, reflected or not");
  field("clock_quantile", clock_quantile, {0.0, 1.0}, "1", "which quantile");
  field("lower_threshold", lower_threshold, {-1e4, 0.0}, "m",
        "T_L of Eq. (6): shorter pseudoranges are left out");
  field("upper_threshold", upper_threshold, {0.0, 1e4}, "m",
        "T_U of Eq. (6): longer ones are taken for reflected");
  field("least_satellites", least_satellites, {4, 64}, "1",
        "a smaller subset has no solution; nor has one without a satellite for each unknown");
}

LosSubset::LosSubset(const std::vector<SatelliteObservation>& observations,
                     const std::vector<double>& weights, const InterSystemBias& bias,
                     const LosSubsetParameters& parameters)
    : observations_(observations),
      parameters_(parameters),
      weights_(weights),
      order_(observations.size()),
      reference_(best_signal(observations)),
      directions_(observations.size()),
      residuals_(observations.size()),
      sorted_(observations.size()),
      selected_weights_(observations.size(), 0.0) {
  for (std::size_t k = 0; k < offset_.size(); ++k) {
    offset_[k] = bias.mean(static_cast<Constellation>(k));
    offset_variance_[k] = bias.variance(static_cast<Constellation>(k));
  }
  // Constellations of known bias share group 0, each other one is a group of its own.
  const auto group = [&](std::size_t i) {
    const std::size_t k = constellation_index(observations_[i]);
    return std::isfinite(offset_variance_[k]) ? 0 : k + 1;
  };
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return group(a) < group(b); });
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (i == 0 || group(order_[i]) != group(order_[i - 1])) bounds_.push_back(i);
  }
  bounds_.push_back(order_.size());
}

std::optional<SubsetSolution> LosSubset::solve(const Eigen::Vector3d& antenna) {
  look_from(antenna);
  remove_clocks();
  NormalEquations equations = select();
  if (selected_ < std::max(parameters_.least_satellites, unknowns())) return std::nullopt;
  const double trace = equations.matrix.trace();
  eliminate_clocks(equations);
  const Eigen::LDLT<Eigen::Matrix3d> factor(equations.matrix);
  if (!(factor.vectorD().minCoeff() > kWorstGeometry * trace)) return std::nullopt;
  SubsetSolution solution;
  solution.step = factor.solve(equations.right_hand_side);
  solution.information = equations.matrix;
  solution.mahalanobis_squared = solution.step.dot(equations.right_hand_side);
  solution.log_determinant = factor.vectorD().array().log().sum();
  solution.satellites = selected_;
  return solution;
}

void LosSubset::look_from(const Eigen::Vector3d& antenna) {
  for (std::size_t j = 0; j < observations_.size(); ++j) {
    const LineOfSight sight = line_of_sight(observations_[j], antenna);
    directions_[j] = sight.direction;
    residuals_[j] =
        observations_[j].pseudorange - sight.range - offset_[constellation_index(observations_[j])];
  }
}

/// Eq. (5) of [SUZ].
void LosSubset::remove_clocks() {
  if (parameters_.clock == SubsetClock::kReference) {
    const double clock = residuals_[reference_];
    for (double& residual : residuals_) residual -= clock;
    return;
  }
  for (std::size_t i = 0; i + 1 < bounds_.size(); ++i) {
    const double clock = quantile_of(bounds_[i], bounds_[i + 1]);
    for (std::size_t n = bounds_[i]; n < bounds_[i + 1]; ++n) residuals_[order_[n]] -= clock;
  }
}

double LosSubset::quantile_of(std::size_t first, std::size_t end) {
  const std::size_t count = end - first;
  for (std::size_t n = 0; n < count; ++n) sorted_[n] = residuals_[order_[first + n]];
  const auto rank = std::lround(parameters_.clock_quantile * static_cast<double>(count - 1));
  const auto chosen = sorted_.begin() + rank;
  std::nth_element(sorted_.begin(), chosen, sorted_.begin() + static_cast<std::ptrdiff_t>(count));
  return *chosen;
}

/// Eq. (6) of [SUZ].
LosSubset::NormalEquations LosSubset::select() {
  NormalEquations equations;
  sums_.fill(Sums{});
  selected_ = 0;
  for (std::size_t j = 0; j < observations_.size(); ++j) {
    const double residual = residuals_[j];
    const bool in_sight = residual >= parameters_.lower_threshold && residual <= parameters_.upper_threshold;
    selected_weights_[j] = in_sight ? weights_[j] : 0.0;
    if (!in_sight) continue;
    const Eigen::Vector3d weighted = weights_[j] * directions_[j];
    equations.matrix += weighted * directions_[j].transpose();
    equations.right_hand_side -= residual * weighted;
    Sums& sums = sums_[constellation_index(observations_[j])];
    sums.weight += weights_[j];
    sums.residual += weights_[j] * residual;
    sums.direction += weighted;
    ++selected_;
  }
  return equations;
}

/// Each constellation's clock is the common one plus an offset of known variance: taken together, its
/// satellites observe the common clock with the variance of their mean plus that.
void LosSubset::eliminate_clocks(NormalEquations& equations) const {
  Sums common;
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const Sums& sums = sums_[k];
    if (!(sums.weight > 0.0)) continue;
    const Eigen::Vector3d direction = sums.direction / sums.weight;
    const double residual = sums.residual / sums.weight;
    const double weight = sums.weight / (1.0 + sums.weight * offset_variance_[k]);
    equations.matrix -= (sums.weight - weight) * direction * direction.transpose();
    equations.right_hand_side += (sums.weight - weight) * residual * direction;
    common.weight += weight;
    common.residual += weight * residual;
    common.direction += weight * direction;
  }
  if (!(common.weight > 0.0)) return;
  equations.matrix -= common.direction * common.direction.transpose() / common.weight;
  equations.right_hand_side += common.residual / common.weight * common.direction;
}

int LosSubset::unknowns() const {
  int free_clocks = 0;
  bool common_clock = false;
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    if (!(sums_[k].weight > 0.0)) continue;
    const bool known = std::isfinite(offset_variance_[k]);
    common_clock = common_clock || known;
    free_clocks += known ? 0 : 1;
  }
  return 3 + free_clocks + (common_clock ? 1 : 0);
}

std::optional<Eigen::Vector3d> LosSubset::velocity(double tolerance) const {
  return weighted_velocity(observations_, directions_, selected_weights_, tolerance);
}

std::optional<LosSubset::ClockResidual> LosSubset::clock_residual(Constellation constellation) const {
  const Sums& sums = sums_[static_cast<std::size_t>(constellation)];
  if (!(sums.weight > 0.0)) return std::nullopt;
  return ClockResidual{sums.residual / sums.weight, 1.0 / sums.weight};
}

double LosSubset::excluded_share() const {
  return 1.0 - static_cast<double>(selected_) / static_cast<double>(observations_.size());
}

}  // namespace multipath_localization
