#include "models/pseudorange/weighted_velocity.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace multipath_localization {

namespace {

constexpr int kLeastSatellites = 4;
constexpr int kReweightings = 2;
constexpr double kWorstDrift = 1e4;      // of a receiver clock, 33 ppm [m/s]
constexpr double kFastest = 200.0;       // a faster receiver is an error of the data [m/s]
constexpr double kWorstGeometry = 1e-4;  // least pivot of the normal matrix, relative to its trace

/// Normal equations over the velocity; the drift is eliminated by taking out weighted means.
struct NormalEquations {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_hand_side = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction_sum = Eigen::Vector3d::Zero();
  double rate_sum = 0.0;
  double weight_sum = 0.0;
  int satellites = 0;

  void add(const Eigen::Vector3d& direction, double rate, double weight) {
    const Eigen::Vector3d weighted = weight * direction;
    matrix += weighted * direction.transpose();
    right_hand_side -= rate * weighted;
    direction_sum += weighted;
    rate_sum += weight * rate;
    weight_sum += weight;
    ++satellites;
  }

  void eliminate_drift() {
    matrix -= direction_sum * direction_sum.transpose() / weight_sum;
    right_hand_side += rate_sum / weight_sum * direction_sum;
  }
};

struct Motion {
  Eigen::Vector3d velocity;
  double drift;
};

/// What a receiver at rest would have measured, taken off the range rate.
double own_rate(const SatelliteObservation& observation, const Eigen::Vector3d& direction) {
  return observation.range_rate - direction.dot(observation.velocity);
}

/// The equations of all observations, each doubted by its residual against `motion` if there is one.
NormalEquations normal_equations(const std::vector<SatelliteObservation>& observations,
                                 const std::vector<Eigen::Vector3d>& directions,
                                 const std::vector<double>& weights, double tolerance,
                                 const std::optional<Motion>& motion) {
  NormalEquations equations;
  for (std::size_t j = 0; j < observations.size(); ++j) {
    if (!(weights[j] > 0.0) || !observations[j].has_doppler()) continue;
    const double rate = own_rate(observations[j], directions[j]);
    if (!(std::abs(rate) < kWorstDrift)) continue;
    const double ratio =
        motion ? (rate + directions[j].dot(motion->velocity) - motion->drift) / tolerance : 0.0;
    equations.add(directions[j], rate, weights[j] / (1.0 + ratio * ratio));
  }
  return equations;
}

std::optional<Motion> solved(NormalEquations equations) {
  if (equations.satellites < kLeastSatellites) return std::nullopt;
  equations.eliminate_drift();
  const Eigen::LDLT<Eigen::Matrix3d> factor(equations.matrix);
  if (!(factor.vectorD().minCoeff() > kWorstGeometry * equations.matrix.trace())) return std::nullopt;
  const Eigen::Vector3d velocity = factor.solve(equations.right_hand_side);
  const double drift = (equations.rate_sum + equations.direction_sum.dot(velocity)) / equations.weight_sum;
  return Motion{velocity, drift};
}

}  // namespace

std::optional<Eigen::Vector3d> weighted_velocity(const std::vector<SatelliteObservation>& observations,
                                                 const std::vector<Eigen::Vector3d>& directions,
                                                 const std::vector<double>& weights, double tolerance) {
  auto motion = solved(normal_equations(observations, directions, weights, tolerance, std::nullopt));
  const int reweightings = tolerance > 0.0 ? kReweightings : 0;
  for (int i = 0; i < reweightings && motion; ++i) {
    motion = solved(normal_equations(observations, directions, weights, tolerance, motion));
  }
  if (!motion || !(motion->velocity.norm() < kFastest)) return std::nullopt;
  return motion->velocity;
}

}  // namespace multipath_localization
