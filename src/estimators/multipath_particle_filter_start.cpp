#include <algorithm>
#include <cmath>

#include "multipath_localization/core/numbers.hpp"
#include "multipath_localization/estimators/multipath_particle_filter.hpp"

namespace multipath_localization {

namespace {

constexpr double kRingSpacing = 0.6;        ///< 1 sigma of a start heading, in spacings of the ring
constexpr double kMinStartYawSigma = 0.05;  ///< [rad]

/// Interleaves the classes in proportion to their probabilities: the class of each of `count` particles. None
/// that there can be goes without a particle.
std::vector<std::size_t> interleaved(const PerClass& probability, std::size_t count) {
  PerClass due{};
  ClassCounts size{};
  std::vector<std::size_t> order(count);
  for (std::size_t& chosen : order) {
    for (std::size_t k = 0; k < kReceiverClassCount; ++k) due[k] += probability[k];
    chosen = static_cast<std::size_t>(std::max_element(due.begin(), due.end()) - due.begin());
    due[chosen] -= 1.0;
    ++size[chosen];
  }
  for (std::size_t k = 0; k < kReceiverClassCount; ++k) {
    if (size[k] > 0 || probability[k] <= 0.0) continue;
    const auto largest = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    *std::find(order.rbegin(), order.rend(), largest) = k;
    --size[largest];
    ++size[k];
  }
  return order;
}

}  // namespace

void MultipathParticleFilter::start(const std::optional<PosePrior>& prior) {
  particles_.clear();
  odometry_.restart(0.0, 0.0);
  alignment_ = RigidAlignment(parameters_.alignment_length, parameters_.classes.street.quiet_sigma,
                              parameters_.alignment_variance_floor);
  odometry_jump_ = OdometryJump(parameters_.odometry_jump, parameters_.odometry);
  fix_check_.forget();
  steady_bias_.clear();
  since_fix_ = Pose2{};
  distance_since_fix_ = usual_speed_ = suspected_for_ = confirmed_over_ = settled_over_ = 0.0;
  confirmed_ = false;
  step_ = 0;
  if (prior && usable(*prior)) start_at(*prior);
}

template <class Place>
void MultipathParticleFilter::spread(Place place) {
  const auto count = static_cast<std::size_t>(parameters_.particles);
  const std::vector<std::size_t> order = interleaved(prior_, count);
  PerClass size{};
  for (const std::size_t k : order) size[k] += 1.0;
  PerClass next{};
  particles_.assign(count, BeliefParticle{});
  for (std::size_t i = 0; i < count; ++i) {
    BeliefParticle& particle = particles_[i];
    const std::size_t k = particle.receiver = order[i];
    const ReceiverClass& receiver = parameters_.classes[k];
    particle.weight = prior_[k] / size[k];
    particle.mode.shadow =
        RandomStream(seed_, step_, static_cast<std::uint32_t>(i)).uniform() < receiver.shadow_at_start;
    particle.mode.noisy = receiver.always_shadow;
    const double sigma = particle.mode.shadow ? receiver.shadow_bias_sigma : receiver.open_bias_sigma;
    particle.belief.renew_bias(sigma * sigma);
    particle.belief.renew(kScale, 0.0, square(parameters_.odometry.scale_sigma));
    particle.belief.renew(kGyroBias, 0.0, square(parameters_.odometry.gyro_bias_sigma));
    place(particle, (next[k] + 0.5) / size[k], size[k]);
    next[k] += 1.0;
  }
  ++step_;
  last_fix_ = doubted_until_ = now_;
  refresh_cluster();
}

void MultipathParticleFilter::start_at(const GnssFix& fix) {
  spread([&](BeliefParticle& particle, double turn, double bank_size) {
    const ReceiverClass& receiver = parameters_.classes[particle.receiver];
    Belief& belief = particle.belief;
    const double yaw_sigma = std::max(kMinStartYawSigma, kRingSpacing * 2.0 * kPi / bank_size);
    belief.renew(kYaw, wrap_angle(2.0 * kPi * turn), square(yaw_sigma));
    const Eigen::Vector2d lever = rotation(belief.mean(kYaw)) * fix.antenna_in_base;
    const Eigen::Vector2d by_yaw(-lever.y(), lever.x());
    const double bias_variance = belief.covariance(kBiasX, kBiasX);
    const double noise = square(particle.mode.shadow ? receiver.noisy_sigma : receiver.quiet_sigma);
    belief.mean.head<2>() = fix.position - lever;
    belief.covariance.topLeftCorner<2, 2>() = (noise + bias_variance) * Eigen::Matrix2d::Identity() +
                                              square(yaw_sigma) * by_yaw * by_yaw.transpose();
    belief.covariance.block<2, 1>(kX, kYaw) = -square(yaw_sigma) * by_yaw;
    belief.covariance.block<1, 2>(kYaw, kX) = -square(yaw_sigma) * by_yaw.transpose();
    belief.covariance.block<2, 2>(kX, kBiasX) = -bias_variance * Eigen::Matrix2d::Identity();
    belief.covariance.block<2, 2>(kBiasX, kX) = -bias_variance * Eigen::Matrix2d::Identity();
  });
}

void MultipathParticleFilter::start_at(const PosePrior& prior) {
  now_ = prior.stamp;
  confirmed_ = parameters_.confirmed_start || prior.confirmed;
  const double prior_yaw_sigma = std::sqrt(prior.covariance(2, 2));
  spread([&](BeliefParticle& particle, double turn, double bank_size) {
    Belief& belief = particle.belief;
    belief.mean.head<3>() << prior.pose.x, prior.pose.y, prior.pose.yaw;
    belief.covariance.topLeftCorner<3, 3>() = prior.covariance;
    if (prior_yaw_sigma < kMinStartYawSigma * kRingSpacing * kPi) return;
    // A wide heading does not fit one Kalman filter: a ring of narrow ones over 3 sigma, at most the circle.
    const double half = std::min(3.0 * prior_yaw_sigma, kPi);
    const double offset = half * (2.0 * turn - 1.0);
    const double yaw_sigma = std::max(kMinStartYawSigma, kRingSpacing * 2.0 * half / bank_size);
    belief.renew(kYaw, wrap_angle(prior.pose.yaw + offset), square(yaw_sigma));
    particle.weight *= std::exp(-0.5 * square(offset / prior_yaw_sigma));
  });
  double sum = 0.0;
  for (const BeliefParticle& particle : particles_) sum += particle.weight;
  for (BeliefParticle& particle : particles_) particle.weight /= sum;
  refresh_cluster();
}

}  // namespace multipath_localization
