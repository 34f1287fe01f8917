#include "multipath_localization/estimators/fix_modes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "multipath_localization/core/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kMaxSlip = 3.0;             ///< distance that slip can have faked or hidden at most [m]
constexpr double kMaxSlipInterval = 2.0;     ///< never explain an outage by slip [s]
constexpr double kStandingRateFactor = 0.1;  ///< shadows come and go slower for a robot that stands
constexpr double kHeadingGateSquared = 9.0;  ///< no heading restart within 3 sigma of the heading held

/// Probability of an event of this rate within dt.
double chance(double rate, double dt) { return 1.0 - std::exp(-rate * dt); }

}  // namespace

FixModes::FixModes(const ReceiverClass& receiver, const FixInterval& interval)
    : receiver_(receiver), interval_(interval) {}

FixCandidate FixModes::base(const FixMode& from, const FixMode& to) const {
  const ReceiverClass& c = receiver_;
  FixCandidate candidate;
  candidate.mode = to;
  candidate.fix_variance = c.noise_variance(to.noisy);
  candidate.keeps_bias = from.shadow == to.shadow;
  if (!candidate.keeps_bias) {
    candidate.bias_variance = square(to.shadow ? c.shadow_entry_sigma : c.open_bias_sigma);
  } else if (to.shadow && !to.noisy) {
    candidate.bias_variance = square(c.shadow_bias_walk) * interval_.duration;
  } else {
    const double sigma = to.shadow ? c.shadow_bias_sigma : c.open_bias_sigma;
    const double time = to.shadow ? c.shadow_bias_time : c.open_bias_time;
    candidate.bias_factor = std::exp(-interval_.duration / time);
    candidate.bias_variance = square(sigma) * (1.0 - square(candidate.bias_factor));
  }
  return candidate;
}

double FixModes::heading_restart_probability(const Belief& belief) const {
  if (!interval_.aligned_heading) return 0.0;
  const AlignedHeading& aligned = *interval_.aligned_heading;
  const double difference = angle_difference(aligned.yaw, belief.mean(kYaw));
  const double variance = aligned.variance + belief.covariance(kYaw, kYaw);
  if (square(difference) < kHeadingGateSquared * variance) return 0.0;
  return chance(interval_.heading_restart_rate, interval_.duration);
}

FixCandidates FixModes::always_shadow(const FixMode& mode) const {
  FixCandidates one{};
  one[0] = base(mode, {true, true, false});
  one[0].keeps_bias = true;
  one[0].prior = 1.0;
  return one;
}

FixModes::Transition FixModes::transition(const FixMode& mode) const {
  const ReceiverClass& c = receiver_;
  const double dt = interval_.duration;
  const double shadow_dt = interval_.moving ? dt : kStandingRateFactor * dt;
  Transition to;
  if (mode.shadow) {
    to.shadow = 1.0 - chance(c.shadow_exit_rate, shadow_dt);
  } else {
    to.shadow = chance(c.shadow_entry_rate, shadow_dt);
  }
  if (mode.noisy) {
    to.noisy_if_open = 1.0 - chance(c.open_noisy_exit_rate, dt);
    to.noisy_if_shadow = 1.0 - chance(c.shadow_noisy_exit_rate, dt);
  } else {
    to.noisy_if_open = chance(c.open_noisy_entry_rate, dt);
    to.noisy_if_shadow = chance(c.shadow_noisy_entry_rate, dt);
  }
  return to;
}

double FixModes::slip_probability(const FixMode& mode) const {
  const double dt = interval_.duration;
  if (dt >= kMaxSlipInterval || receiver_.slip_rate <= 0.0) return 0.0;
  return mode.slipping ? std::exp(-dt * interval_.slip_end_rate) : chance(receiver_.slip_rate, dt);
}

