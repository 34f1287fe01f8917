#include "multipath_localization/models/pseudorange/robust_position.hpp"

#include <algorithm>
#include <cmath>

#include "models/pseudorange/cauchy_width.hpp"

namespace multipath_localization {

namespace {

constexpr double kMedianOfNormal = 0.6745;
constexpr int kRounds = 50;
constexpr double kSettled = 1e-3;  // [m]

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> cauchy_weights(const std::vector<SatelliteObservation>& observations,
                                   const PseudorangeSolution& solution) {
  std::vector<double> normalised = residuals(observations, solution);
  for (std::size_t i = 0; i < normalised.size(); ++i) {
    normalised[i] = std::abs(normalised[i]) / observations[i].sigma;
  }
  const double scale = kCauchyWidth * std::max(1.0, median(normalised) / kMedianOfNormal);
  std::vector<double> weights = declared_weights(observations);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] /= 1.0 + (normalised[i] / scale) * (normalised[i] / scale);
  }
  return weights;
}

}  // namespace

std::optional<PseudorangeSolution> robust_position(const std::vector<SatelliteObservation>& observations,
                                                   const Eigen::Vector3d& start) {
  auto solution = solve_position(observations, declared_weights(observations), start);
  for (int round = 0; round < kRounds && solution; ++round) {
    const Eigen::Vector3d before = solution->position;
    solution = solve_position(observations, cauchy_weights(observations, *solution), before);
    if (solution && (solution->position - before).norm() < kSettled) break;
  }
  return solution;
}

std::vector<double> residuals(const std::vector<SatelliteObservation>& observations,
                              const PseudorangeSolution& solution) {
  std::vector<double> all;
  for (const SatelliteObservation& observation : observations) {
    const double clock = solution.clock.at(static_cast<std::size_t>(observation.constellation));
    all.push_back(observation.pseudorange - line_of_sight(observation, solution.position).range - clock);
  }
  return all;
}

}  // namespace multipath_localization
