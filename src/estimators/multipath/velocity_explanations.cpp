#include "estimators/multipath/velocity_explanations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "estimators/multipath/log_normal.hpp"
#include "estimators/multipath/wheel_fault.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kOutlierShare = 0.1;    // of the time in which a reflection is the strongest signal
constexpr double kOutlierTime = 1.5;     // that it stays so [s]
constexpr double kLeastOutlier = 0.3;    // less is told from no noise [m/s]
constexpr double kLargestOutlier = 5.0;  // of a reflection that nears while the robot leaves [m/s]
constexpr double kLeastSigma = 0.02;     // no receiver is better than that, whatever it declares [m/s]
constexpr double kLeastSlow = 0.02;      // of it does not average out within seconds [m/s]
constexpr double kOfSpeed = 0.005;       // antenna that swings, base that leans and slides [1]
constexpr double kUnsureDelay = 0.03;    // between two steps of the delay: width / sqrt 12 [s]
constexpr double kWindow = 0.2;          // of odometry that a velocity is held against [s]
constexpr double kLongestSeen = 1.2;     // before its stamp, that a velocity tells of [s]
constexpr double kSlide = 0.1;           // of the speed, aside, of wheels that fail [1]
constexpr double kLeastCourse = 0.15;    // slower than that a course is noise [m/s]
constexpr double kCourseSigmas = 3.0;    // and slower than that many sigmas

Vector2d perpendicular(const Vector2d& v) { return {-v.y(), v.x()}; }

Matrix2d isotropic(double variance) { return variance * Matrix2d::Identity(); }

/// Probability of a reflection now, by what was before.
double outlier_probability(const VelocityLaw& law, double duration) {
  if (law.seeks_course) return kOutlierShare;
  const double ends = -std::expm1(-duration / kOutlierTime);
  return law.outlier ? 1.0 - (1.0 - kOutlierShare) * ends : kOutlierShare * ends;
}

class VelocityExplainer {
 public:
  VelocityExplainer(Hypothesis& hypothesis, const VelocitySighting& sighting, RandomStream& random);

  double seek_course();
  double drive();
  void fail();
  /// Takes note of the way that the wheels have not seen, if the velocity is right and they are not.
  void see();

 private:
  double draw(double log_good, double log_bad);
  void correct(const Vector2d& error, const Vector2d& by_yaw, const Vector2d& by_scale,
               const Matrix2d& noise);

  Hypothesis& h_;
  const VelocitySighting& z_;
  RandomStream& random_;
  Vector2d driven_;       // by odometry without its scale, in the base of now [m/s]
  Vector2d by_scale_;     // derivative of what is foretold, in map [m/s]
  Vector2d foretold_;     // by odometry, in map [m/s]
  double outlier_;        // variance of a reflection, a component [m^2/s^2]
  double log_good_;       // of the prior of none,
  double log_bad_;        // and of one
  double noise_ = 0.0;    // variance of the velocity now, a component [m^2/s^2]
  double lasting_ = 0.0;  // of independent ones that say as much of what stays the same [m^2/s^2]
};

VelocityExplainer::VelocityExplainer(Hypothesis& hypothesis, const VelocitySighting& sighting,
                                     RandomStream& random)
    : h_(hypothesis), z_(sighting), random_(random), driven_(sighting.driven[hypothesis.velocity.delay]) {
  const VelocityLaw& law = h_.velocity;
  by_scale_ = -rotation(h_.mean(kYaw)) * driven_;
  foretold_ = -(1.0 - h_.mean(kScale)) * by_scale_;
  outlier_ = square(log_uniform(kLeastOutlier, kLargestOutlier, random_));
  const double share = outlier_probability(law, z_.duration);
  log_good_ = std::log(1.0 - share);
  log_bad_ = std::log(share);
  const std::size_t next = std::min(law.delay + 1, kDelays - 1);
  const double change = (z_.driven[next] - z_.driven[next - 1]).norm() / kDelayStep;
  const double white = square(kLeastSigma) + square(kOfSpeed * driven_.norm()) +
                       square(kUnsureDelay * change) + square(law.white) * z_.variance / z_.count;
  const double slow = std::max(square(kLeastSlow), square(law.slow) * z_.variance);
  const double keep = std::exp(-z_.duration / law.slow_time);
  noise_ = white + slow;
  lasting_ = white + slow * (1.0 + keep) / (1.0 - keep);
}

/// Draws whether it is a reflection, by logarithms of the likelihoods; returns the logarithm of both.
double VelocityExplainer::draw(double log_good, double log_bad) {
  const double good = log_good_ + log_good;
  const double bad = log_bad_ + log_bad;
  const double highest = std::max(good, bad);
  const double sum = highest + std::log(std::exp(good - highest) + std::exp(bad - highest));
  h_.velocity.outlier = random_.uniform() < std::exp(bad - sum);
  return sum;
}

