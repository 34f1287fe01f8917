#include "tools/benchmark/naive_filter.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "tools/benchmark/workload.hpp"

namespace multipath_localization {

namespace {

constexpr double kRadius = 0.5;         ///< r_hat [m]
constexpr double kRingFraction = 0.05;  ///< of the particles
constexpr double kSigmaShadow = 0.316;  ///< [m]
constexpr double kSigmaHeading = 0.1;   ///< [rad]

double square(double x) { return x * x; }

}  // namespace

NaiveFilter::NaiveFilter(std::size_t size) : particles_(size) {
  for (Particle& p : particles_) {
    p = {0.3 * normal(), 0.3 * normal(), 0.05 * normal(), 1.0 / static_cast<double>(size)};
  }
}

void NaiveFilter::step(const OdometryIncrement& u, const GnssFix& fix) {
  move(u);
  sample_ring();
  weigh(fix);
  average();
  if (effective_sample_size_ < 2.0 * static_cast<double>(particles_.size())) resample();
}

void NaiveFilter::move(const OdometryIncrement& u) {
  const double v = u.speed;
  const double phi = std::atan(u.yaw_rate / u.speed);
  const double sigma_v = std::sqrt(3e-3 * (3.0 * v * v + 0.3 * phi * phi));
  const double sigma_phi = sigma_v;
  const double sigma_gamma = sigma_v;
  for (Particle& p : particles_) {
    const double drawn_v = v + sigma_v * normal();
    const double drawn_phi = phi + sigma_phi * normal();
    const double omega = drawn_v * std::tan(drawn_phi);
    const double half = 0.5 * omega * u.duration;
    const double chord = drawn_v * u.duration * (std::abs(half) < 1e-6 ? 1.0 : std::sin(half) / half);
    p.x += chord * std::cos(p.yaw + half);
    p.y += chord * std::sin(p.yaw + half);
    p.yaw = wrap_angle(p.yaw + omega * u.duration + sigma_gamma * normal() * u.duration);
  }
}

void NaiveFilter::sample_ring() {
  for (Particle& p : particles_) {
    if (uniform_(generator_) >= kRingFraction) continue;
    const double psi = 2.0 * kPi * uniform_(generator_);
    const double rho = kRadius + workload::kFixSigma * normal();
    p = {mean_x_ + rho * std::cos(psi), mean_y_ + rho * std::sin(psi), mean_yaw_,
         std::exp(-0.5 * square((rho - kRadius) / kSigmaShadow)) / static_cast<double>(particles_.size())};
  }
}

void NaiveFilter::weigh(const GnssFix& fix) {
  const double two_variance_b = 2.0 * square(workload::kFixSigma);
  const double two_variance_s = 2.0 * square(kSigmaShadow);
  const double two_variance_p = 2.0 * square(kSigmaHeading);
  for (Particle& p : particles_) {
    const double dx = p.x - fix.position.x();
    const double dy = p.y - fix.position.y();
    const double dyaw = wrap_angle(p.yaw - mean_yaw_);
    const double from_ring = std::sqrt(dx * dx + dy * dy) - kRadius;
    const double heading = std::exp(-dyaw * dyaw / two_variance_p) / (3.0 * kPi * two_variance_p);
    const double direct = 2.0 / 3.0 / (kPi * two_variance_b) *
                              (std::exp(-dx * dx / two_variance_b) + std::exp(-dy * dy / two_variance_b)) +
                          heading;
    const double shadow =
        2.0 / 3.0 / (kPi * two_variance_s) * std::exp(-from_ring * from_ring / two_variance_s) + heading;
    p.weight *= 0.5 * (direct + shadow);
  }
}

void NaiveFilter::average() {
  double sum = 0.0;
  for (const Particle& p : particles_) sum += p.weight;
  double x = 0.0;
  double y = 0.0;
  double c = 0.0;
  double s = 0.0;
  double squares = 0.0;
  for (Particle& p : particles_) {
    p.weight /= sum;
    squares += p.weight * p.weight;
    x += p.weight * p.x;
    y += p.weight * p.y;
    c += p.weight * std::cos(p.yaw);
    s += p.weight * std::sin(p.yaw);
  }
  effective_sample_size_ = 1.0 / squares;
  mean_x_ = x;
  mean_y_ = y;
  mean_yaw_ = std::atan2(s, c);
  variance_x_ = covariance_xy_ = variance_y_ = 0.0;
  for (const Particle& p : particles_) {
    variance_x_ += p.weight * square(p.x - mean_x_);
    covariance_xy_ += p.weight * (p.x - mean_x_) * (p.y - mean_y_);
    variance_y_ += p.weight * square(p.y - mean_y_);
  }
}

void NaiveFilter::resample() {
  const std::size_t size = particles_.size();
  const double step = 1.0 / static_cast<double>(size);
  std::vector<Particle> chosen;
  chosen.reserve(size);
  double tooth = step * uniform_(generator_);
  double reached = 0.0;
  std::size_t i = 0;
  while (chosen.size() < size) {
    while (i + 1 < size && reached + particles_[i].weight < tooth) reached += particles_[i++].weight;
    chosen.push_back(particles_[i]);
    chosen.back().weight = step;
    tooth += step;
  }
  particles_ = std::move(chosen);
}

}  // namespace multipath_localization
