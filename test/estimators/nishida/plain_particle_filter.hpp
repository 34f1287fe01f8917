#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "estimators/nishida/bias_filter.hpp"
#include "estimators/nishida/fix_particle_filter.hpp"
#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/filters/resampling.hpp"

namespace multipath_localization {

/// log of the likelihood, Eq. (33) of [NIS] without headings, where the antenna is at `position`.
inline double plain_log_likelihood(const FixParticleFilterParameters& parameters, const GnssFix& fix,
                                   double radius, const Eigen::Vector2d& position) {
  const auto kernel = [](double share, double sigma, double distance) {
    return std::log(share / (2.0 * kPi * sigma * sigma)) - 0.5 * std::pow(distance / sigma, 2);
  };
  const FixSigmas sigma = fix_sigmas(parameters.likelihood, fix);
  const double shadow = parameters.ring.shadow_weight;
  const Eigen::Vector2d error = position - fix.position;
  std::vector<double> terms = {kernel(shadow, sigma.shadow, error.norm() - radius)};
  if (parameters.likelihood.likelihood_kernel == LikelihoodKernel::kProduct) {
    terms.push_back(kernel(1.0 - shadow, sigma.direct, error.norm()));
  } else {
    terms.push_back(kernel(1.0 - shadow, sigma.direct, error.x()));
    terms.push_back(kernel(1.0 - shadow, sigma.direct, error.y()));
  }
  const double largest = *std::max_element(terms.begin(), terms.end());
  double sum = 0.0;
  for (const double term : terms) sum += std::exp(term - largest);
  return largest + std::log(sum);
}

/// The reference of `FixParticleFilter`: the filter of [NIS] one particle after the other, with the
/// generator, the distributions and the functions of the standard library, and weights as logarithms. Starts
/// at a prior; the estimate is the mean, the antenna the base.
class PlainParticleFilter {
 public:
  PlainParticleFilter(const FixParticleFilterParameters& parameters, std::uint64_t seed)
      : parameters_(parameters), bias_filter_(parameters.bias), generator_(seed) {}

  void start(const PosePrior& prior) {
    particles_.resize(static_cast<std::size_t>(parameters_.sampling.max_particles));
    for (Particle& p : particles_) {
      p.pose.x = prior.pose.x + std::sqrt(prior.covariance(0, 0)) * normal();
      p.pose.y = prior.pose.y + std::sqrt(prior.covariance(1, 1)) * normal();
      p.pose.yaw = prior.pose.yaw + std::sqrt(prior.covariance(2, 2)) * normal();
    }
    forget_weights();
    take_stock();
  }

  /// Eqs. (3)-(8).
  void predict(const OdometryIncrement& u) {
    now_ = u.stamp;
    predicted_ = predicted_ * displacement(u);
    const SteeringNoiseParameters& noise = parameters_.motion;
    const double angle = std::atan(noise.wheelbase * u.yaw_rate / u.speed);
    const double scale = std::sqrt(noise.noise_period / u.duration);
    const auto deviate = [&](double speed_weight, double angle_weight) {
      return std::sqrt(noise.noise_scale *
                       (speed_weight * u.speed * u.speed + angle_weight * angle * angle)) *
             normal();
    };
    for (Particle& p : particles_) {
      const double v = u.speed + deviate(noise.alpha1, noise.alpha2);
      const double phi = std::clamp(angle + deviate(noise.alpha3, noise.alpha4), -noise.max_steering_angle,
                                    noise.max_steering_angle);
      const double gamma = deviate(noise.alpha5, noise.alpha6);
      OdometryIncrement drawn = u;
      drawn.speed += scale * (v - u.speed);
      drawn.yaw_rate += scale * (v * std::tan(phi) - u.speed * std::tan(angle)) / noise.wheelbase;
      p.pose = p.pose * displacement(drawn);
      p.pose.yaw += scale * gamma * u.duration;
    }
  }

