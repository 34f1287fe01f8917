#include <algorithm>
#include <cmath>

#include "estimators/multipath/hypothesis_cloud.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr std::size_t kHeadings = 64;        // all round the circle: 6 degrees apart
constexpr std::size_t kLawsPerHeading = 50;  // at least, of errors
constexpr double kRingSpacing = 0.6;         // sigma of a heading, in spacings: neighbours overlap
constexpr double kNarrowHeading = 0.1;       // a known heading that one Kalman filter holds [rad]
constexpr double kLeastStartBias = 1.5;      // [m]
constexpr double kLargestStartBias = 150.0;  // receivers start worse than they go on [m]

// One robot of five comes as it left the bench: a wheel radius or track width nobody measured, yaw rates from
// wheels that skid or a steering angle that is off by a degree or two, a gyro nobody calibrated. Each of the
// errors has a wide sigma in as many hypotheses.
constexpr double kUncalibrated = 0.2;
constexpr double kWideScaleSigma = 0.1;
constexpr double kWideGyroBiasSigma = 0.03;  // [rad/s]
constexpr double kWideTurnScaleSigma = 0.15;
constexpr double kWideCurvatureSigma = 0.02;  // [rad/m]
constexpr double kImuBiasSigma = 0.005;  // of a gyro whose driver takes out what it said at the start [rad/s]

/// Variance of one constant of the odometry at the start.
double constant_variance(double sigma, double wide_sigma, RandomStream& random) {
  return square(random.uniform() < kUncalibrated ? std::max(sigma, wide_sigma) : sigma);
}

/// Heading number k of a ring over `half` to both sides of `centre` [rad].
double ring_heading(double centre, double half, std::size_t k) {
  return wrap_angle(centre + half * (2.0 * (static_cast<double>(k) + 0.5) / kHeadings - 1.0));
}

double ring_sigma(double half) { return kRingSpacing * 2.0 * half / kHeadings; }

/// Places hypotheses about a fix, with headings all round the circle.
void spread_about(const GnssFix& fix, std::vector<Hypothesis>& hypotheses) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    hypotheses[i].renew_heading(ring_heading(0.0, kPi, i % kHeadings), square(ring_sigma(kPi)));
    hypotheses[i].velocity.seeks_course = true;
    hypotheses[i].place_at(fix);
  }
}

}  // namespace

void HypothesisCloud::spread(std::size_t count, double largest_bias) {
  hypotheses_.assign(count, Hypothesis{});
  const OdometryNoise& noise = settings_.odometry;
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(seed_, step_, static_cast<std::uint32_t>(i));
    Hypothesis& h = hypotheses_[i];
    h.law = draw_error_law(random);
    h.level = receivers_.level.value_or(0.0);
    h.in_shadow = random.uniform() < kShadowAtStart;
    h.shadow_law = draw_shadow_law(h.law.open_sigma() * h.level, largest_bias, random);
    h.shadow_law.size = log_uniform(kLeastStartBias, std::max(kLeastStartBias, largest_bias), random);
    h.covariance(kScale, kScale) = constant_variance(noise.scale_sigma, kWideScaleSigma, random);
    h.covariance(kGyroBias, kGyroBias) = constant_variance(noise.gyro_bias_sigma, kWideGyroBiasSigma, random);
    h.covariance(kTurnScale, kTurnScale) =
        constant_variance(settings_.turn_scale_sigma, kWideTurnScaleSigma, random);
    h.covariance(kCurvature, kCurvature) = constant_variance(0.0, kWideCurvatureSigma, random);
    h.covariance(kImuBias, kImuBias) = constant_variance(kImuBiasSigma, kWideGyroBiasSigma, random);
    h.law.log_gyro = draw_gyro_noise(random);
    h.log_weight = -std::log(static_cast<double>(count));
  }
  ++step_;
}

void HypothesisCloud::start(const GnssFix& fix) {
  receivers_ = {fix.receiver, mean_sigma(fix.covariance), fix.level, {}};
  spread(std::max(static_cast<std::size_t>(settings_.particles), kHeadings * kLawsPerHeading),
         kLargestStartBias);
  spread_about(fix, hypotheses_);
  refresh();
}

void HypothesisCloud::start(const GnssFix& fix, const HypothesisCloud& learnt, double largest_bias) {
  receivers_ = learnt.receivers_;
  receivers_.level = mean_sigma(fix.covariance);
  const auto count = static_cast<std::size_t>(settings_.particles);
  spread(count, largest_bias);
  for (std::size_t i = 0; i < count; ++i) {
    const Hypothesis& teacher = learnt.hypotheses_[i * learnt.hypotheses_.size() / count];
    const bool as_learnt = (i / kHeadings) % 2 == 0;
    if (as_learnt) hypotheses_[i].adopt(teacher);
    for (const ReceiverErrors& errors : teacher.others.errors) add_receiver(hypotheses_[i], errors);
  }
  spread_about(fix, hypotheses_);
  refresh();
}

void HypothesisCloud::start(const PosePrior& prior) {
  receivers_ = {};
  const double yaw_sigma = std::sqrt(prior.covariance(2, 2));
  const bool narrow = yaw_sigma < kNarrowHeading;
  const auto particles = static_cast<std::size_t>(settings_.particles);
  spread(narrow ? particles : std::max(particles, kHeadings * kLawsPerHeading), kLargestStartBias);
  const double half = std::min(3.0 * yaw_sigma, kPi);
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    Hypothesis& h = hypotheses_[i];
    h.mean.head<3>() << prior.pose.x, prior.pose.y, prior.pose.yaw;
    h.covariance.topLeftCorner<3, 3>() = prior.covariance;
    if (h.in_shadow) h.covariance.bottomRightCorner<2, 2>().diagonal().setConstant(square(h.shadow_law.size));
    if (narrow) continue;
    const double yaw = ring_heading(prior.pose.yaw, half, i % kHeadings);
    h.renew_heading(yaw, square(ring_sigma(half)));
    h.log_weight -= 0.5 * square(wrap_angle(yaw - prior.pose.yaw) / yaw_sigma);
  }
  refresh();
}

}  // namespace multipath_localization::multipath
