#include "estimators/pseudorange_particle/pseudorange_particle_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "multipath_localization/core/epoch_check.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/models/pseudorange/signal_weights.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kMostHypotheses = 2000;
constexpr double kYawSigmaFloor = 0.01;    ///< added to the published heading [rad]
constexpr double kAlignedYawSigma = 0.3;   ///< [rad]
constexpr double kAlignedDominance = 0.5;  ///< probability mass
constexpr double kMoving = 0.5;            ///< by Doppler [m/s]
constexpr double kVelocityLasts = 3.0;     ///< without an epoch [s]

double free_or(double sigma, ConstellationClocks constellations) {
  return constellations == ConstellationClocks::kTied ? sigma : std::numeric_limits<double>::infinity();
}

bool moves(const PseudorangeParticle& particle) {
  return particle.velocity && particle.velocity->head<2>().norm() > kMoving;
}

}  // namespace

PseudorangeParticleFilter::PseudorangeParticleFilter(const PseudorangeParticleFilterParameters& parameters,
                                                     std::uint64_t seed)
    : parameters_(parameters),
      seed_(seed),
      inter_system_bias_(free_or(parameters.inter_system_sigma, parameters.constellations)) {}

RandomStream PseudorangeParticleFilter::random(std::size_t particle) const {
  return RandomStream(seed_, step_, static_cast<std::uint32_t>(particle));
}

void PseudorangeParticleFilter::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  const OdometryIncrement before = std::exchange(last_increment_, u);
  if (particles_.empty()) return;
  time_since_epoch_ += u.duration;
  if (parameters_.motion.motion == MotionSource::kAuto && time_since_epoch_ > kVelocityLasts)
    forget_velocities();
  const bool moving = !standing(u) || std::any_of(rest_.begin(), rest_.end(), moves);
  evidence_time_ += (moving ? 1.0 : parameters_.likelihood.standing_evidence) * u.duration;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Pose2 pose = particles_.pose(i);
    RandomStream draw = random(i);
    move(pose, rest_[i], u, before, parameters_.motion, draw);
    particles_.set_pose(i, pose);
  }
  ++step_;
}

void PseudorangeParticleFilter::forget_velocities() {
  for (PseudorangeParticle& particle : rest_) particle.velocity.reset();
}

PseudorangeParticleFilter::Sky PseudorangeParticleFilter::sky_of(const PseudorangeEpoch& epoch) const {
  Sky sky;
  sky.observations = usable_observations(epoch);
  sky.antenna_in_base = epoch.antenna_in_base;
  const std::vector<double> by_signal = signal_weights(sky.observations);
  sky.weights =
      parameters_.weighting == SatelliteWeighting::kSignal ? by_signal : declared_weights(sky.observations);
  sky.fix = one_sided_position(sky.observations, by_signal, parameters_.robust,
                               particles_.empty() || !heights_known_ ? Eigen::Vector3d(0.0, 0.0, 0.0)
                                                                     : mean_antenna(epoch.antenna_in_base));
  return sky;
}

Innovation PseudorangeParticleFilter::update(const Measurement& z) {
  const auto* epoch = std::get_if<PseudorangeEpoch>(&z);
  if (epoch == nullptr) return refused(Reason::kUnused);
  if (const auto reason = defect(*epoch)) return refused(*reason);
  const Sky sky = sky_of(*epoch);
  if (sky.fix) inter_system_bias_.adopt(*sky.fix);
  if (particles_.empty()) return start_at(sky);
  if (!heights_known_) {
    if (!sky.fix) return refused(Reason::kTooFewSatellites);
    draw_heights(*sky.fix);
  }
  return track(sky);
}

void PseudorangeParticleFilter::take_stock() {
  normalise(particles_.log_weight);
  weights_ = weights_of(particles_.log_weight);
  effective_sample_size_ = effective_sample_size(weights_);
  constexpr double kReach = 30.0;  // [m]
  constexpr double kTurn = 0.6;    // [rad]
  cluster_ = parameters_.point_estimate == PointEstimate::kMean
                 ? weights_
                 : dominant_cluster(particles_, weights_, kReach, kTurn);
}

Eigen::Vector3d PseudorangeParticleFilter::mean_antenna(const Eigen::Vector2d& antenna_in_base) const {
  const Eigen::Vector2d position = moments(particles_, cluster_).mean * antenna_in_base;
  double height = 0.0;
  double mass = 0.0;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    height += cluster_[i] * rest_[i].height;
    mass += cluster_[i];
  }
  return {position.x(), position.y(), height / mass};
}

PoseEstimate PseudorangeParticleFilter::estimate() const {
  PoseEstimate result;
  result.stamp = now_;
  if (particles_.empty()) return result;
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
  result.shadow_probability = excluded_share_;
  result.effective_sample_size = effective_sample_size_;
  return result;
}

std::vector<Hypothesis> PseudorangeParticleFilter::hypotheses() const {
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
