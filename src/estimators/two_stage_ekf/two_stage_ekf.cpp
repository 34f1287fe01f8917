#include "estimators/two_stage_ekf/two_stage_ekf.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

using odometry_state::kYaw;

constexpr double kWidestBiasSigmas = 3.0;
constexpr double kLeastShare = 1e-3;  ///< of a fix that repeats one of the same instant

}  // namespace

void TwoStageEkfParameters::fields(ParameterVisitor& field) {
  field("compensate", compensate,
        "estimate the bias of faulty fixes; false: the standard complementary filter, every fix as it is");
  field("bias_estimated", bias_estimated, {"in_fault", "always"},
        "in_fault: from the detection of a fault until its end; always: from the start on, Friedland's "
        "estimator");
  field("fault_threshold", fault_threshold, {0.1, 1e6}, "1",
        "normalised innovation squared beyond which fixes are faulty; 7.81 as printed, the 95 % quantile of "
        "3 dof; that of the 2 dof of a fix is 5.99");
  field("bias_sigma", bias_sigma, {1e-3, 1e4}, "m",
        "1 sigma of the bias when its estimation begins; not printed, and all that tells bias from position");
  field("bias_walk", bias_walk, {0.0, 100.0}, "m/sqrt(m)",
        "random walk of the bias, per root of a metre driven; 0 as printed, Eq. (9)");
  field("bias_bounded", bias_bounded,
        "draw the walking bias back to zero, so that its own variance stays that of bias_sigma");
  field("recovery_odds", recovery_odds, {1.0, 1e12}, "1",
        "a fault ends when the fixes from some moment on are this many times as likely without bias");
  field("reopen_after", reopen_after, {0.1, 3600.0}, "s",
        "a bias of more than three bias_sigma for this long may as well be an error of the pose");
  field("reopen_yaw_sigma", reopen_yaw_sigma, {0.0, kPi}, "rad", "added to the heading's uncertainty then");
  field("fix_correlation_time", fix_correlation_time, {0.0, 1000.0}, "s",
        "fixes within this time count as one, for their errors are much the same; 0 as printed");
  field("linearised_at", linearised_at, {"corrected", "bias_free"},
        "where motion and lever arm are linearised: the corrected estimate, or the bias-free one as printed");
  alignment.fields(field);
  declared.fields(field);
  field.group("odometry", odometry, "how far the wheel odometry can be trusted");
}

TwoStageEkf::TwoStageEkf(const TwoStageEkfParameters& parameters, std::uint64_t)
    : parameters_(parameters), alignment_(parameters.alignment, parameters.odometry) {}

void TwoStageEkf::start(const std::optional<PosePrior>& prior) {
  fix_check_.forget();
  tracked_.reset();
  faulty_ = false;
  standing_ = true;
  rival_.reset();
  last_fix_.reset();
  implausible_since_.reset();
  alignment_.start(prior);
  now_ = alignment_.started() ? prior->stamp : 0.0;
  if (alignment_.aligned()) begin_tracking();
}

void TwoStageEkf::begin_tracking() {
  tracked_ = Belief{alignment_.state()};
  if (parameters_.compensate && parameters_.bias_estimated == BiasEstimated::kAlways)
    begin_fault(parameters_.bias_sigma);
}

void TwoStageEkf::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  if (!tracked_) return alignment_.predict(u);
  standing_ = standing(u);
  if (standing_) return;
  const odometry_state::Vector offset = linearisation_offset();
  const auto step = odometry_state::step(tracked_->bias_free.mean + offset, u, parameters_.odometry);
  two_stage::predict<kStates, 2>(*tracked_, step.mean - step.F * offset, step.F,
                                 Eigen::Matrix<double, kStates, 2>::Zero(), step.Q);
  if (faulty_ && parameters_.bias_walk > 0.0) vary_bias(ground_speed(u) * u.duration);
  if (rival_) rival_->predict(u, parameters_.odometry);
}

void TwoStageEkf::vary_bias(double distance) {
  const double walked = square(parameters_.bias_walk) * distance;
  const double variance = square(bias_sigma_);
  const double kept = parameters_.bias_bounded ? std::exp(-0.5 * walked / variance) : 1.0;
  const double added = parameters_.bias_bounded ? -variance * std::expm1(-walked / variance) : walked;
  two_stage::vary_bias<kStates, 2>(*tracked_, kept * Eigen::Matrix2d::Identity(),
                                   added * Eigen::Matrix2d::Identity());
}

Innovation TwoStageEkf::update(const Measurement& z) {
  const auto* fix = std::get_if<GnssFix>(&z);
  if (fix == nullptr) return refused(Reason::kUnused);
  if (const auto reason = fix_check_.defect(*fix)) return refused(*reason);
  const Eigen::Matrix2d R = believed_covariance(fix->covariance, parameters_.declared);
  const double share = share_of_fix();
  last_fix_ = now_;
  if (tracked_) return track(*fix, R, share);
  const Innovation result = alignment_.update(*fix, R);
  if (!alignment_.aligned()) return result;
  begin_tracking();
  // Aligned by the fixes, the position is as far off as they are.
  if (faulty_) tracked_->sensitivity.topRows<2>() = -Eigen::Matrix2d::Identity();
  return result;
}

