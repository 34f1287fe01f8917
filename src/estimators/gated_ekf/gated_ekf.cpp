#include "estimators/gated_ekf/gated_ekf.hpp"

#include <cmath>

#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

using odometry_state::kSize;
using odometry_state::kYaw;

}  // namespace

void GatedEkfParameters::fields(ParameterVisitor& field) {
  field("gate", gate, {0.1, 1e6}, "1", "largest normalised innovation squared (2 dof) of a fix that is used");
  field("reopen_after", reopen_after, {0.1, 3600.0}, "s", "rejections on end for this long open the gate");
  field("reopen_yaw_sigma", reopen_yaw_sigma, {0.0, kPi}, "rad", "added to the heading's uncertainty then");
  alignment.fields(field);
  declared.fields(field);
  field.group("odometry", odometry, "how far the wheel odometry can be trusted");
}

GatedEkf::GatedEkf(const GatedEkfParameters& parameters, std::uint64_t)
    : parameters_(parameters), alignment_(parameters.alignment, parameters.odometry) {}

void GatedEkf::start(const std::optional<PosePrior>& prior) {
  fix_check_.forget();
  rejections_.end();
  tracked_.reset();
  alignment_ = ChordAlignment(parameters_.alignment, parameters_.odometry);
  alignment_.start(prior);
  now_ = alignment_.started() ? prior->stamp : 0.0;
  if (alignment_.aligned()) tracked_ = alignment_.state();
}

void GatedEkf::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  now_ = u.stamp;
  if (!tracked_) return alignment_.predict(u);
  if (standing(u)) return;
  const odometry_state::Step step = odometry_state::step(tracked_->mean, u, parameters_.odometry);
  kalman::predict<kSize>(*tracked_, step.mean, step.F, step.Q);
}

Innovation GatedEkf::update(const Measurement& z) {
  const auto* fix = std::get_if<GnssFix>(&z);
  if (fix == nullptr) return refused(Reason::kUnused);
  if (const auto reason = fix_check_.defect(*fix)) return refused(*reason);
  const Eigen::Matrix2d R = believed_covariance(fix->covariance, parameters_.declared);
  if (tracked_) return track(*fix, R);
  const Innovation result = alignment_.update(*fix, R);
  if (alignment_.aligned()) tracked_ = alignment_.state();
  return result;
}

Innovation GatedEkf::track(const GnssFix& fix, const Eigen::Matrix2d& R) {
  ChordAlignment::State& belief = *tracked_;
  const auto H = odometry_state::antenna_jacobian(belief.mean, fix.antenna_in_base);
  const Eigen::Vector2d y = fix.position - odometry_state::pose(belief.mean) * fix.antenna_in_base;
  const auto compared = kalman::compare<kSize, 2>(belief, y, H, R);
  Innovation result{Reason::kGated, compared.innovation, compared.covariance, compared.nis};
  if (compared.nis > parameters_.gate) {
    if (rejections_.add(now_) < parameters_.reopen_after) return result;
    // With |y|^2 more in position the innovation is within one sigma: no distance keeps the gate shut.
    belief.covariance.topLeftCorner<2, 2>() += y.squaredNorm() * Eigen::Matrix2d::Identity();
    belief.covariance(kYaw, kYaw) += square(parameters_.reopen_yaw_sigma);
  }
  rejections_.end();
  kalman::correct<kSize, 2>(belief, y, H, R);
  result.reason = Reason::kAccepted;
  return result;
}

const ChordAlignment::State& GatedEkf::belief() const { return tracked_ ? *tracked_ : alignment_.state(); }

PoseEstimate GatedEkf::estimate() const {
  PoseEstimate result;
  result.stamp = now_;
  if (!alignment_.started()) return result;
  result.valid = true;
  result.aligned =
      tracked_ && tracked_->covariance(kYaw, kYaw) < square(parameters_.alignment.alignment_yaw_sigma);
  if (!tracked_) result.way_to_alignment = alignment_.missing();
  result.pose = odometry_state::pose(belief().mean);
  result.covariance = belief().covariance.topLeftCorner<3, 3>();
  result.position_covariance_overall = belief().covariance.topLeftCorner<2, 2>();
  return result;
}

std::vector<Hypothesis> GatedEkf::hypotheses() const {
  if (!alignment_.started()) return {};
  return {{odometry_state::pose(belief().mean), 1.0, Mode::kOpen}};
}

}  // namespace multipath_localization
