#include "estimators/pseudorange_particle/pseudorange_cloud.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "multipath_localization/filters/resampling.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kMostHypotheses = 2000;
constexpr double kYawSigmaFloor = 0.01;             ///< added to the published heading [rad]
constexpr double kAlignedYawSigma = 0.3;            ///< [rad]
constexpr double kAlignedDominance = 0.5;           ///< probability mass
constexpr double kMoving = 0.5;                     ///< by Doppler [m/s]
constexpr double kRestartYawSigma = 0.3;            ///< [rad]
constexpr std::uint32_t kResampling = 0xFFFFFFFFU;  ///< random stream beside those of the particles
constexpr double kNever = -std::numeric_limits<double>::infinity();

/// Any matrix of which M M' is the covariance.
template <int N>
Eigen::Matrix<double, N, N> root_of(const Eigen::Matrix<double, N, N>& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> axes(covariance);
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

/// log of the likelihood, Eqs. (11), (12) of [SUZ], up to a constant. Departs, unless "distance": Eq. (12)
/// prints the normal density without the determinant of Sigma.
double log_likelihood(const SubsetSolution& solution, const SubsetLikelihoodParameters& parameters) {
  const double quadratic = -0.5 * solution.mahalanobis_squared / square(parameters.likelihood_sigma);
  return parameters.likelihood == SubsetLikelihood::kDensity ? 0.5 * solution.log_determinant + quadratic
                                                             : quadratic;
}

/// What a subset that says next to nothing would give.
double log_floor(const SubsetLikelihoodParameters& parameters) {
  if (parameters.likelihood != SubsetLikelihood::kDensity || parameters.outlier_sigma == 0.0) return kNever;
  return -3.0 * std::log(parameters.outlier_sigma);
}

}  // namespace

void PseudorangeCloud::clear() {
  particles_ = ParticleSet();
  rest_.clear();
  step_ = 0;
}

void PseudorangeCloud::draw_errors() {
  rest_.assign(particles_.size(), PseudorangeParticle{});
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    RandomStream draw = random(i);
    rest_[i].errors.speed_scale = parameters_.motion.speed_scale_sigma * draw.normal();
    rest_[i].errors.gyro_bias = parameters_.motion.gyro_bias_sigma * draw.normal();
  }
  ++step_;
}

void PseudorangeCloud::start_at(const PosePrior& prior) {
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

void PseudorangeCloud::start_near(const PseudorangeSolution& fix, const Eigen::Vector2d& antenna_in_base) {
  particles_ = ParticleSet(static_cast<std::size_t>(parameters_.particles));
  draw_errors();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    particles_.yaw[i] = kPi * (2.0 * draw.uniform() - 1.0);
    rest_[i].course_variance = kPi * kPi / 3.0;
    draw_near(i, fix, antenna_in_base, draw);
  }
  ++step_;
}

void PseudorangeCloud::draw_heights(const PseudorangeSolution& fix) {
  const double sigma = std::hypot(std::sqrt(fix.covariance(2, 2)), parameters_.start_sigma);
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    RandomStream draw = random(i);
    rest_[i].height = fix.position.z() + sigma * draw.normal();
  }
  ++step_;
}

void PseudorangeCloud::draw_near(std::size_t i, const PseudorangeSolution& fix,
                                 const Eigen::Vector2d& antenna_in_base, RandomStream& random) {
  const Eigen::Matrix3d covariance =
      fix.covariance + square(parameters_.start_sigma) * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d antenna = fix.position + covariance.llt().matrixL() * normals<3>(random);
  const Eigen::Vector2d base = antenna.head<2>() - rotation(particles_.yaw[i]) * antenna_in_base;
  particles_.x[i] = base.x();
  particles_.y[i] = base.y();
  rest_[i].height = antenna.z();
}

void PseudorangeCloud::restart_some(const PseudorangeSolution& fix, const Eigen::Vector2d& antenna_in_base,
                                    double probability) {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    if (draw.uniform() >= probability) continue;
    particles_.yaw[i] = wrap_angle(particles_.yaw[i] + kRestartYawSigma * draw.normal());
    rest_[i].course_variance += square(kRestartYawSigma);
    draw_near(i, fix, antenna_in_base, draw);
    particles_.log_weight[i] = -std::log(static_cast<double>(particles_.size()));
  }
  ++step_;
}

void PseudorangeCloud::restart_all(const PseudorangeSolution& fix, const Eigen::Vector2d& antenna_in_base) {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw = random(i);
    draw_near(i, fix, antenna_in_base, draw);
    particles_.log_weight[i] = 0.0;
  }
  ++step_;
}

void PseudorangeCloud::move(const OdometryIncrement& u, const OdometryIncrement& before) {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Pose2 pose = particles_.pose(i);
    RandomStream draw = random(i);
    multipath_localization::move(pose, rest_[i], u, before, parameters_.motion, draw);
    particles_.set_pose(i, pose);
  }
  ++step_;
}

bool PseudorangeCloud::moves() const {
  return std::any_of(rest_.begin(), rest_.end(), [](const PseudorangeParticle& particle) {
    return particle.velocity && particle.velocity->head<2>().norm() > kMoving;
  });
}

