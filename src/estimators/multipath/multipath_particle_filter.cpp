#include "estimators/multipath/multipath_particle_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "estimators/multipath/alignment_monitor.hpp"
#include "estimators/multipath/fix_block.hpp"
#include "estimators/multipath/hypothesis_cloud.hpp"
#include "estimators/multipath/rival.hpp"
#include "estimators/multipath/velocity_block.hpp"
#include "estimators/multipath/wheel_watch.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kLongestSum = 1.0;  ///< odometry is linearised over at most this long [s]
/// Fixes within this time are one, just below a receiver's second [s].
constexpr double kBlock = 0.9;
/// Without a fix for longer, wheels are judged without one; the slowest receivers in use send one in two
/// seconds [s].
constexpr double kOutage = 3.0;
constexpr double kReacquisition = 5.0;  ///< a receiver that begins anew settles within this time [s]
/// A receiver that fixes its ambiguities declares less than this from one fix to the next,
constexpr double kFixed = 0.1;  // [m]
constexpr double kFloat = 0.3;  ///< and more than that before [m]
/// How soon odometry forgets a position that corrected fixes gave [s].
constexpr double kCorrectedMemory = 60.0;
constexpr double kBelieved = 0.9;       ///< probability of velocities that tell a heading at once
constexpr double kShortestTime = 1e-3;  ///< between two fixes of one stamp [s]
constexpr std::uint64_t kRivalSeed = 0x9E3779B97F4A7C15U;  ///< its draws are not those of the cloud
constexpr double kLeastSigma = 1e-3;  ///< no receiver is better than that, whatever it declares [m]

multipath::CloudSettings cloud_settings(const MultipathParticleFilterParameters& parameters) {
  return {parameters.particles, parameters.odometry, parameters.turn_scale_sigma};
}

multipath::OdometryErrors errors_of(const multipath::State& mean) {
  return {mean(multipath::kScale), mean(multipath::kGyroBias), mean(multipath::kTurnScale),
          mean(multipath::kCurvature), mean(multipath::kImuBias)};
}

/// As declared, but positive definite.
GnssFix with_proper_covariance(GnssFix fix) {
  fix.covariance += square(kLeastSigma) * Eigen::Matrix2d::Identity();
  return fix;
}

}  // namespace

/// Pose of the base in map and covariance of x, y, yaw [m, rad].
struct Prediction {
  Pose2 pose;
  Eigen::Matrix3d covariance;
};

/// All that is known since the start.
struct MultipathParticleFilter::State {
  State(const MultipathParticleFilterParameters& parameters, std::uint64_t seed, bool confirmed)
      : cloud(cloud_settings(parameters), seed),
        rival(cloud_settings(parameters), seed + kRivalSeed),
        alignment(confirmed),
        odometry(parameters.odometry),
        wheels(parameters.odometry_jump, parameters.odometry) {}

  /// The pose of now in that of when the hypotheses were last moved.
  [[nodiscard]] Pose2 moved() const {
    return {odometry.displacement().x(), odometry.displacement().y(), odometry.turn()};
  }
  Innovation take(const GnssVelocity& velocity) {
    Innovation result = refused(velocities.add(velocity).value_or(Reason::kAccepted));
    if (velocities_due()) weigh_velocities();
    const bool contradicted = velocities_weighed && cloud.mixture().velocity < 0.5;
    if (result.accepted() && contradicted) result.reason = Reason::kGated;
    return result;
  }
  /// Takes the fixes that wait along to where the base is now.
  void carry_block() {
    block.move(inverse(block_moved) * moved());
    block_moved = moved();
  }
  /// Moves the hypotheses on by the odometry so far.
  void flush() {
    carry_block();
    cloud.propagate(odometry);
    rival.propagate(odometry);
    restart_odometry();
  }
  /// Where the mean of the hypotheses has got to, by how certain odometry.
  [[nodiscard]] Prediction predicted() const;
  /// In an outage the odometry alone can show that the wheels fail.
  void doubt_wheels() {
    if (now - last_weighed <= kOutage) return;
    const double begins = wheels.take_suspicion();
    if (begins <= 0.0 && cloud.mixture().wheel_fault <= 0.0) return;
    const double duration = odometry.duration();
    cloud.let_wheels_fail(begins, wheels.usual_speed(), duration, odometry.moving_time() < 0.5 * duration,
                          odometry.turns_by_gyro());
  }
  void restart_odometry() {
    odometry.restart(errors_of(cloud.mixture().mean));
    block_moved = Pose2{};
  }
  void weigh(const MultipathParticleFilterParameters& parameters);
  void weigh_velocities();
  /// After that way since the last fixes were weighed [m].
  void judge_alignment(double way) {
    const multipath::Mixture& mixture = cloud.mixture();
    alignment.update(way - counted_way, mixture.covariance(2, 2), mixture.velocity > kBelieved);
    counted_way = way;
  }
  /// Whether the velocities that wait are to be weighed now: at once while they tell the heading.
  [[nodiscard]] bool velocities_due() const {
    return !cloud.empty() && !velocities.empty() && (velocities.age() >= kBlock || !alignment.aligned());
  }
  /// A position is known as well as corrections make it, and for a while after they are gone.
  void note_corrections(const GnssFix& fix, double duration, double uncorrected_sigma) {
    const double variance = fix.status == FixStatus::kSingle ? square(uncorrected_sigma) : 0.0;
    common_variance = std::min(variance, common_variance + duration / kCorrectedMemory * variance);
  }

