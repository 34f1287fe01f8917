#include "multipath_localization/estimators/fix_particle_filter.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "multipath_localization/filters/resampling.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kMostHypotheses = 2000;
constexpr std::uint32_t kResampling = 0xFFFFFFFFU;  ///< random stream beside those of the particles
constexpr double kLeastClusterReach = 2.0;          ///< [m]
constexpr double kClusterSigmas = 3.0;
constexpr double kClusterTurn = 0.6;       ///< [rad]
constexpr double kYawSigmaFloor = 0.01;    ///< added to the published heading [rad]
constexpr double kAlignedYawSigma = 0.3;   ///< [rad]
constexpr double kAlignedDominance = 0.5;  ///< probability mass

double square(double x) { return x * x; }

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

FixParticleFilter::FixParticleFilter(const FixParticleFilterParameters& parameters, std::uint64_t seed)
    : parameters_(parameters), seed_(seed), bias_radius_(parameters.bias), heading_(parameters.heading) {}

RandomStream FixParticleFilter::random(std::size_t particle) const {
  return RandomStream(seed_, step_, static_cast<std::uint32_t>(particle));
}

void FixParticleFilter::start(const std::optional<PosePrior>& prior) {
  particles_ = ParticleSet();
  fix_check_.forget();
  bias_radius_.forget();
  bias_.setZero();
  step_ = 0;
  now_ = last_fix_ = 0.0;
  if (prior && usable(*prior)) start_at(*prior);
}

void FixParticleFilter::start_at(const PosePrior& prior) {
  now_ = last_fix_ = prior.stamp;
  particles_ = ParticleSet(static_cast<std::size_t>(parameters_.particles));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(prior.covariance);
  const Eigen::Matrix3d root =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    Eigen::Vector3d d;
    for (double& component : d.reshaped()) component = draw.normal();
    d = root * d;
    particles_.set_pose(i, {prior.pose.x + d.x(), prior.pose.y + d.y(), wrap_angle(prior.pose.yaw + d.z())});
  }
  cluster_reach_ = std::max(kLeastClusterReach, kClusterSigmas * root.topRows<2>().norm());
  begin_tracking();
}

void FixParticleFilter::start_at(const GnssFix& fix) {
  particles_ = ParticleSet(static_cast<std::size_t>(parameters_.particles));
  const double sigma = std::hypot(parameters_.start_sigma, likelihood_of(fix, 0.0).sigma_b());
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    const double yaw = kPi * (2.0 * draw.uniform() - 1.0);
    const Eigen::Vector2d antenna = fix.position + sigma * Eigen::Vector2d(draw.normal(), draw.normal());
    const Eigen::Vector2d base = antenna - rotation(yaw) * fix.antenna_in_base;
    particles_.set_pose(i, {base.x(), base.y(), yaw});
  }
  cluster_reach_ = std::max(kLeastClusterReach, kClusterSigmas * sigma);
  last_fix_ = now_;
  begin_tracking();
}

void FixParticleFilter::begin_tracking() {
  ++step_;
  shadow_share_.assign(particles_.size(), 0.0);
  take_stock();
}

void FixParticleFilter::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  if (particles_.empty() || standing(u)) return;
  if (particles_are_fresh_ && parameters_.propagate_from == "estimate") {
    for (std::size_t i = 0; i < particles_.size(); ++i) particles_.set_pose(i, predicted_);
  }
  particles_are_fresh_ = false;
  const SteeringMotion motion(u, parameters_.motion);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    particles_.set_pose(i, motion.sample(particles_.pose(i), draw));
  }
  predicted_ = predicted_ * displacement(u);
  heading_.add(u);
  ++step_;
}

Innovation FixParticleFilter::update(const Measurement& z) {
  const auto* fix = std::get_if<GnssFix>(&z);
  if (fix == nullptr) return refused(Reason::kUnused);
  if (const auto reason = fix_check_.defect(*fix)) return refused(*reason);
  if (particles_.empty()) {
    start_at(*fix);
    Innovation first;
    first.reason = Reason::kAccepted;
    return first;
  }
  const Innovation result = compare(*fix);
  const bool aligned = estimate().aligned;
  const Eigen::Vector2d antenna = predicted_ * fix->antenna_in_base;
  const double radius =
      bias_radius_.update(fix->position, antenna, likelihood_of(*fix, 0.0).sigma_s(), now_ - last_fix_);
  const GnssLikelihood likelihood = likelihood_of(*fix, radius);
  if (aligned && parameters_.ring.ring_fraction > 0.0) sample_ring(radius, likelihood);
  weigh(*fix, likelihood);
  cluster_reach_ = std::max(kLeastClusterReach, kClusterSigmas * likelihood.sigma_b());
  take_stock();
  if (effective_sample_size_ < parameters_.ess_threshold) resample();
  const Eigen::Vector2d to_fix = fix->position - predicted_ * fix->antenna_in_base;
  bias_ = to_fix.norm() > 0.0 ? Eigen::Vector2d(radius * to_fix.normalized()) : Eigen::Vector2d::Zero();
  last_fix_ = now_;
  ++step_;
  return result;
}

GnssLikelihood FixParticleFilter::likelihood_of(const GnssFix& fix, double radius) const {
  return GnssLikelihood(parameters_.likelihood, fix.covariance, parameters_.ring.shadow_weight, radius);
}