void PseudorangeCloud::forget_velocities() {
  for (PseudorangeParticle& particle : rest_) particle.velocity.reset();
}

bool PseudorangeCloud::weigh(const PreparedEpoch& epoch, LosSubset& subset, double exponent,
                             const OdometryIncrement& u) {
  const double floor = log_floor(parameters_.likelihood);
  bool any = false;
  std::vector<double> gain(particles_.size(), floor);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Eigen::Vector2d antenna = particles_.pose(i) * epoch.antenna_in_base;
    const auto solution = subset.solve({antenna.x(), antenna.y(), rest_[i].height});
    if (!solution) continue;
    any = true;
    gain[i] = std::max(floor, log_likelihood(*solution, parameters_.likelihood));
    adopt_velocity(i, epoch, subset, u);
  }
  for (std::size_t i = 0; any && exponent > 0.0 && i < gain.size(); ++i) {
    particles_.log_weight[i] += exponent * gain[i];
  }
  return any;
}

void PseudorangeCloud::adopt_velocities(const PreparedEpoch& epoch, LosSubset& subset,
                                        const OdometryIncrement& u) {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Eigen::Vector2d antenna = particles_.pose(i) * epoch.antenna_in_base;
    if (subset.solve({antenna.x(), antenna.y(), rest_[i].height})) adopt_velocity(i, epoch, subset, u);
  }
}

void PseudorangeCloud::adopt_velocity(std::size_t i, const PreparedEpoch& epoch, const LosSubset& subset,
                                      const OdometryIncrement& u) {
  if (parameters_.motion.motion == MotionSource::kOdometry) return;
  const auto velocity = subset.velocity(parameters_.motion.doppler_tolerance);
  if (!velocity) {
    if (parameters_.motion.motion == MotionSource::kAuto) rest_[i].velocity.reset();
    return;
  }
  Pose2 pose = particles_.pose(i);
  multipath_localization::adopt_velocity(pose, rest_[i], *velocity, epoch.antenna_in_base, u);
  particles_.yaw[i] = pose.yaw;
}

void PseudorangeCloud::take_stock() {
  normalise(particles_.log_weight);
  weights_ = weights_of(particles_.log_weight);
  effective_sample_size_ = effective_sample_size(weights_);
  constexpr double kReach = 30.0;  // [m]
  constexpr double kTurn = 0.6;    // [rad]
  cluster_ = parameters_.point_estimate == PointEstimate::kMean
                 ? weights_
                 : dominant_cluster(particles_, weights_, kReach, kTurn);
}

void PseudorangeCloud::resample_if_uneven() {
  if (effective_sample_size_ > parameters_.ess_fraction * static_cast<double>(particles_.size())) return;
  const double uniform = RandomStream(seed_, step_, kResampling).uniform();
  const auto ancestors = systematic_resampling(weights_, particles_.size(), uniform);
  particles_ = particles_.selected(ancestors);
  rest_ = selected(rest_, ancestors);
  ++step_;
}

Eigen::Vector3d PseudorangeCloud::mean_antenna(const Eigen::Vector2d& antenna_in_base) const {
  const Eigen::Vector2d position = moments(particles_, cluster_).mean * antenna_in_base;
  double height = 0.0;
  double mass = 0.0;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    height += cluster_[i] * rest_[i].height;
    mass += cluster_[i];
  }
  return {position.x(), position.y(), height / mass};
}

PoseEstimate PseudorangeCloud::estimate() const {
  PoseEstimate result;
  const PoseMoments within = moments(particles_, cluster_);
  result.valid = true;
  result.pose = within.mean;
  result.covariance = within.covariance;
  result.dominance = std::min(1.0, std::accumulate(cluster_.begin(), cluster_.end(), 0.0));
  const double floor = square(parameters_.position_sigma_floor);
  result.covariance.diagonal() += Eigen::Vector3d(floor, floor, square(kYawSigmaFloor));
  result.position_covariance_overall = floor * Eigen::Matrix2d::Identity();
  double course_variance = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Eigen::Vector2d d(particles_.x[i] - result.pose.x, particles_.y[i] - result.pose.y);
    result.position_covariance_overall += weights_[i] * d * d.transpose();
    if (rest_[i].velocity) course_variance += weights_[i] * rest_[i].course_variance;
  }
  result.covariance(2, 2) += course_variance;
  result.aligned = result.dominance > kAlignedDominance && result.covariance(2, 2) < square(kAlignedYawSigma);
  result.effective_sample_size = effective_sample_size_;
  return result;
}

std::vector<Hypothesis> PseudorangeCloud::hypotheses() const {
  const std::size_t stride = (particles_.size() + kMostHypotheses - 1) / kMostHypotheses;
  std::vector<Hypothesis> all;
  double total = 0.0;
  for (std::size_t i = 0; i < particles_.size(); i += stride) {
    all.push_back({particles_.pose(i), weights_[i], Mode::kOpen});
    total += weights_[i];
  }
  for (Hypothesis& hypothesis : all) hypothesis.weight /= total;
  return all;
}

}  // namespace multipath_localization
