#include "estimators/multipath/multipath_particle_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "estimators/multipath/alignment_monitor.hpp"
#include "estimators/multipath/common_error.hpp"
#include "estimators/multipath/heading_block.hpp"
#include "estimators/multipath/heading_offset.hpp"
#include "estimators/multipath/hypothesis_cloud.hpp"
#include "estimators/multipath/prediction.hpp"
#include "estimators/multipath/receiver_watches.hpp"
#include "estimators/multipath/rival.hpp"
#include "estimators/multipath/velocity_block.hpp"
#include "estimators/multipath/wheel_watch.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kLongestSum = 1.0;  ///< odometry is linearised over at most this long [s]
constexpr double kBlock = 0.9;  ///< velocities or headings within it are one, below a receiver's second [s]
constexpr double kBelieved = 0.9;  ///< probability of velocities or headings that tell a heading at once
constexpr std::uint64_t kRivalSeed = 0x9E3779B97F4A7C15U;  ///< its draws are not those of the cloud
constexpr double kLeastSigma = 1e-3;  ///< no receiver is better than that, whatever it declares [m]

multipath::CloudSettings cloud_settings(const MultipathParticleFilterParameters& parameters) {
  return {parameters.particles, parameters.odometry, parameters.turn_scale_sigma};
}

/// As declared, but positive definite.
GnssFix with_proper_covariance(GnssFix fix) {
  fix.covariance += square(kLeastSigma) * Eigen::Matrix2d::Identity();
  return fix;
}

}  // namespace

/// All that is known since the start.
struct MultipathParticleFilter::State {
  State(const MultipathParticleFilterParameters& parameters, std::uint64_t seed, bool confirmed)
      : cloud(cloud_settings(parameters), seed),
        rival(cloud_settings(parameters), seed + kRivalSeed),
        alignment(confirmed),
        odometry(parameters.odometry),
        wheels(parameters.odometry_jump, parameters.odometry) {}

  /// The pose of now in that of when the hypotheses were last moved.
  [[nodiscard]] Pose2 moved() const { return multipath::moved(odometry); }
  Innovation take(const GnssVelocity& velocity) {
    const std::optional<Reason> defect = velocities.add(velocity);
    if (due(velocities)) weigh_velocities();
    return answer(defect, cloud.mixture().velocity);
  }
  Innovation take(const Heading& heading) {
    const std::optional<Reason> defect = headings.add(heading);
    if (due(headings)) weigh_headings();
    return answer(defect, cloud.mixture().heading);
  }
  /// To what another input than the fixes told, which is what it seems with that probability.
  static Innovation answer(std::optional<Reason> defect, std::optional<double> believed) {
    return refused(defect.value_or(believed.value_or(1.0) < 0.5 ? Reason::kGated : Reason::kAccepted));
  }
  /// Takes the fixes that wait along to where the base is now.
  void carry_blocks() {
    receivers.move(inverse(blocks_moved) * moved());
    blocks_moved = moved();
  }
  /// Spreads the hypotheses about a fix.
  void start(const GnssFix& fix, double uncorrected_sigma) {
    cloud.start(fix);
    velocities.start(fix.antenna_in_base);
    common.begin(fix.status, uncorrected_sigma);
    last_weighed = now;
    receivers.begin(now);
    restart_odometry();
    if (due(velocities)) weigh_velocities();
    if (due(headings)) weigh_headings();
  }
  /// Moves the hypotheses on by the odometry so far.
  void flush() {
    carry_blocks();
    cloud.propagate(odometry);
    rival.propagate(odometry);
    restart_odometry();
  }
  /// Where the mean of the hypotheses has got to, by how certain odometry.
  [[nodiscard]] auto predicted() const { return multipath::predicted(cloud.mixture(), odometry); }
  /// In an outage the odometry alone can show that the wheels fail.
  void doubt_wheels() {
    if (now - last_weighed <= multipath::kOutage) return;
    const double begins = wheels.take_suspicion();
    if (begins <= 0.0 && cloud.mixture().wheel_fault <= 0.0) return;
    const double duration = odometry.duration();
    cloud.let_wheels_fail(begins, wheels.usual_speed(), duration, odometry.moving_time() < 0.5 * duration,
                          odometry.turns_by_gyro());
  }
  void restart_odometry() {
    odometry.restart(cloud.mixture().odometry_errors());
    blocks_moved = Pose2{};
  }
  void weigh(multipath::ReceiverWatch& receiver, const MultipathParticleFilterParameters& parameters);
  /// What the wheels did since the last fix of any receiver.
  void judge_wheels(multipath::Sighting& sighting);
  void weigh_velocities();
  void weigh_headings();
  /// Weighs what another input than the fixes told.
  template <class Sighting>
  void weigh_beside(const Sighting& sighting) {
    doubt_wheels();
    flush();
    cloud.weigh(sighting);
    restart_odometry();
    judge_alignment(wheels.way());
  }
  /// After that way since the last fixes were weighed [m].
  void judge_alignment(double way) {
    const multipath::Mixture& mixture = cloud.mixture();
    const bool told = mixture.velocity > kBelieved || mixture.heading > kBelieved;
    alignment.update(way - counted_way, mixture.covariance(2, 2), told);
    counted_way = way;
  }
  /// Whether the velocities or headings that wait are to be weighed now: at once while they tell the heading.
  template <class Block>
  [[nodiscard]] bool due(const Block& block) const {
    return !cloud.empty() && !block.empty() && (block.age() >= kBlock || !alignment.aligned());
  }