  multipath::HypothesisCloud cloud;
  multipath::Rival rival;
  multipath::AlignmentMonitor alignment;
  multipath::OdometrySum odometry;  ///< since the hypotheses were last moved
  multipath::FixBlock block;
  multipath::VelocityBlock velocities;
  bool velocities_weighed = false;  ///< since the start
  Pose2 block_moved;                ///< the part of `moved` that the block has been taken along
  multipath::WheelWatch wheels;
  FixCheck fix_check;
  double now = 0.0;
  double last_weighed = 0.0;
  double last_declared = 0.0;           ///< [m]
  double reacquired = -kReacquisition;  ///< when fixes came back after an outage [s]
  double common_variance = 0.0;         ///< of what all fixes are off by alike, an axis [m^2]
  double fixes_in_block = 1.0;          ///< the last one: so much whiter is its mean than each
  double counted_way = 0.0;             ///< of the wheels', by the alignment [m]
  double speed = 0.0;                   ///< of the last increment, over ground [m/s]
};

void MultipathParticleFilter::State::weigh(const MultipathParticleFilterParameters& parameters) {
  multipath::Sighting sighting;
  sighting.turns_by_gyro = odometry.turns_by_gyro();
  if (!velocities.empty()) weigh_velocities();
  flush();
  fixes_in_block = static_cast<double>(block.size());
  sighting.fix = block.take(cloud.mixture().mean(multipath::kYaw));
  sighting.duration = std::max(kShortestTime, now - last_weighed);
  const double declared = mean_sigma(sighting.fix.covariance);
  sighting.after_gap = sighting.duration > kOutage;
  sighting.refixed = declared < kFixed && last_declared > kFloat;
  last_declared = declared;
  if (sighting.after_gap || sighting.refixed) reacquired = now;
  sighting.reacquired = now - reacquired < kReacquisition;
  sighting.standing = wheels.standing(sighting.duration);
  const double way = wheels.way();
  wheels.look_back(sighting.duration, cloud.mixture().wheel_fault);
  sighting.usual_speed = wheels.usual_speed();
  sighting.fault_probability = wheels.fault_probability(sighting.duration);
  sighting.largest_bias = parameters.largest_bias;
  sighting.shadow_entry_rate = 1.0 / parameters.time_between_shadows;
  rival.weigh(sighting, cloud.weigh(sighting), cloud);
  note_corrections(sighting.fix, sighting.duration, parameters.uncorrected_sigma);
  last_weighed = now;
  restart_odometry();
  judge_alignment(way);
  counted_way = 0.0;
}

void MultipathParticleFilter::State::weigh_velocities() {
  auto sighting = velocities.take();
  if (!sighting) return;
  sighting->usual_speed = wheels.usual_speed();
  doubt_wheels();
  flush();
  cloud.weigh(*sighting);
  velocities_weighed = true;
  restart_odometry();
  judge_alignment(wheels.way());
}

Prediction MultipathParticleFilter::State::predicted() const {
  const multipath::Mixture& mixture = cloud.mixture();
  const Pose2 then = multipath::pose_of(mixture.mean);
  const Eigen::Vector2d way = rotation(then.yaw) * odometry.displacement();
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F.topRightCorner<2, 1>() << -way.y(), way.x();
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned.topLeftCorner<2, 2>() = rotation(then.yaw);
  const Eigen::Matrix3d noise = odometry.noise(mixture.odometry_noise);
  return {then * moved(), F * mixture.covariance * F.transpose() + turned * noise * turned.transpose()};
}

MultipathParticleFilter::MultipathParticleFilter(const MultipathParticleFilterParameters& parameters,
                                                 std::uint64_t seed)
    : parameters_(parameters), seed_(seed), state_(std::make_unique<State>(parameters, seed, false)) {}

