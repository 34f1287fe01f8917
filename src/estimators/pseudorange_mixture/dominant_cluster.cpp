#include "estimators/pseudorange_mixture/dominant_cluster.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multipath_localization {

namespace {

constexpr std::size_t kCentres = 24;  ///< hypotheses tried as centre
constexpr double kMinReach = 2.0;     ///< [m]
constexpr double kReachSigmas = 2.0;

/// Whether a hypothesis agrees with the pose of another, of which it is known how uncertain it is.
class Agreement {
 public:
  Agreement(const Belief& centre, double heading_reach)
      : centre_(centre.mean), heading_reach_(heading_reach) {
    const double variance = 0.5 * (centre.covariance(kX, kX) + centre.covariance(kY, kY));
    reach_squared_ = std::max(kMinReach * kMinReach, kReachSigmas * kReachSigmas * variance);
  }

  bool operator()(const Belief& other) const {
    const double distance_squared = (other.mean.head<2>() - centre_.head<2>()).squaredNorm();
    return distance_squared < reach_squared_ &&
           std::abs(angle_difference(other.mean(kYaw), centre_(kYaw))) <= heading_reach_;
  }

 private:
  Belief::Vector centre_;
  double heading_reach_;
  double reach_squared_;
};

std::vector<std::size_t> heaviest(const std::vector<WeightedBelief>& particles) {
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t count = std::min(kCentres, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return particles[a].weight > particles[b].weight ||
                             (particles[a].weight == particles[b].weight && a < b);
                    });
  order.resize(count);
  return order;
}

/// Evenly over the weight: a cluster gets as many as its mass is worth, though its hypotheses be light.
std::vector<std::size_t> spread(const std::vector<WeightedBelief>& particles) {
  std::vector<std::size_t> chosen;
  double cumulative = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double before = std::floor(static_cast<double>(kCentres) * cumulative + 0.5);
    cumulative += particles[i].weight;
    if (std::floor(static_cast<double>(kCentres) * cumulative + 0.5) > before) chosen.push_back(i);
  }
  return chosen;
}

/// A hypothesis and the weight of all that agree with it.
struct Centre {
  std::size_t index = 0;
  double mass = 0.0;
};

Centre best_of(const std::vector<std::size_t>& candidates, const std::vector<WeightedBelief>& particles,
               double heading_reach, Centre best) {
  for (const std::size_t candidate : candidates) {
    const Agreement agrees(particles[candidate].belief, heading_reach);
    double mass = 0.0;
    for (const WeightedBelief& particle : particles) mass += agrees(particle.belief) ? particle.weight : 0.0;
    if (mass > best.mass) best = {candidate, mass};
  }
  return best;
}

/// No other cluster can outweigh one of more than half.
Centre dominant_centre(const std::vector<WeightedBelief>& particles, double heading_reach) {
  const Centre best = best_of(heaviest(particles), particles, heading_reach, {});
  return best.mass > 0.5 ? best : best_of(spread(particles), particles, heading_reach, best);
}

Belief::Vector deviation(const Belief& belief, const Belief::Vector& mean) {
  Belief::Vector d = belief.mean - mean;
  d(kYaw) = wrap_angle(d(kYaw));
  return d;
}

}  // namespace

DominantCluster dominant_cluster(const std::vector<WeightedBelief>& particles, double heading_reach) {
  DominantCluster cluster;
  const Centre centre = dominant_centre(particles, heading_reach);
  cluster.mass = centre.mass;
  const Agreement agrees(particles[centre.index].belief, heading_reach);
  Belief& belief = cluster.belief;
  Eigen::Vector2d heading = Eigen::Vector2d::Zero();
  for (const WeightedBelief& particle : particles) {
    if (!agrees(particle.belief)) continue;
    const double share = particle.weight / cluster.mass;
    belief.mean += share * particle.belief.mean;
    heading +=
        share * Eigen::Vector2d(std::cos(particle.belief.mean(kYaw)), std::sin(particle.belief.mean(kYaw)));
    if (particle.in_shadow) cluster.shadow += share;
  }
  belief.mean(kYaw) = std::atan2(heading.y(), heading.x());
  for (const WeightedBelief& particle : particles) {
    const Belief::Vector d = deviation(particle.belief, belief.mean);
    cluster.overall_position_covariance +=
        particle.weight *
        (particle.belief.covariance.topLeftCorner<2, 2>() + d.head<2>() * d.head<2>().transpose());
    if (!agrees(particle.belief)) continue;
    belief.covariance += particle.weight / cluster.mass * (particle.belief.covariance + d * d.transpose());
  }
  return cluster;
}

}  // namespace multipath_localization