  multipath::HypothesisCloud cloud;
  multipath::Rival rival;
  multipath::AlignmentMonitor alignment;
  multipath::OdometrySum odometry;  ///< since the hypotheses were last moved
  multipath::ReceiverWatches receivers;
  multipath::VelocityBlock velocities;
  multipath::HeadingBlock headings;
  multipath::HeadingOffset heading_offset;
  Pose2 blocks_moved;  ///< the part of `moved` that the fixes have been taken along
  multipath::WheelWatch wheels;
  bool stood = false;  ///< the wheels, before the fix that was weighed last
  double now = 0.0;
  double last_weighed = 0.0;  ///< a fix of any receiver
  multipath::CommonError common;
  double counted_way = 0.0;  ///< of the wheels', by the alignment [m]
  double speed = 0.0;        ///< of the last increment, over ground [m/s]
};

void MultipathParticleFilter::State::judge_wheels(multipath::Sighting& sighting) {
  sighting.usual_speed = wheels.usual_speed();
  sighting.standing = stood;
  if (now == last_weighed) return;  // another receiver's fix of this instant
  const double duration = sighting.unseen();
  sighting.standing = stood = wheels.standing(duration);
  wheels.look_back(duration, cloud.mixture().wheel_fault);
  sighting.usual_speed = wheels.usual_speed();
  sighting.fault_probability = wheels.fault_probability(duration);
}

void MultipathParticleFilter::State::weigh(multipath::ReceiverWatch& receiver,
                                           const MultipathParticleFilterParameters& parameters) {
  const bool turns_by_gyro = odometry.turns_by_gyro();
  if (!velocities.empty()) weigh_velocities();
  flush();
  multipath::Sighting sighting = receiver.take(now, cloud.mixture().mean(multipath::kYaw),
                                               mean_sigma(cloud.mixture().covariance.topLeftCorner<2, 2>()));
  sighting.turns_by_gyro = turns_by_gyro;
  sighting.between = sighting.duration - std::max(multipath::kShortestTime, now - last_weighed);
  sighting.after_gap = sighting.unseen() > multipath::kOutage;
  const double way = wheels.way();
  judge_wheels(sighting);
  sighting.largest_bias = parameters.largest_bias;
  sighting.shadow_entry_rate = 1.0 / parameters.time_between_shadows;
  rival.weigh(sighting, cloud.weigh(sighting), cloud);
  common.go_on(receivers.of(followed(cloud), now).status(), sighting.unseen(), parameters.uncorrected_sigma);
  last_weighed = now;
  restart_odometry();
  judge_alignment(way);
  counted_way = 0.0;
}