double TwoStageEkf::share_of_fix() const {
  if (!last_fix_ || now_ - *last_fix_ >= parameters_.fix_correlation_time) return 1.0;
  return std::max(kLeastShare, (now_ - *last_fix_) / parameters_.fix_correlation_time);
}

odometry_state::Vector TwoStageEkf::linearisation_offset() const {
  if (parameters_.linearised_at == LinearisedAt::kBiasFree) return odometry_state::Vector::Zero();
  return tracked_->sensitivity * tracked_->bias.mean;
}

TwoStageEkf::Observation TwoStageEkf::observe(const GnssFix& fix) const {
  const odometry_state::Vector offset = linearisation_offset();
  const odometry_state::Vector x = tracked_->bias_free.mean + offset;
  Observation result;
  result.H = odometry_state::antenna_jacobian(x, fix.antenna_in_base);
  result.innovation = fix.position - odometry_state::pose(x) * fix.antenna_in_base + result.H * offset;
  return result;
}

Innovation TwoStageEkf::track(const GnssFix& fix, const Eigen::Matrix2d& R, double share) {
  const Eigen::Matrix2d C = Eigen::Matrix2d::Identity();
  Observation seen = observe(fix);
  const auto expected = two_stage::compare<kStates, 2, 2>(*tracked_, seen.innovation, seen.H, C, R);
  const bool in_fault_only = parameters_.compensate && parameters_.bias_estimated == BiasEstimated::kInFault;
  double log_likelihood = expected.log_likelihood;
  if (in_fault_only && expected.nis > parameters_.fault_threshold) {
    begin_fault(std::max(parameters_.bias_sigma, expected.innovation.norm()));
    seen = observe(fix);
    const auto anew = two_stage::compare<kStates, 2, 2>(*tracked_, seen.innovation, seen.H, C, R);
    log_likelihood = std::max(log_likelihood, anew.log_likelihood);
  }
  two_stage::correct<kStates, 2, 2>(*tracked_, seen.innovation, seen.H, C, R / share);
  if (in_fault_only && faulty_ && !standing_) watch_for_the_end(fix, R, share, log_likelihood);
  if (in_fault_only && reopens()) reopen();
  return {Reason::kAccepted, expected.innovation, expected.covariance, expected.nis};
}

void TwoStageEkf::begin_fault(double bias_sigma) {
  tracked_ = Belief{two_stage::corrected(*tracked_), tracked_->bias};
  tracked_->bias.covariance = square(bias_sigma) * Eigen::Matrix2d::Identity();
  faulty_ = true;
  bias_sigma_ = bias_sigma;
}

void TwoStageEkf::watch_for_the_end(const GnssFix& fix, const Eigen::Matrix2d& R, double share,
                                    double log_likelihood) {
  if (rival_) rival_->weigh(fix, R, share, log_likelihood);
  const UnbiasedRival from_now(state(), fix, R, bias_sigma_);
  if (!rival_ || rival_->log_odds() < from_now.log_odds()) rival_ = from_now;
  if (rival_->log_odds() < std::log(parameters_.recovery_odds)) return;
  tracked_ = Belief{rival_->state()};
  faulty_ = false;
  rival_.reset();
}

bool TwoStageEkf::reopens() {
  const bool plausible = tracked_->bias.mean.norm() <= kWidestBiasSigmas * parameters_.bias_sigma;
  if (plausible) implausible_since_.reset();
  if (!plausible && !implausible_since_) implausible_since_ = now_;
  return implausible_since_ && now_ - *implausible_since_ >= parameters_.reopen_after;
}

void TwoStageEkf::reopen() {
  const double offset = tracked_->bias.mean.norm();
  tracked_ = Belief{state()};
  Eigen::Ref<odometry_state::Matrix> P = tracked_->bias_free.covariance;
  P.topLeftCorner<2, 2>() += square(offset) * Eigen::Matrix2d::Identity();
  P(kYaw, kYaw) += square(parameters_.reopen_yaw_sigma);
  begin_fault(offset);
  implausible_since_.reset();
}

TwoStageEkf::State TwoStageEkf::state() const {
  return tracked_ ? two_stage::corrected(*tracked_) : alignment_.state();
}

PoseEstimate TwoStageEkf::estimate() const {
  PoseEstimate result;
  result.stamp = now_;
  if (!alignment_.started()) return result;
  const State x = state();
  result.valid = true;
  result.aligned = tracked_ && x.covariance(kYaw, kYaw) < square(parameters_.alignment.alignment_yaw_sigma);
  if (!tracked_) result.way_to_alignment = alignment_.missing();
  result.pose = odometry_state::pose(x.mean);
  result.covariance = x.covariance.topLeftCorner<3, 3>();
  result.position_covariance_overall = x.covariance.topLeftCorner<2, 2>();
  if (!faulty_) return result;
  result.shadow_probability = 1.0;
  result.bias = tracked_->bias.mean;
  result.bias_covariance = tracked_->bias.covariance;
  return result;
}

std::vector<Hypothesis> TwoStageEkf::hypotheses() const {
  if (!alignment_.started()) return {};
  return {{odometry_state::pose(state().mean), 1.0, faulty_ ? Mode::kShadow : Mode::kOpen}};
}

}  // namespace multipath_localization
