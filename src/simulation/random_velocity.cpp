#include "simulation/random_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/gauss_markov.hpp"
#include "simulation/random_ranges.hpp"
#include "simulation/streams.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

namespace ranges = random_ranges;

constexpr double kOutlierRun = 1.5;  ///< mean time that a reflection stays the strongest signal [s]

Eigen::Vector2d true_velocity(const MotionStep& step) {
  return rotation(step.base_in_map.yaw) * Eigen::Vector2d(step.speed, 0.0);
}

bool in_outage(const RandomReceiver& receiver, double time) {
  return std::any_of(receiver.outages.begin(), receiver.outages.end(),
                     [time](const RandomOutage& outage) { return outage.when.holds(time); });
}

}  // namespace

RandomVelocity draw_velocity(std::uint64_t seed) {
  RandomStream random(seed, 0, kRandomVelocityStream);
  RandomVelocity velocity;
  velocity.period_ms = one_of(random, {100, 200, 200, 1000});
  const double sigma = draw(random, ranges::kVelocitySigma);
  const double slow_share = draw(random, Span{0.0, 1.0});
  velocity.white_sigma = sigma * std::sqrt(1.0 - slow_share);
  velocity.slow_sigma = sigma * std::sqrt(slow_share);
  velocity.slow_time = draw(random, ranges::kVelocityTime);
  velocity.lag_ms = kWayStepMs * static_cast<int>(draw(random, ranges::kVelocityLag) / kWayStep);
  velocity.declared = sigma * draw(random, ranges::kVelocityDeclared);
  velocity.outlier_share = draw(random, ranges::kVelocityOutliers);
  velocity.outlier_sigma = draw(random, ranges::kVelocityOutlier);
  return velocity;
}

std::vector<GnssVelocity> read_velocities(const RandomVelocity& velocity, const RandomReceiver& receiver,
                                          const std::vector<MotionStep>& steps, std::uint64_t seed) {
  RandomStream random(seed, 1, kRandomVelocityStream);
  GaussMarkov2 slow(velocity.slow_sigma, velocity.slow_time, RandomStream(seed, 2, kRandomVelocityStream));
  const auto stride = static_cast<std::size_t>(velocity.period_ms / kWayStepMs);
  const auto lag = static_cast<std::size_t>(velocity.lag_ms / kWayStepMs);
  const double period = 1e-3 * velocity.period_ms;
  Eigen::Vector2d outlier = Eigen::Vector2d::Zero();
  double outlier_until = 0.0;
  std::vector<GnssVelocity> read;
  for (std::size_t n = stride; n <= steps.size(); n += stride) {
    const double time = static_cast<double>(n) * kWayStepMs / 1000.0;
    const MotionStep& then = steps[n - 1 - std::min(lag, n - 1)];
    slow.step(period, random);
    const bool shadow = shadow_at(receiver, steps[n - 1].base_in_map.position()) != nullptr;
    const double share = (shadow ? 2.0 : 1.0) * velocity.outlier_share;
    if (time >= outlier_until) {
      outlier.setZero();
      if (chance(random, share * std::min(1.0, period / kOutlierRun))) {
        outlier = normal2(random, velocity.outlier_sigma);
        outlier_until = time + kOutlierRun * draw(random, Span{0.5, 1.5});
      }
    }
    GnssVelocity made;
    made.stamp = time;
    made.velocity = true_velocity(then) + slow.value() + normal2(random, velocity.white_sigma) + outlier;
    made.covariance = square(velocity.declared) * Eigen::Matrix2d::Identity();
    if (!in_outage(receiver, time)) read.push_back(made);
  }
  return read;
}

}  // namespace multipath_localization