double VelocityExplainer::seek_course() {
  const double speed = z_.velocity.norm();
  const double faster = speed - foretold_.norm();
  const double spread = noise_ + h_.covariance(kScale, kScale) * driven_.squaredNorm();
  const double log_speed = draw(log_normal(faster, spread), log_normal(faster, spread + outlier_));
  const double variance = h_.velocity.outlier ? noise_ + outlier_ : noise_;
  if (driven_.norm() > std::max(kLeastCourse, kCourseSigmas * std::sqrt(variance + square(faster)))) {
    const double course = std::atan2(z_.velocity.y(), z_.velocity.x());
    take_heading(h_, course - std::atan2(driven_.y(), driven_.x()), variance / square(speed), z_.from_start);
  }
  return log_speed - std::log(2.0 * kPi * std::max(speed, kLeastSigma));
}

double VelocityExplainer::drive() {
  const Vector2d by_yaw = perpendicular(foretold_);
  const Vector2d error = z_.velocity - foretold_;
  const Matrix2d across = by_yaw * by_scale_.transpose();
  const Matrix2d wheels = h_.velocity.way_noise / (z_.duration * std::min(z_.duration, kWindow * z_.count));
  const Matrix2d S = h_.covariance(kYaw, kYaw) * by_yaw * by_yaw.transpose() +
                     h_.covariance(kYaw, kScale) * (across + across.transpose()) +
                     h_.covariance(kScale, kScale) * by_scale_ * by_scale_.transpose() + wheels +
                     isotropic(noise_);
  const double log_density = draw(log_normal(error, S), log_normal(error, S + isotropic(outlier_)));
  if (!h_.velocity.outlier) {
    correct(error, by_yaw, by_scale_, wheels + isotropic(lasting_));
  }
  return log_density;
}

void VelocityExplainer::fail() {
  turn_unseen(h_, std::min(z_.duration, kLongestSeen), random_);
  const Vector2d ahead = rotation(h_.mean(kYaw)).col(0);
  const Vector2d across = perpendicular(ahead);
  const double along = ahead.dot(z_.velocity);
  const double aside = across.dot(z_.velocity);
  const double slide = square(kSlide * along);
  const double S = h_.covariance(kYaw, kYaw) * square(along) + slide + noise_;
  draw(log_normal(aside, S), log_normal(aside, S + outlier_));
  if (along * ahead.dot(foretold_) < 0.0) h_.velocity.outlier = true;
  if (h_.velocity.outlier) return;
  correct(aside * across, along * across, Vector2d::Zero(), isotropic(lasting_ + slide));
}

void VelocityExplainer::see() {
  const double seen = std::min(z_.duration, kLongestSeen);
  h_.velocity.unseen += seen * (z_.velocity - foretold_);
  h_.velocity.seen_time += seen;
}

/// Kalman correction by the velocity less what is foretold, with its derivatives by yaw and scale. What the
/// wheels did not see since the last one is left to the fixes: errors of velocities that last for seconds
/// would be summed up into the position.
void VelocityExplainer::correct(const Vector2d& error, const Vector2d& by_yaw, const Vector2d& by_scale,
                                const Matrix2d& noise) {
  const Eigen::Matrix<double, kStateSize, 2> PH =
      h_.covariance.col(kYaw) * by_yaw.transpose() + h_.covariance.col(kScale) * by_scale.transpose();
  const Matrix2d S = by_yaw * PH.row(kYaw) + by_scale * PH.row(kScale) + noise;
  const Eigen::Matrix<double, kStateSize, 2> K = PH * S.inverse();
  if (!h_.others.errors.empty()) {
    Eigen::Matrix<double, 2, kStateSize> H = Eigen::Matrix<double, 2, kStateSize>::Zero();
    H.col(kYaw) = by_yaw;
    H.col(kScale) = by_scale;
    h_.others.correct(H, K, S, error);
  }
  h_.mean += K * error;
  h_.mean(kYaw) = wrap_angle(h_.mean(kYaw));
  h_.covariance -= K * PH.transpose();
  h_.covariance = (0.5 * (h_.covariance + h_.covariance.transpose())).eval();
}

}  // namespace

std::optional<double> explain_velocity(Hypothesis& hypothesis, const VelocitySighting& sighting,
                                       RandomStream& random) {
  VelocityExplainer explainer(hypothesis, sighting, random);
  if (hypothesis.velocity.seeks_course) return explainer.seek_course();
  explainer.see();
  if (!hypothesis.wheel_fault.any()) return explainer.drive();
  explainer.fail();
  return std::nullopt;
}

}  // namespace multipath_localization::multipath