void MultipathParticleFilter::State::weigh_velocities() {
  auto sighting = velocities.take();
  if (!sighting) return;
  sighting->usual_speed = wheels.usual_speed();
  weigh_beside(*sighting);
}

void MultipathParticleFilter::State::weigh_headings() {
  multipath::HeadingSighting sighting = headings.take();
  sighting.from_start = velocities.from_start();
  weigh_beside(sighting);
  if (now - last_weighed > multipath::kOutage) return;  // the odometry alone tells no offset
  if (const auto offset = heading_offset.judge(sighting, cloud.mixture())) cloud.mount_heading(*offset);
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
  state_->headings.move(state_->odometry.without_turn_errors(u));
  if (state_->cloud.empty()) return;
  state_->odometry.add(u);
  state_->wheels.add(u);
  while (multipath::ReceiverWatch* const late = state_->receivers.overdue(u.stamp)) {
    state_->weigh(*late, parameters_);
  }
  if (state_->odometry.duration() <= kLongestSum) return;
  state_->doubt_wheels();
  state_->flush();
}

Innovation MultipathParticleFilter::update(const Measurement& z) {
  if (const auto* velocity = std::get_if<GnssVelocity>(&z)) return state_->take(*velocity);
  if (const auto* heading = std::get_if<Heading>(&z)) return state_->take(*heading);
  const auto* declared = std::get_if<GnssFix>(&z);
  if (declared == nullptr) return refused(Reason::kUnused);
  multipath::ReceiverWatch& receiver = state_->receivers.of(declared->receiver, state_->last_weighed);
  if (const auto reason = receiver.defect(*declared)) return refused(*reason);
  const GnssFix fix = with_proper_covariance(*declared);
  Innovation result = refused(Reason::kAccepted);
  if (state_->cloud.empty()) {
    state_->start(fix, parameters_.uncorrected_sigma);
    return result;
  }
  const multipath::FixErrors errors = state_->cloud.errors_of(fix.receiver);
  const multipath::Prediction predicted = state_->predicted();
  result.innovation = fix.position - predicted.pose * fix.antenna_in_base - errors.bias;
  result.covariance = predicted.covariance.topLeftCorner<2, 2>() +
                      receiver.fixes_in_block() * errors.white_variance * Eigen::Matrix2d::Identity();
  result.nis = result.innovation.dot(result.covariance.inverse() * result.innovation);
  state_->carry_blocks();
  receiver.add(fix, state_->now);
  if (receiver.due(state_->now)) state_->weigh(receiver, parameters_);
  return result;
}

PoseEstimate MultipathParticleFilter::estimate() const {
  PoseEstimate result;
  result.stamp = state_->now;
  if (state_->cloud.empty()) return result;
  const multipath::Mixture& mixture = state_->cloud.mixture();
  const multipath::Prediction predicted = state_->predicted();
  result.valid = true;
  result.aligned = state_->alignment.aligned();
  result.way_to_alignment = state_->alignment.way_left();
  result.pose = predicted.pose;
  result.covariance = square(parameters_.sigma_factor) * predicted.covariance;
  const Eigen::Vector2d between_stamps =
      rotation(result.pose.yaw).col(0) * parameters_.stamp_sigma * state_->speed;
  // The slow error may be one that stays for the whole drive, which nobody sees.
  const std::size_t receiver = followed(state_->cloud);
  result.covariance.topLeftCorner<2, 2>() +=
      (square(parameters_.position_sigma_floor) + state_->cloud.errors_of(receiver).slow_variance +
       state_->common.variance() + state_->receivers.doubt(receiver, state_->now)) *
          Eigen::Matrix2d::Identity() +
      between_stamps * between_stamps.transpose();
  result.position_covariance_overall = result.covariance.topLeftCorner<2, 2>();
  result.dominance = mixture.agreement;
  result.shadow_probability = mixture.least_shadow();
  result.wheel_fault_probability = mixture.wheel_fault;
  tell_receivers(state_->cloud, result);
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
