#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "estimators/pseudorange_particle/pseudorange_particle_filter.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kRestartYawSigma = 0.3;      ///< [rad]
constexpr double kMostRestartedAtOnce = 0.1;  ///< of the particles: an outage does not make the fix better

/// Any matrix of which M M' is the covariance.
template <int N>
Eigen::Matrix<double, N, N> root_of(const Eigen::Matrix<double, N, N>& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> axes(covariance);
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace

void PseudorangeParticleFilter::start(const std::optional<PosePrior>& prior) {
  particles_ = ParticleSet();
  rest_.clear();
  inter_system_bias_.forget();
  heights_known_ = false;
  last_increment_ = OdometryIncrement{};
  step_ = 0;
  lost_since_.reset();
  now_ = evidence_time_ = time_since_epoch_ = excluded_share_ = 0.0;
  if (prior && usable(*prior)) start_at(*prior);
}

void PseudorangeParticleFilter::draw_errors() {
  rest_.assign(particles_.size(), PseudorangeParticle{});
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    RandomStream draw = random(i);
    rest_[i].errors.speed_scale = parameters_.motion.speed_scale_sigma * draw.normal();
    rest_[i].errors.gyro_bias = parameters_.motion.gyro_bias_sigma * draw.normal();
  }
  ++step_;
}

void PseudorangeParticleFilter::start_at(const PosePrior& prior) {
  now_ = prior.stamp;
  particles_ = ParticleSet(static_cast<std::size_t>(parameters_.particles));
  draw_errors();
  const Eigen::Matrix3d root = root_of<3>(prior.covariance);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    const Eigen::Vector3d d = root * normals<3>(draw);
    particles_.set_pose(i, {prior.pose.x + d.x(), prior.pose.y + d.y(), wrap_angle(prior.pose.yaw + d.z())});
    rest_[i].course_variance = prior.covariance(2, 2);
  }
  ++step_;
  take_stock();
}

void PseudorangeParticleFilter::draw_heights(const PseudorangeSolution& fix) {
  const double sigma = std::hypot(std::sqrt(fix.covariance(2, 2)), parameters_.start_sigma);
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    RandomStream draw = random(i);
    rest_[i].height = fix.position.z() + sigma * draw.normal();
  }
  heights_known_ = true;
  ++step_;
}

std::optional<PseudorangeSolution> PseudorangeParticleFilter::start_fix(const Sky& sky) const {
  if (parameters_.start == StartPosition::kRobust) return sky.fix;
  return solve_position(sky.observations, sky.weights, Eigen::Vector3d::Zero());
}

Innovation PseudorangeParticleFilter::start_at(const Sky& sky) {
  const auto fix = start_fix(sky);
  if (!fix) return refused(Reason::kTooFewSatellites);
  particles_ = ParticleSet(static_cast<std::size_t>(parameters_.particles));
  draw_errors();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    particles_.yaw[i] = kPi * (2.0 * draw.uniform() - 1.0);
    rest_[i].course_variance = kPi * kPi / 3.0;
    draw_near(i, sky, *fix, draw);
  }
  heights_known_ = true;
  ++step_;
  LosSubset subset(sky.observations, sky.weights, inter_system_bias_, parameters_.subset);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Eigen::Vector2d antenna = particles_.pose(i) * sky.antenna_in_base;
    if (subset.solve({antenna.x(), antenna.y(), rest_[i].height})) adopt_velocity(i, sky, subset);
  }
  settle();
  subset.solve(mean_antenna(sky.antenna_in_base));
  excluded_share_ = subset.excluded_share();
  Innovation first;
  first.reason = Reason::kAccepted;
  return first;
}

/// Puts a particle near a fix, its heading kept.
void PseudorangeParticleFilter::draw_near(std::size_t i, const Sky& sky, const PseudorangeSolution& fix,
                                          RandomStream& random) {
  const Eigen::Matrix3d covariance =
      fix.covariance + square(parameters_.start_sigma) * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d antenna = fix.position + covariance.llt().matrixL() * normals<3>(random);
  const Eigen::Vector2d base = antenna.head<2>() - rotation(particles_.yaw[i]) * sky.antenna_in_base;
  particles_.x[i] = base.x();
  particles_.y[i] = base.y();
  rest_[i].height = antenna.z();
}

/// A few particles try the robust fix at any time, so that a cloud gone astray is contradicted by its own
/// weights. Departs: [SUZ] has no way back.
void PseudorangeParticleFilter::restart_some(const Sky& sky) {
  if (parameters_.reset == Reset::kNever || !sky.fix) return;
  const double probability = std::min(kMostRestartedAtOnce, parameters_.restart_rate * time_since_epoch_);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    if (draw.uniform() >= probability) continue;
    particles_.yaw[i] = wrap_angle(particles_.yaw[i] + kRestartYawSigma * draw.normal());
    rest_[i].course_variance += square(kRestartYawSigma);
    draw_near(i, sky, *sky.fix, draw);
    particles_.log_weight[i] = -std::log(static_cast<double>(particles_.size()));
  }
  ++step_;
}

void PseudorangeParticleFilter::restart_all(const Sky& sky) {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    draw_near(i, sky, *sky.fix, draw);
    particles_.log_weight[i] = 0.0;
  }
  ++step_;
}

}  // namespace multipath_localization
