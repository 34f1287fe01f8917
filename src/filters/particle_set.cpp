#include "filters/particle_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "multipath_localization/filters/resampling.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kClusterCandidates = 24;

double equal_log_weight(std::size_t size) { return -std::log(static_cast<double>(size)); }

}  // namespace

ParticleSet::ParticleSet(std::size_t size)
    : x(size, 0.0), y(size, 0.0), yaw(size, 0.0), log_weight(size, equal_log_weight(size)) {}

void ParticleSet::set_pose(std::size_t i, const Pose2& pose) {
  x[i] = pose.x;
  y[i] = pose.y;
  yaw[i] = pose.yaw;
}

ParticleSet ParticleSet::selected(const std::vector<std::size_t>& ancestors) const {
  ParticleSet chosen(ancestors.size());
  for (std::size_t i = 0; i < ancestors.size(); ++i) chosen.set_pose(i, pose(ancestors[i]));
  return chosen;
}

bool normalise(std::vector<double>& log_weights) {
  double heaviest = -std::numeric_limits<double>::infinity();
  for (const double w : log_weights) heaviest = w > heaviest ? w : heaviest;
  if (!std::isfinite(heaviest)) {
    std::fill(log_weights.begin(), log_weights.end(), equal_log_weight(log_weights.size()));
    return false;
  }
  double total = 0.0;
  for (double& w : log_weights) {
    if (std::isnan(w)) w = -std::numeric_limits<double>::infinity();
    total += std::exp(w - heaviest);
  }
  const double shift = heaviest + std::log(total);
  for (double& w : log_weights) w -= shift;
  return true;
}

std::vector<double> weights_of(const std::vector<double>& log_weights) {
  std::vector<double> weights(log_weights.size());
  std::transform(log_weights.begin(), log_weights.end(), weights.begin(),
                 [](double w) { return std::exp(w); });
  return weights;
}

double effective_sample_size(const std::vector<double>& weights) {
  return 1.0 / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

PoseMoments moments(const ParticleSet& particles, const std::vector<double>& weights) {
  PoseMoments result;
  double total = 0.0;
  double c = 0.0;
  double s = 0.0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double w = weights[i];
    if (w <= 0.0) continue;
    total += w;
    position += w * Eigen::Vector2d(particles.x[i], particles.y[i]);
    c += w * std::cos(particles.yaw[i]);
    s += w * std::sin(particles.yaw[i]);
  }
  position /= total;
  result.mean = {position.x(), position.y(), std::atan2(s, c)};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    const Eigen::Vector3d d(particles.x[i] - result.mean.x, particles.y[i] - result.mean.y,
                            angle_difference(particles.yaw[i], result.mean.yaw));
    result.covariance += weights[i] / total * d * d.transpose();
  }
  return result;
}

std::vector<double> dominant_cluster(const ParticleSet& particles, const std::vector<double>& weights,
                                     double distance, double turn) {
  const double reach = distance * distance;
  const double least_cosine = turn < kPi ? std::cos(turn) : -2.0;
  std::vector<double> c(particles.size());
  std::vector<double> s(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    c[i] = std::cos(particles.yaw[i]);
    s[i] = std::sin(particles.yaw[i]);
  }
  const auto cluster_round = [&](std::size_t centre) {
    std::vector<double> members(weights.size(), 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double dx = particles.x[i] - particles.x[centre];
      const double dy = particles.y[i] - particles.y[centre];
      const double cosine = c[i] * c[centre] + s[i] * s[centre];
      if (dx * dx + dy * dy <= reach && cosine >= least_cosine) members[i] = weights[i];
    }
    return members;
  };
  std::vector<double> dominant;
  double dominant_mass = -1.0;
  for (const std::size_t centre : systematic_resampling(weights, kClusterCandidates, 0.5)) {
    std::vector<double> members = cluster_round(centre);
    const double mass = std::accumulate(members.begin(), members.end(), 0.0);
    if (mass <= dominant_mass) continue;
    dominant = std::move(members);
    dominant_mass = mass;
  }
  return dominant;
}

}  // namespace multipath_localization
