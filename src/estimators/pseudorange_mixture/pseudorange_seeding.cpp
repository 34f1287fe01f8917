#include "estimators/pseudorange_mixture/pseudorange_seeding.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "multipath_localization/filters/resampling.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr int kUnknowns = 4 + kConstellations;  // east, north, up, clock, offsets
constexpr int kIterations = 3;
constexpr std::size_t kLeastSubset = 6;
constexpr double kFarSigma = 1e3;          // of an unknown position about the plain solution [m]
constexpr double kLeastPriorSigma = 0.01;  // of a known one [m]

using Vector = Eigen::Matrix<double, kUnknowns, 1>;
using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;

int offset_index(const SatelliteObservation& observation) {
  return 4 + static_cast<int>(observation.constellation);
}

/// What is known before the satellites of a subset are looked at: mean and inverse covariance.
struct Information {
  Vector mean = Vector::Zero();
  Matrix matrix = Matrix::Zero();
};

void take_in(const AntennaPrior& prior, Information& known) {
  const Eigen::Matrix2d rounding = square(kLeastPriorSigma) * Eigen::Matrix2d::Identity();
  known.mean.head<2>() = prior.position;
  known.matrix.topLeftCorner<2, 2>() = (prior.covariance + rounding).inverse();
}

void take_in(const ReceiverPrior& prior, Information& known) {
  known.mean(2) = prior.up;
  known.matrix(2, 2) = 1.0 / prior.up_variance;
  for (int k = 5; k < kUnknowns; ++k) {
    known.mean(k) = prior.offset[static_cast<std::size_t>(k - 4)];
    known.matrix(k, k) = 1.0 / prior.offset_variance[static_cast<std::size_t>(k - 4)];
  }
}

Information information(const PseudorangeSolution& plain, const SeedPrior& prior, double offset_sigma) {
  Information known;
  known.mean.head<3>() = plain.position;
  known.matrix.diagonal().setConstant(1.0 / square(kFarSigma));
  known.matrix(3, 3) = 0.0;
  for (std::size_t k = plain.clock.size(); k-- > 0;) {
    if (std::isfinite(plain.clock[k])) known.mean(3) = plain.clock[k];
  }
  for (int k = 5; k < kUnknowns; ++k) known.matrix(k, k) = 1.0 / square(offset_sigma);
  known.matrix(4, 4) = 1e6;  // GPS is the reference
  if (prior.antenna) take_in(*prior.antenna, known);
  if (prior.receiver) take_in(*prior.receiver, known);
  return known;
}

class Seeder {
 public:
  Seeder(const std::vector<SatelliteObservation>& observations, Information known,
         const SatelliteMixtureParameters& mixture, double sigma)
      : observations_(observations), known_(std::move(known)), mixture_(mixture), sigma_(sigma) {
    for (const SatelliteObservation& observation : observations) {
      priors_.push_back(line_of_sight_prior(observation, mixture));
    }
  }

  /// Satellites drawn without putting back, in proportion to their priors.
  [[nodiscard]] std::vector<std::size_t> subset(std::size_t size, RandomStream& random) const {
    std::vector<std::pair<double, std::size_t>> keys;
    for (std::size_t i = 0; i < priors_.size(); ++i) {
      keys.emplace_back(-std::log1p(-random.uniform()) / priors_[i], i);
    }
    size = std::min(size, keys.size());
    std::partial_sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(size), keys.end());
    std::vector<std::size_t> chosen(size);
    for (std::size_t i = 0; i < size; ++i) chosen[i] = keys[i].second;
    return chosen;
  }

  /// Regularised least squares over a subset.
  [[nodiscard]] Vector solve(const std::vector<std::size_t>& subset) const {
    Vector state = known_.mean;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      Matrix A = known_.matrix;
      Vector b = known_.matrix * (known_.mean - state);
      for (const std::size_t i : subset) {
        const LineOfSight sight = line_of_sight(observations_[i], state.head<3>());
        Vector h = Vector::Zero();
        h << -sight.direction, 1.0, Eigen::Matrix<double, kConstellations, 1>::Zero();
        h(offset_index(observations_[i])) = 1.0;
        A.noalias() += h * h.transpose() / square(sigma_);
        b += h * (residual(i, state) / square(sigma_));
      }
      state += A.ldlt().solve(b);
    }
    return state;
  }

  [[nodiscard]] double log_likelihood(const Vector& state) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      sum += weigh(residual(i, state), square(sigma_), mean_nlos_delay(observations_[i].elevation, mixture_),
                   priors_[i])
                 .log_likelihood;
    }
    return sum;
  }

 private:
  [[nodiscard]] double residual(std::size_t i, const Vector& state) const {
    const SatelliteObservation& observation = observations_[i];
    return observation.pseudorange - line_of_sight(observation, state.head<3>()).range - state(3) -
           state(offset_index(observation));
  }

  const std::vector<SatelliteObservation>& observations_;
  Information known_;
  const SatelliteMixtureParameters& mixture_;
  double sigma_;
  std::vector<double> priors_;
};

std::size_t constellations_in(const std::vector<SatelliteObservation>& observations) {
  std::array<bool, kConstellations> seen{};
  for (const auto& observation : observations)
    seen[static_cast<std::size_t>(observation.constellation)] = true;
  return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
}

PseudorangeSeed seed_of(const Vector& state, double log_likelihood) {
  PseudorangeSeed seed;
  seed.position = state.head<3>();
  seed.clock = state(3);
  for (int k = 0; k < kConstellations; ++k) seed.offset[static_cast<std::size_t>(k)] = state(4 + k);
  seed.log_likelihood = log_likelihood;
  return seed;
}

}  // namespace

std::vector<PseudorangeSeed> pseudorange_seeds(const std::vector<SatelliteObservation>& observations,
                                               const SeedPrior& prior, std::size_t count,
                                               const SatelliteMixtureParameters& mixture,
                                               const PseudorangeSeedingParameters& parameters,
                                               RandomStream& random) {
  const auto plain = solve_position(observations, declared_weights(observations), Eigen::Vector3d::Zero());
  if (!plain) return {};
  const Seeder seeder(observations, information(*plain, prior, parameters.offset_sigma), mixture,
                      parameters.seed_sigma);
  const std::size_t size = kLeastSubset + constellations_in(observations) - 1;
  std::vector<PseudorangeSeed> all;
  double best = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < parameters.subsets; ++i) {
    const Vector state = seeder.solve(seeder.subset(size, random));
    if (!state.allFinite()) continue;
    all.push_back(seed_of(state, seeder.log_likelihood(state)));
    best = std::max(best, all.back().log_likelihood);
  }
  if (all.empty()) return {};
  std::vector<double> weights;
  weights.reserve(all.size());
  for (const PseudorangeSeed& seed : all) {
    weights.push_back(std::exp((seed.log_likelihood - best) / parameters.log_likelihood_scale));
  }
  std::vector<PseudorangeSeed> chosen;
  chosen.reserve(count);
  for (const std::size_t i : systematic_resampling(weights, count, random.uniform())) {
    chosen.push_back(all[i]);
  }
  return chosen;
}

}  // namespace multipath_localization
