#include "multipath_localization/models/pseudorange/one_sided_position.hpp"

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr int kReweightings = 15;
constexpr double kAbsurd = 1e6;  // no reflection and no error of the start makes a range differ so much [m]

/// The weights without those of pseudoranges that have nothing to do with the others: one would draw least
/// squares to where no reweighting finds back from.
std::vector<double> without_absurd(const std::vector<SatelliteObservation>& observations,
                                   std::vector<double> weights, const Eigen::Vector3d& start) {
  std::vector<double> residuals;
  residuals.reserve(observations.size());
  for (const SatelliteObservation& observation : observations) {
    residuals.push_back(observation.pseudorange - line_of_sight(observation, start).range);
  }
  if (residuals.empty()) return weights;
  std::vector<double> sorted = residuals;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (std::size_t j = 0; j < residuals.size(); ++j) {
    if (!(std::abs(residuals[j] - *middle) < kAbsurd)) weights[j] = 0.0;
  }
  return weights;
}

}  // namespace

void OneSidedPositionParameters::fields(ParameterVisitor& field) {
  field("late_tolerance", late_tolerance, {0.1, 1e3}, "m",
        "a pseudorange this much too long counts half in the robust fix");
  field("early_tolerance", early_tolerance, {0.1, 1e3}, "m", "likewise one this much too short");
}

std::optional<PseudorangeSolution> one_sided_position(const std::vector<SatelliteObservation>& observations,
                                                      const std::vector<double>& weights,
                                                      const OneSidedPositionParameters& parameters,
                                                      const Eigen::Vector3d& start) {
  const std::vector<double> usable = without_absurd(observations, weights, start);
  auto solution = solve_position(observations, usable, start);
  std::vector<double> reweighted(usable);
  for (int i = 0; i < kReweightings && solution && solution->degrees_of_freedom > 0; ++i) {
    for (std::size_t j = 0; j < observations.size(); ++j) {
      if (!(usable[j] > 0.0)) continue;
      const double clock = solution->clock[static_cast<std::size_t>(observations[j].constellation)];
      const double residual =
          observations[j].pseudorange - line_of_sight(observations[j], solution->position).range - clock;
      const double ratio =
          residual / (residual > 0.0 ? parameters.late_tolerance : parameters.early_tolerance);
      reweighted[j] = usable[j] / (1.0 + ratio * ratio);
    }
    solution = solve_position(observations, reweighted, solution->position);
  }
  if (solution && solution->degrees_of_freedom == 0) return std::nullopt;
  return solution;
}

}  // namespace multipath_localization