  void update(const GnssFix& fix) {
    const FixSigmas sigma = fix_sigmas(parameters_.likelihood, fix);
    const double radius =
        bias_filter_.update(fix.position, predicted_.position(), sigma, now_ - last_fix_).norm();
    last_fix_ = now_;
    sample_ring(radius, sigma);
    for (Particle& p : particles_) {
      p.log_weight += plain_log_likelihood(parameters_, fix, radius, p.pose.position());
    }
    normalise();
    take_stock();
    if (effective_sample_size_ < parameters_.ess_threshold) resample();
  }

  /// Eqs. (34), (35) and the variances of x, y and yaw.
  [[nodiscard]] Pose2 mean() const { return predicted_; }
  [[nodiscard]] Eigen::Vector3d variances() const { return variances_; }

  /// Eq. (39), before resampling.
  [[nodiscard]] double effective_sample_size() const { return effective_sample_size_; }

 private:
  struct Particle {
    Pose2 pose;
    double log_weight = 0.0;
  };

  double normal() { return normal_(generator_); }
  double uniform() { return uniform_(generator_); }

  void forget_weights() {
    for (Particle& p : particles_) p.log_weight = -std::log(static_cast<double>(particles_.size()));
  }

  /// Eqs. (22)-(26), the weight by rho - r_hat.
  void sample_ring(double radius, const FixSigmas& sigma) {
    const auto size = static_cast<double>(particles_.size());
    const double count = std::floor(parameters_.ring.ring_fraction * size + uniform());
    const double offset = uniform();
    for (double k = 0.0; k < count; k += 1.0) {
      Particle& p = particles_[static_cast<std::size_t>((k + offset) * size / count)];
      const double rho = radius + sigma.direct * normal();
      const double direction = 2.0 * kPi * uniform();
      p.pose = {predicted_.x + rho * std::cos(direction), predicted_.y + rho * std::sin(direction),
                predicted_.yaw};
      p.log_weight = -std::log(size) - 0.5 * std::log(2.0 * kPi * sigma.shadow * sigma.shadow) -
                     0.5 * std::pow((rho - radius) / sigma.shadow, 2);
    }
  }

  void normalise() {
    double largest = particles_.front().log_weight;
    for (const Particle& p : particles_) largest = std::max(largest, p.log_weight);
    double sum = 0.0;
    for (const Particle& p : particles_) sum += std::exp(p.log_weight - largest);
    for (Particle& p : particles_) p.log_weight -= largest + std::log(sum);
  }

  void take_stock() {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();
    for (const Particle& p : particles_) {
      const double w = std::exp(p.log_weight);
      position += w * p.pose.position();
      direction += w * Eigen::Vector2d(std::cos(p.pose.yaw), std::sin(p.pose.yaw));
    }
    predicted_ = {position.x(), position.y(), std::atan2(direction.y(), direction.x())};
    variances_.setZero();
    double squares = 0.0;
    for (const Particle& p : particles_) {
      const Eigen::Vector3d deviation(p.pose.x - predicted_.x, p.pose.y - predicted_.y,
                                      angle_difference(p.pose.yaw, predicted_.yaw));
      variances_ += std::exp(p.log_weight) * deviation.cwiseProduct(deviation);
      squares += std::exp(2.0 * p.log_weight);
    }
    effective_sample_size_ = 1.0 / squares;
  }

  /// Eqs. (40)-(43).
  void resample() {
    std::vector<double> weights;
    for (const Particle& p : particles_) weights.push_back(std::exp(p.log_weight));
    particles_ = selected(particles_, systematic_resampling(weights, particles_.size(), uniform()));
    forget_weights();
  }

  FixParticleFilterParameters parameters_;
  BiasFilter bias_filter_;
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  std::vector<Particle> particles_;
  Pose2 predicted_;
  Eigen::Vector3d variances_;
  double effective_sample_size_ = 0.0;
  double now_ = 0.0;
  double last_fix_ = 0.0;
};

}  // namespace multipath_localization
