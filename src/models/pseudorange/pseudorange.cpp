#include "multipath_localization/models/pseudorange/pseudorange.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath_localization {

namespace {

constexpr int kUnknowns = 3 + kConstellations;
constexpr double kLeastSigma = 0.5;  // [m]
constexpr int kIterations = 15;
constexpr double kConverged = 1e-4;  // [m]
constexpr int kRefinements = 3;
constexpr double kWorstGeometry = 1e-8;  // least pivot of the normal matrix, relative to its trace

using Vector = Eigen::Matrix<double, kUnknowns, 1>;
using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;

int clock_index(const SatelliteObservation& observation) {
  return 3 + static_cast<int>(observation.constellation);
}

/// Who takes part: observations of positive weight, and a clock for each of their constellations.
struct Census {
  int used = 0;
  int unknowns = 3;
  std::array<bool, kConstellations> seen{};

  Census(const std::vector<SatelliteObservation>& observations, const std::vector<double>& weights) {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      if (!(weights[i] > 0.0)) continue;
      ++used;
      seen[static_cast<std::size_t>(observations[i].constellation)] = true;
    }
    unknowns += static_cast<int>(std::count(seen.begin(), seen.end(), true));
  }
};

/// The normal equations of one Gauss-Newton step.
struct NormalEquations {
  Matrix matrix = Matrix::Zero();
  Vector right_hand_side = Vector::Zero();
  double weighted_square_sum = 0.0;  ///< of the residuals at the point of linearisation

  void add(const SatelliteObservation& observation, double weight, const Vector& state) {
    const LineOfSight sight = line_of_sight(observation, state.head<3>());
    const int clock = clock_index(observation);
    const double residual = observation.pseudorange - sight.range - state(clock);
    Vector row = Vector::Zero();
    row.head<3>() = -sight.direction;
    row(clock) = 1.0;
    matrix += weight * row * row.transpose();
    right_hand_side += weight * residual * row;
    weighted_square_sum += weight * residual * residual;
  }
};

NormalEquations normal_equations(const std::vector<SatelliteObservation>& observations,
                                 const std::vector<double>& weights, const Vector& state) {
  NormalEquations equations;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (weights[i] > 0.0) equations.add(observations[i], weights[i], state);
  }
  return equations;
}

/// The clocks at which the residuals' weighted mean is zero: lets Gauss-Newton start near.
Vector with_clocks(Vector state, const std::vector<SatelliteObservation>& observations,
                   const std::vector<double>& weights) {
  const NormalEquations equations = normal_equations(observations, weights, state);
  for (int k = 3; k < kUnknowns; ++k) {
    if (equations.matrix(k, k) > 0.0) state(k) += equations.right_hand_side(k) / equations.matrix(k, k);
  }
  return state;
}

/// The factors of a normal matrix, in which the clocks of constellations not seen stay as they are; nothing
/// where the geometry leaves something undetermined.
std::optional<Eigen::LDLT<Matrix>> factorised(Matrix matrix, const Census& census) {
  for (std::size_t k = 0; k < census.seen.size(); ++k) {
    const int index = 3 + static_cast<int>(k);
    if (!census.seen[k]) matrix(index, index) = matrix.trace();
  }
  Eigen::LDLT<Matrix> factor(matrix);
  if (!(factor.vectorD().minCoeff() > kWorstGeometry * matrix.trace())) return std::nullopt;
  return factor;
}

PseudorangeSolution solution_of(const Vector& state, const Matrix& covariance,
                                const std::array<bool, kConstellations>& seen) {
  PseudorangeSolution solution;
  solution.position = state.head<3>();
  solution.covariance = covariance.topLeftCorner<3, 3>();
  for (std::size_t k = 0; k < seen.size(); ++k) {
    solution.clock[k] = seen[k] ? state(3 + static_cast<int>(k)) : std::numeric_limits<double>::quiet_NaN();
  }
  return solution;
}

}  // namespace

LineOfSight line_of_sight(const SatelliteObservation& observation, const Eigen::Vector3d& antenna) {
  const Eigen::Vector3d path = observation.position - antenna;
  const double range = path.norm();
  return {range, path / range};
}

double believed_sigma(const SatelliteObservation& observation) {
  return std::max(kLeastSigma, observation.sigma);
}

std::vector<double> declared_weights(const std::vector<SatelliteObservation>& observations) {
  std::vector<double> weights;
  weights.reserve(observations.size());
  for (const SatelliteObservation& observation : observations) {
    const double sigma = believed_sigma(observation);
    weights.push_back(1.0 / (sigma * sigma));
  }
  return weights;
}

std::optional<PseudorangeSolution> solve_position(const std::vector<SatelliteObservation>& observations,
                                                  const std::vector<double>& weights,
                                                  const Eigen::Vector3d& start) {
  const Census census(observations, weights);
  if (census.used < census.unknowns) return std::nullopt;
  Vector state = Vector::Zero();
  state.head<3>() = start;
  state = with_clocks(state, observations, weights);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const NormalEquations equations = normal_equations(observations, weights, state);
    const auto factor = factorised(equations.matrix, census);
    if (!factor) return std::nullopt;
    const Vector step = factor->solve(equations.right_hand_side);
    state += step;
    if (!state.allFinite()) return std::nullopt;
    if (step.head<3>().norm() > kConverged) continue;
    PseudorangeSolution solution = solution_of(state, factor->solve(Matrix::Identity()), census.seen);
    solution.weighted_square_sum = normal_equations(observations, weights, state).weighted_square_sum;
    solution.used = census.used;
    solution.degrees_of_freedom = census.used - census.unknowns;
    return solution;
  }
  return std::nullopt;
}

std::optional<Geodetic> solve_geodetic(const std::vector<SatelliteObservation>& observations,
                                       const LocalFrame& map) {
  std::vector<Eigen::Vector3d> satellites;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SatelliteObservation& observation : observations) {
    satellites.push_back(map.satellite_to_ecef(observation.position));
    middle += satellites.back();
  }
  Geodetic antenna = to_geodetic(middle);
  antenna.altitude = 0.0;
  for (int k = 0; k < kRefinements; ++k) {
    if (!valid(antenna)) return std::nullopt;
    const LocalFrame near(antenna);
    std::vector<SatelliteObservation> seen = observations;
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i].position = near.satellite_to_map(satellites[i]);
    const auto solution = solve_position(seen, declared_weights(seen), Eigen::Vector3d::Zero());
    if (!solution) return std::nullopt;
    antenna = near.to_geodetic(solution->position.head<2>(), solution->position.z());
  }
  return valid(antenna) ? std::optional(antenna) : std::nullopt;
}

}  // namespace multipath_localization