FixCandidates FixModes::candidates(const FixMode& mode, const Belief& belief) const {
  const ReceiverClass& c = receiver_;
  if (c.always_shadow) return always_shadow(mode);
  const Transition to = transition(mode);
  const double slip = slip_probability(mode);
  const double position =
      interval_.moving ? chance(interval_.position_restart_rate, interval_.duration) : 0.0;
  const double heading = interval_.moving ? heading_restart_probability(belief) : 0.0;
  const double usual = std::max(1e-9, 1.0 - c.outlier_probability - position - heading - slip);

  FixCandidates all{};
  all[0] = base(mode, {false, false, false});
  all[0].prior = usual * (1.0 - to.shadow) * (1.0 - to.noisy_if_open);
  all[1] = base(mode, {false, true, false});
  all[1].prior = usual * (1.0 - to.shadow) * to.noisy_if_open;
  all[2] = base(mode, {true, false, false});
  all[2].prior = usual * to.shadow * (1.0 - to.noisy_if_shadow);
  all[3] = base(mode, {true, true, false});
  all[3].prior = usual * to.shadow * to.noisy_if_shadow;
  all[4] = base(mode, {mode.shadow, false, true});
  all[4].prior = slip;
  all[5] = base(mode, mode);
  all[5].mode.slipping = false;
  all[5].outlier = true;
  all[5].fix_variance = square(c.outlier_sigma);
  all[5].prior = c.outlier_probability;
  all[6] = all[7] = base({true, false, false}, {false, false, false});
  all[6].restart = Restart::kPosition;
  all[6].prior = position;
  all[7].restart = Restart::kHeading;
  all[7].prior = heading;
  return all;
}

Eigen::Matrix2d FixModes::extra_position_covariance(const FixCandidate& candidate, double yaw) const {
  if (candidate.restart != Restart::kNone)
    return square(interval_.restart_sigma) * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d unseen =
      square(receiver_.unseen_motion) * interval_.unseen_variance * Eigen::Matrix2d::Identity();
  if (!candidate.mode.slipping) return unseen;
  const Eigen::Vector2d along(std::cos(yaw), std::sin(yaw));
  return unseen + square(std::min(interval_.slip_distance, kMaxSlip)) * along * along.transpose();
}

double FixModes::log_likelihood(const FixCandidate& candidate, const FixPrediction& prediction, double yaw,
                                const Eigen::Vector2d& fix) const {
  Eigen::Matrix2d S = prediction.antenna_covariance + extra_position_covariance(candidate, yaw);
  Eigen::Vector2d innovation = fix - prediction.antenna;
  if (candidate.keeps_bias) {
    const double a = candidate.bias_factor;
    S += a * prediction.cross_covariance + a * a * prediction.bias_covariance;
    innovation -= a * prediction.bias;
  }
  S.diagonal().array() += candidate.bias_variance + candidate.fix_variance;
  return -0.5 * (innovation.dot(S.inverse() * innovation) + std::log(S.determinant())) - std::log(2.0 * kPi);
}

void FixModes::apply(const FixCandidate& candidate, const Eigen::Vector2d& fix,
                     const Eigen::Vector2d& antenna_in_base, const OdometryNoise& odometry,
                     Belief& belief) const {
  if (candidate.keeps_bias) {
    belief.decay_bias(candidate.bias_factor, candidate.bias_variance);
  } else {
    belief.renew_bias(candidate.bias_variance);
  }
  belief.covariance.topLeftCorner<2, 2>() += extra_position_covariance(candidate, belief.mean(kYaw));
  if (candidate.restart == Restart::kHeading) {
    belief.renew(kYaw, wrap_angle(interval_.aligned_heading->yaw), interval_.aligned_heading->variance);
    belief.renew(kScale, 0.0, square(odometry.scale_sigma));
    belief.renew(kGyroBias, 0.0, square(odometry.gyro_bias_sigma));
  }
  if (!candidate.outlier) belief.correct(fix, antenna_in_base, candidate.fix_variance);
  // Of the turning on to the next fix, which is as far away as the last: this one's likelihood knew none of
  // it.
  belief.covariance(kYaw, kYaw) += square(receiver_.yaw_walk) * interval_.duration;
}

}  // namespace multipath_localization
