#include "multipath_localization/estimators/multipath_particle_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/numbers.hpp"
#include "multipath_localization/models/odometry_motion.hpp"

namespace multipath_localization {

namespace {

constexpr double kMaxFlush = 1.2;        ///< odometry is linearised over at most this long [s]
constexpr double kSpeedMemory = 10.0;    ///< over which the usual speed is averaged [s]
constexpr double kMovedSinceFix = 0.02;  ///< less is a standing robot [m]
constexpr double kLockEndRate = 0.1;     ///< of wheels that stand; a slip of turning ones ends sooner [1/s]
constexpr std::uint32_t kMixing = 0xFFFFFFFFU;  ///< random streams beside those of the particles
constexpr std::uint32_t kResampling = 0xFFFFFFFEU;

/// Draws the index of one candidate in proportion to exp(log_weight), and gives log(sum(exp(log_weight))).
std::pair<std::size_t, double> draw(const std::array<double, kFixCandidates>& log_weight, double u) {
  const double highest = *std::max_element(log_weight.begin(), log_weight.end());
  std::array<double, kFixCandidates> weight{};
  double sum = 0.0;
  for (std::size_t k = 0; k < kFixCandidates; ++k) sum += weight[k] = std::exp(log_weight[k] - highest);
  std::size_t chosen = 0;
  double rest = u * sum;
  for (std::size_t k = 0; k < kFixCandidates; ++k) {
    if (weight[k] <= 0.0) continue;
    chosen = k;
    if ((rest -= weight[k]) <= 0.0) break;
  }
  return {chosen, highest + std::log(sum)};
}

}  // namespace

MultipathParticleFilter::MultipathParticleFilter(const MultipathParticleFilterParameters& parameters,
                                                 std::uint64_t seed)
    : parameters_(parameters),
      seed_(seed),
      prior_(prior_probabilities(parameters.classes)),
      odometry_(parameters.odometry),
      odometry_jump_(parameters.odometry_jump, parameters.odometry),
      alignment_(parameters.alignment_length, parameters.classes.street.quiet_sigma,
                 parameters.alignment_variance_floor) {}

void MultipathParticleFilter::tune(ParameterVisitor& field) {
  parameters_.tunable(field);
  odometry_.set_noise(parameters_.odometry);
  odometry_jump_ = OdometryJump(parameters_.odometry_jump, parameters_.odometry);
}

void MultipathParticleFilter::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  if (particles_.empty()) return;
  odometry_.add(u);
  odometry_jump_.add(u);
  distance_since_fix_ += std::abs(u.speed) * u.duration;
  since_fix_ = since_fix_ * displacement(u);
  if (!standing(u)) alignment_.add(u);
  if (odometry_.duration() <= kMaxFlush) return;
  doubt_odometry();
  flush_odometry();
}

void MultipathParticleFilter::flush_odometry() {
  for (BeliefParticle& particle : particles_) particle.belief.propagate(odometry_, parameters_.odometry);
  refresh_cluster();
}

void MultipathParticleFilter::refresh_cluster() {
  cluster_ = dominant_cluster(particles_);
  class_probability_ = class_weights(particles_);
  double squares = 0.0;
  for (const BeliefParticle& particle : particles_) squares += square(particle.weight);
  effective_sample_size_ = 1.0 / squares;
  odometry_.restart(cluster_.belief.mean(kScale), cluster_.belief.mean(kGyroBias));
}

Innovation MultipathParticleFilter::update(const Measurement& z) {
  const auto* fix = std::get_if<GnssFix>(&z);
  if (fix == nullptr) return refused(Reason::kUnused);
  if (const auto reason = fix_check_.defect(*fix)) return refused(*reason);
  if (particles_.empty()) {
    start_at(*fix);
    Innovation first;
    first.reason = Reason::kAccepted;
    return first;
  }
  flush_odometry();
  const Innovation result = innovation(*fix);
  weigh(*fix);
  return result;
}

Innovation MultipathParticleFilter::innovation(const GnssFix& fix) const {
  const FixPrediction prediction(cluster_.belief, fix.antenna_in_base);
  double noise_variance = 0.0;
  for (const BeliefParticle& particle : particles_) {
    noise_variance +=
        particle.weight * parameters_.classes[particle.receiver].noise_variance(particle.mode.noisy);
  }
  Innovation result;
  result.reason = Reason::kAccepted;
  result.innovation = fix.position - prediction.antenna - prediction.bias;
  result.covariance = prediction.antenna_covariance + prediction.cross_covariance +
                      prediction.bias_covariance + noise_variance * Eigen::Matrix2d::Identity();
  result.nis = result.innovation.dot(result.covariance.inverse() * result.innovation);
  return result;
}

FixInterval MultipathParticleFilter::interval(const ReceiverClass& receiver, double duration) const {
  FixInterval result;
  result.duration = duration;
  result.moving = moving();
  result.unseen_variance = unseen_variance();
  const bool locked = !result.moving && suspected_for_ > 0.0;
  const double hidden_speed = locked ? usual_speed_ : 0.0;
  result.slip_distance = result.moving ? distance_since_fix_ : hidden_speed * duration;
  result.position_restart_rate = confirmed_ ? 0.0 : receiver.jump_rate;
  result.heading_restart_rate = confirmed_ ? parameters_.heading_restart_rate : receiver.jump_rate;
  result.restart_sigma = std::max(parameters_.restart_sigma, doubtful_bias());
  result.slip_end_rate =
      locked ? std::min(kLockEndRate, parameters_.slip_end_rate) : parameters_.slip_end_rate;
  if (result.moving) result.aligned_heading = alignment_.heading();
  return result;
}