MultipathParticleFilter::~MultipathParticleFilter() = default;

void MultipathParticleFilter::start(const std::optional<PosePrior>& prior) {
  const bool usable_prior = prior && usable(*prior);
  state_ = std::make_unique<State>(parameters_, seed_, usable_prior && prior->confirmed);
  if (!usable_prior) return;
  state_->cloud.start(*prior);
  state_->now = state_->last_weighed = prior->stamp;
  state_->judge_alignment(0.0);
}

void MultipathParticleFilter::tune(ParameterVisitor& field) {
  parameters_.tunable(field);
  state_->cloud.set(cloud_settings(parameters_));
  state_->odometry.set_noise(parameters_.odometry);
}

void MultipathParticleFilter::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  state_->now = u.stamp;
  state_->speed = ground_speed(u);
  state_->velocities.move(state_->odometry.without_turn_errors(u));
  if (state_->cloud.empty()) return;
  state_->odometry.add(u);
  state_->wheels.add(u);
  if (state_->odometry.duration() <= kLongestSum) return;
  state_->doubt_wheels();
  state_->flush();
}

Innovation MultipathParticleFilter::update(const Measurement& z) {
  if (const auto* velocity = std::get_if<GnssVelocity>(&z)) return state_->take(*velocity);
  const auto* declared = std::get_if<GnssFix>(&z);
  if (declared == nullptr) return refused(Reason::kUnused);
  if (const auto reason = state_->fix_check.defect(*declared)) return refused(*reason);
  const GnssFix fix = with_proper_covariance(*declared);
  Innovation result;
  result.reason = Reason::kAccepted;
  if (state_->cloud.empty()) {
    state_->cloud.start(fix);
    state_->velocities.start(fix.antenna_in_base);
    state_->note_corrections(fix, kCorrectedMemory, parameters_.uncorrected_sigma);
    state_->last_weighed = state_->now;
    state_->restart_odometry();
    if (state_->velocities_due()) state_->weigh_velocities();
    return result;
  }
  const multipath::Mixture& mixture = state_->cloud.mixture();
  const Prediction predicted = state_->predicted();
  result.innovation = fix.position - predicted.pose * fix.antenna_in_base - mixture.bias;
  result.covariance = predicted.covariance.topLeftCorner<2, 2>() +
                      state_->fixes_in_block * mixture.white_variance * Eigen::Matrix2d::Identity();
  result.nis = result.innovation.dot(result.covariance.inverse() * result.innovation);
  state_->carry_block();
  state_->block.add(fix);
  if (state_->now - state_->last_weighed >= kBlock) state_->weigh(parameters_);
  return result;
}

PoseEstimate MultipathParticleFilter::estimate() const {
  PoseEstimate result;
  result.stamp = state_->now;
  if (state_->cloud.empty()) return result;
  const multipath::Mixture& mixture = state_->cloud.mixture();
  const Prediction predicted = state_->predicted();
  result.valid = true;
  result.aligned = state_->alignment.aligned();
  result.way_to_alignment = state_->alignment.way_left();
  result.pose = predicted.pose;
  result.covariance = square(parameters_.sigma_factor) * predicted.covariance;
  const Eigen::Vector2d between_stamps =
      rotation(result.pose.yaw).col(0) * parameters_.stamp_sigma * state_->speed;
  // The slow error may be one that stays for the whole drive, which nobody sees.
  result.covariance.topLeftCorner<2, 2>() +=
      (square(parameters_.position_sigma_floor) + mixture.slow_variance + state_->common_variance) *
          Eigen::Matrix2d::Identity() +
      between_stamps * between_stamps.transpose();
  result.position_covariance_overall = result.covariance.topLeftCorner<2, 2>();
  result.dominance = mixture.agreement;
  result.shadow_probability = mixture.shadow;
  result.wheel_fault_probability = mixture.wheel_fault;
  result.bias = mixture.bias;
  result.bias_covariance = mixture.bias_covariance;
  result.effective_sample_size = mixture.effective_size;
  return result;
}

std::vector<Hypothesis> MultipathParticleFilter::hypotheses() const {
  const Pose2 step = state_->moved();
  std::vector<Hypothesis> all;
  all.reserve(state_->cloud.hypotheses().size());
  for (const multipath::Hypothesis& h : state_->cloud.hypotheses()) {
    all.push_back({h.pose() * step, std::exp(h.log_weight), h.in_shadow ? Mode::kShadow : Mode::kOpen});
  }
  return all;
}

}  // namespace multipath_localization
