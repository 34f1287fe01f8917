#include "multipath_localization/models/pseudorange/doppler_velocity.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "models/pseudorange/cauchy_width.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"

namespace multipath_localization {

namespace {

constexpr int kFewest = 5;
constexpr int kRounds = 20;
constexpr double kPriorSigma = 0.1;  // [m/s]
constexpr double kPriorCount = 4.0;
constexpr double kWorstGeometry = 1e-6;  // least pivot of the normal matrix, relative to its trace

using Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

/// One range rate: row * (velocity, drift) = value.
struct Row {
  Vector4d row;
  double value;
  double sigma;  ///< relative to the others
};

std::vector<Row> rows_of(const std::vector<SatelliteObservation>& observations,
                         const Eigen::Vector3d& antenna) {
  std::vector<Row> rows;
  double mean_variance = 0.0;
  for (const SatelliteObservation& observation : observations) {
    if (!observation.has_doppler()) continue;
    const Eigen::Vector3d direction = line_of_sight(observation, antenna).direction;
    Vector4d row;
    row << -direction, 1.0;
    rows.push_back({row, observation.range_rate - observation.velocity.dot(direction), observation.sigma});
    mean_variance += observation.sigma * observation.sigma;
  }
  mean_variance /= static_cast<double>(rows.size());
  for (Row& row : rows) row.sigma /= std::sqrt(mean_variance);
  return rows;
}

/// One round of weighted least squares.
struct Fit {
  Vector4d state = Vector4d::Zero();
  Matrix4 covariance = Matrix4::Zero();  ///< for weights of one over the rows' relative variances
  double sigma = kPriorSigma;            ///< of a row of relative standard deviation 1 [m/s]
};

std::optional<Fit> fit(const std::vector<Row>& rows, const std::vector<double>& weights) {
  Matrix4 normal = Matrix4::Zero();
  Vector4d right = Vector4d::Zero();
  double count = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double weight = weights[i] / (rows[i].sigma * rows[i].sigma);
    normal += weight * rows[i].row * rows[i].row.transpose();
    right += weight * rows[i].value * rows[i].row;
    count += weights[i];
  }
  const Eigen::LDLT<Matrix4> factor(normal);
  if (!(factor.vectorD().minCoeff() > kWorstGeometry * normal.trace())) return std::nullopt;
  Fit result;
  result.state = factor.solve(right);
  result.covariance = factor.solve(Matrix4::Identity());
  double square_sum = kPriorCount * kPriorSigma * kPriorSigma;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double residual = (rows[i].value - rows[i].row.dot(result.state)) / rows[i].sigma;
    square_sum += weights[i] * residual * residual;
  }
  result.sigma = std::sqrt(square_sum / (kPriorCount + std::max(count - 4.0, 0.0)));
  if (!result.state.allFinite() || !std::isfinite(result.sigma)) return std::nullopt;
  return result;
}

std::vector<double> cauchy_weights(const std::vector<Row>& rows, const Fit& fitted) {
  std::vector<double> weights;
  for (const Row& row : rows) {
    const double r = (row.value - row.row.dot(fitted.state)) / (row.sigma * fitted.sigma * kCauchyWidth);
    weights.push_back(1.0 / (1.0 + r * r));
  }
  return weights;
}

}  // namespace

std::optional<DopplerVelocity> doppler_velocity(const std::vector<SatelliteObservation>& observations,
                                                const Eigen::Vector3d& antenna) {
  const std::vector<Row> rows = rows_of(observations, antenna);
  if (static_cast<int>(rows.size()) < kFewest) return std::nullopt;
  std::optional<Fit> fitted = fit(rows, std::vector<double>(rows.size(), 1.0));
  for (int round = 0; round < kRounds && fitted; ++round) fitted = fit(rows, cauchy_weights(rows, *fitted));
  if (!fitted) return std::nullopt;
  DopplerVelocity result;
  result.velocity = fitted->state.head<3>();
  result.covariance = fitted->sigma * fitted->sigma * fitted->covariance.topLeftCorner<3, 3>();
  return result;
}

}  // namespace multipath_localization