void MultipathParticleFilter::weigh(const GnssFix& fix) {
  const double duration = std::max(0.0, now_ - last_fix_);
  const bool suspect = suspect_wheels(duration);
  const double class_time = moving() || suspected_for_ > 0.0 ? duration : 0.0;
  if (moving() && duration > 0.0) {
    usual_speed_ += std::min(1.0, duration / kSpeedMemory) * (distance_since_fix_ / duration - usual_speed_);
    const Eigen::Vector2d lever = rotation(cluster_.belief.mean(kYaw)) * fix.antenna_in_base;
    alignment_.add(Eigen::Vector2d(fix.position - lever));
  }
  if (class_time > 0.0) update_confirmation();
  change_classes(class_time, suspect);
  const std::vector<double> log_likelihood = sample_modes(fix, duration);
  reweigh(particles_, log_likelihood, std::min(1.0, class_time / parameters_.class_evidence_time));
  refresh_cluster();
  doubt_steady_bias(moving() ? duration : 0.0);
  RandomStream resampling(seed_, step_, kResampling);
  resample_banks(particles_, static_cast<std::size_t>(parameters_.particles), parameters_.class_floor,
                 parameters_.ess_fraction, resampling);
  ++step_;
  last_fix_ = doubted_until_ = now_;
  distance_since_fix_ = 0.0;
  since_fix_ = Pose2{};
}

bool MultipathParticleFilter::moving() const { return way_since_fix() > kMovedSinceFix; }

void MultipathParticleFilter::change_classes(double duration, bool suspect) {
  PerClass entry = entry_probabilities(parameters_.classes, duration);
  if (suspect) entry[kWheelFault] = parameters_.odometry_jump.fault_probability;
  RandomStream mixing(seed_, step_, kMixing);
  mix_classes(particles_, parameters_.classes, entry, mixing);
}

std::vector<double> MultipathParticleFilter::sample_modes(const GnssFix& fix, double duration) {
  std::array<FixInterval, kReceiverClassCount> intervals;
  for (std::size_t k = 0; k < kReceiverClassCount; ++k)
    intervals[k] = interval(parameters_.classes[k], duration);
  std::vector<double> log_likelihood(particles_.size());
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    BeliefParticle& particle = particles_[i];
    const FixModes modes(parameters_.classes[particle.receiver], intervals[particle.receiver]);
    const FixCandidates candidates = modes.candidates(particle.mode, particle.belief);
    const FixPrediction prediction(particle.belief, fix.antenna_in_base);
    std::array<double, kFixCandidates> log_weight;
    log_weight.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < kFixCandidates; ++k) {
      if (candidates[k].prior <= 0.0) continue;
      log_weight[k] =
          std::log(candidates[k].prior) +
          modes.log_likelihood(candidates[k], prediction, particle.belief.mean(kYaw), fix.position);
    }
    RandomStream random(seed_, step_, static_cast<std::uint32_t>(i));
    const auto [chosen, evidence] = draw(log_weight, random.uniform());
    log_likelihood[i] = evidence;
    modes.apply(candidates[chosen], fix.position, fix.antenna_in_base, parameters_.odometry, particle.belief);
    particle.mode = candidates[chosen].mode;
  }
  return log_likelihood;
}

Belief MultipathParticleFilter::current_belief() const {
  Belief belief = cluster_.belief;
  belief.propagate(odometry_, parameters_.odometry);
  return belief;
}

PoseEstimate MultipathParticleFilter::estimate() const {
  PoseEstimate result;
  result.stamp = now_;
  if (particles_.empty()) return result;
  const Belief belief = current_belief();
  const double caution = square(parameters_.sigma_factor);
  result.valid = true;
  result.aligned = confirmed_ || settled_over_ > parameters_.confirm_distance;
  const double least_sigma =
      result.aligned ? parameters_.position_sigma_floor : parameters_.unconfirmed_sigma;
  const Eigen::Matrix2d floor = square(least_sigma) * Eigen::Matrix2d::Identity();
  result.way_to_alignment =
      std::max(0.0, parameters_.confirm_distance - std::max(confirmed_over_, settled_over_));
  result.pose = belief.pose();
  result.covariance = caution * belief.covariance.topLeftCorner<3, 3>();
  result.covariance.topLeftCorner<2, 2>() += floor;
  result.dominance = cluster_.mass;
  const double wrong = steady_bias_.probability(parameters_.steady_bias);
  const Eigen::Vector2d bias = belief.mean.tail<2>();
  result.position_covariance_overall = caution * cluster_.overall_position_covariance + floor +
                                       wrong * (1.0 - wrong) * bias * bias.transpose();
  result.shadow_probability = cluster_.shadow;
  result.canyon_probability = class_probability_[kCanyon];
  result.wheel_fault_probability = class_probability_[kWheelFault];
  result.bias = belief.mean.tail<2>();
  result.bias_covariance = belief.covariance.bottomRightCorner<2, 2>();
  result.effective_sample_size = effective_sample_size_;
  return result;
}

std::vector<Hypothesis> MultipathParticleFilter::hypotheses() const {
  std::vector<Hypothesis> all;
  all.reserve(particles_.size());
  for (const BeliefParticle& particle : particles_) {
    Belief belief = particle.belief;
    belief.propagate(odometry_, parameters_.odometry);
    const Mode mode = particle.receiver == kCanyon ? Mode::kCanyon
                      : particle.mode.shadow       ? Mode::kShadow
                                                   : Mode::kOpen;
    all.push_back({belief.pose(), particle.weight, mode});
  }
  return all;
}

}  // namespace multipath_localization