Innovation FixParticleFilter::compare(const GnssFix& fix) const {
  const PoseEstimate before = estimate();
  const Eigen::Matrix<double, 2, 3> H = antenna_jacobian(before.pose, fix.antenna_in_base);
  Innovation result;
  result.reason = Reason::kAccepted;
  result.innovation = fix.position - before.pose * fix.antenna_in_base;
  result.covariance = H * before.covariance * H.transpose() +
                      square(likelihood_of(fix, 0.0).sigma_b()) * Eigen::Matrix2d::Identity();
  result.nis = result.innovation.dot(result.covariance.llt().solve(result.innovation));
  return result;
}

/// p_r of [NIS], Eqs. (22)-(26). Departs: Eq. (24) prints r_s for the mean r_hat.
void FixParticleFilter::sample_ring(double radius, const GnssLikelihood& likelihood) {
  const double sigma_s = likelihood.sigma_s();
  const bool printed = parameters_.ring.ring_weight == "printed";
  const double log_scale =
      -std::log(static_cast<double>(particles_.size())) - 0.5 * std::log(2.0 * kPi * square(sigma_s));
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    if (draw.uniform() >= parameters_.ring.ring_fraction) continue;
    const double psi = kPi * (2.0 * draw.uniform() - 1.0);
    const double rho = radius + likelihood.sigma_b() * draw.normal();
    particles_.set_pose(
        i, {predicted_.x + rho * std::cos(psi), predicted_.y + rho * std::sin(psi), predicted_.yaw});
    // Departs, unless "printed": Eq. (26) has rho in the place of rho - r_hat, which kills the ring once it
    // is wide.
    particles_.log_weight[i] = log_scale - 0.5 * square((printed ? rho : rho - radius) / sigma_s);
  }
}

/// Eqs. (27)-(34) of [NIS].
void FixParticleFilter::weigh(const GnssFix& fix, const GnssLikelihood& likelihood) {
  const auto heading = heading_.heading(fix.position - rotation(predicted_.yaw) * fix.antenna_in_base);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Pose2 pose = particles_.pose(i);
    std::optional<double> heading_error;
    if (heading) heading_error = angle_difference(pose.yaw, *heading);
    const auto value = likelihood(pose * fix.antenna_in_base - fix.position, heading_error);
    particles_.log_weight[i] += value.log_likelihood;
    shadow_share_[i] = value.shadow_share;
  }
}

/// Eqs. (34), (35), (39) of [NIS]. Departs, unless "mean": Eq. (35) averages over clusters as well.
void FixParticleFilter::take_stock() {
  normalise(particles_.log_weight);
  weights_ = weights_of(particles_.log_weight);
  cluster_ = parameters_.point_estimate == "mean"
                 ? weights_
                 : dominant_cluster(particles_, weights_, cluster_reach_, kClusterTurn);
  effective_sample_size_ = effective_sample_size(weights_);
  predicted_ = moments(particles_, cluster_).mean;
  particles_are_fresh_ = true;
  if (heading_.due() || step_ == 1) heading_.restart(predicted_.position());
}

/// Eqs. (40)-(43) of [NIS].
void FixParticleFilter::resample() {
  const double uniform = RandomStream(seed_, step_, kResampling).uniform();
  const auto ancestors = systematic_resampling(weights_, particles_.size(), uniform);
  particles_ = particles_.selected(ancestors);
  shadow_share_ = selected(shadow_share_, ancestors);
  cluster_ = selected(cluster_, ancestors);
  weights_ = weights_of(particles_.log_weight);
  for (std::size_t i = 0; i < cluster_.size(); ++i) cluster_[i] = cluster_[i] > 0.0 ? weights_[i] : 0.0;
}

PoseEstimate FixParticleFilter::estimate() const {
  PoseEstimate result;
  result.stamp = now_;
  if (particles_.empty()) return result;
  const PoseMoments within = moments(particles_, cluster_);
  result.valid = true;
  result.pose = within.mean;
  result.covariance = within.covariance;
  result.dominance = std::min(1.0, sum(cluster_));
  const double floor = square(parameters_.position_sigma_floor);
  result.covariance.diagonal() += Eigen::Vector3d(floor, floor, square(kYawSigmaFloor));
  result.position_covariance_overall = floor * Eigen::Matrix2d::Identity();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Eigen::Vector2d d(particles_.x[i] - result.pose.x, particles_.y[i] - result.pose.y);
    result.position_covariance_overall += weights_[i] * d * d.transpose();
  }
  result.aligned = result.dominance > kAlignedDominance && result.covariance(2, 2) < square(kAlignedYawSigma);
  result.shadow_probability =
      std::min(1.0, std::inner_product(weights_.begin(), weights_.end(), shadow_share_.begin(), 0.0));
  result.effective_sample_size = effective_sample_size_;
  if (parameters_.ring.shadow_weight == 0.0) return result;
  result.bias = bias_;
  result.bias_covariance = bias_radius_.covariance();
  return result;
}

std::vector<Hypothesis> FixParticleFilter::hypotheses() const {
  const std::size_t stride = (particles_.size() + kMostHypotheses - 1) / kMostHypotheses;
  std::vector<Hypothesis> all;
  double total = 0.0;
  for (std::size_t i = 0; i < particles_.size(); i += stride) {
    all.push_back({particles_.pose(i), weights_[i], shadow_share_[i] > 0.5 ? Mode::kShadow : Mode::kOpen});
    total += weights_[i];
  }
  for (Hypothesis& hypothesis : all) hypothesis.weight /= total;
  return all;
}

}  // namespace multipath_localization
