#include "estimators/fallback/fallback_estimator.hpp"

#include <algorithm>
#include <utility>

#include "multipath_localization/core/epoch_check.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

/// The estimate as a prior at the start of the increment that led to it. What all hypotheses are wider than
/// the dominant cluster is added in every direction, which keeps the covariance one.
PosePrior prior_before(const OdometryIncrement& u, const PoseEstimate& estimate, double sigma) {
  PosePrior prior;
  prior.stamp = u.stamp - u.duration;
  prior.pose = estimate.pose * inverse(displacement(u));
  prior.confirmed = true;
  const Eigen::Vector2d back = prior.pose.position() - estimate.pose.position();
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  by_pose.block<2, 1>(0, 2) << -back.y(), back.x();
  prior.covariance = by_pose * estimate.covariance * by_pose.transpose();
  const double wider =
      estimate.position_covariance_overall.trace() - estimate.covariance.topLeftCorner<2, 2>().trace();
  prior.covariance.diagonal().head<2>().array() += square(sigma) + 0.5 * std::max(0.0, wider);
  return prior;
}

bool better(const PoseEstimate& one, const PoseEstimate& other) {
  if (!one.valid || !one.aligned) return false;
  return !other.valid || !other.aligned ||
         one.position_covariance_overall.trace() < other.position_covariance_overall.trace();
}

}  // namespace

void FallbackParameters::fields(ParameterVisitor& field) {
  field("enabled", enabled, "go on by fixes when pseudoranges stop; otherwise fixes are unused");
  field("after", after, {0.1, 600.0}, "s", "without a usable epoch for this long fixes are used");
  field("handover_sigma", handover_sigma, {0.0, 100.0}, "m",
        "added to the position that is handed over, from epochs to fixes and back");
  field.group("fixes", fixes, "the multipath_particle_filter that uses them");
}

FallbackEstimator::FallbackEstimator(std::unique_ptr<Estimator> of_epochs,
                                     std::unique_ptr<Estimator> of_fixes,
                                     const FallbackParameters& parameters)
    : of_epochs_(std::move(of_epochs)), of_fixes_(std::move(of_fixes)), parameters_(parameters) {}

void FallbackEstimator::start(const std::optional<PosePrior>& prior) {
  of_epochs_->start(prior);
  of_fixes_->start(std::nullopt);
  last_.reset();
  last_epoch_ = 0.0;
  fallen_back_ = fixes_speak_ = false;
}

void FallbackEstimator::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  if (!last_) last_epoch_ = u.stamp - u.duration;
  last_ = u;
  of_epochs_->predict(u);
  if (fallen_back_) of_fixes_->predict(u);
}

Innovation FallbackEstimator::update(const Measurement& z) {
  if (const auto* epoch = std::get_if<PseudorangeEpoch>(&z)) return use(*epoch);
  if (const auto* fix = std::get_if<GnssFix>(&z)) return use(*fix);
  return refused(Reason::kUnused);
}

Innovation FallbackEstimator::use(const GnssFix& fix) {
  if (!last_ || (!fallen_back_ && last_->stamp - last_epoch_ <= parameters_.after)) {
    return refused(Reason::kNotNeeded);
  }
  if (!fallen_back_) hand_over(of_epochs_->estimate(), *of_fixes_);
  const Innovation result = of_fixes_->update(fix);
  fallen_back_ = fallen_back_ || result.accepted();
  fixes_speak_ = fallen_back_ && !better(of_epochs_->estimate(), of_fixes_->estimate());
  return result;
}

Innovation FallbackEstimator::use(const PseudorangeEpoch& epoch) {
  if (const auto reason = defect(epoch)) return refused(*reason);
  if (fixes_speak_ && of_fixes_->estimate().aligned) hand_over(of_fixes_->estimate(), *of_epochs_);
  const Innovation result = of_epochs_->update(epoch);
  if (!result.accepted()) return result;
  if (last_) last_epoch_ = last_->stamp;
  fallen_back_ = fixes_speak_ = false;
  return result;
}

void FallbackEstimator::hand_over(const PoseEstimate& estimate, Estimator& to) const {
  std::optional<PosePrior> prior;
  if (estimate.valid && estimate.aligned) prior = prior_before(*last_, estimate, parameters_.handover_sigma);
  to.start(prior);
  to.predict(*last_);
}

PoseEstimate FallbackEstimator::estimate() const {
  PoseEstimate result = speaker().estimate();
  if (last_) result.stamp = last_->stamp;
  return result;
}

std::vector<Hypothesis> FallbackEstimator::hypotheses() const { return speaker().hypotheses(); }

}  // namespace multipath_localization
