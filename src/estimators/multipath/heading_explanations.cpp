#include "estimators/multipath/heading_explanations.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/multipath/log_normal.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

// Iron nearby, a wrong ambiguity, antennas that are taken for each other: of the time, and how long it stays
// so [s].
constexpr double kOutlierShare = 0.1;
constexpr double kOutlierTime = 10.0;
constexpr double kLeastSigma = 0.01;  // no receiver is better than that, whatever it declares [rad]
constexpr double kSlowShare = 0.7;    // of the noise does not average out within a second,
constexpr double kSlowTime = 10.0;    // but within this: iron that is passed, reflections [s]
constexpr double kLate = 0.25;        // stamps are as unsure, of a turning robot that is an angle [s]

double outlier_probability(const HeadingLaw& law, double duration) {
  const double ends = -std::expm1(-duration / kOutlierTime);
  return law.outlier ? 1.0 - (1.0 - kOutlierShare) * ends : kOutlierShare * ends;
}

}  // namespace

double explain_heading(Hypothesis& h, const HeadingSighting& z, RandomStream& random) {
  HeadingLaw& law = h.heading;
  const double variance = square(law.noise) * z.variance;
  const double slow = kSlowShare * variance + square(kLeastSigma);
  const double white = (1.0 - kSlowShare) * variance / z.count + square(kLate * z.turn_rate);
  const double keep = std::exp(-z.duration / kSlowTime);
  const double lasting = white + slow * (1.0 + keep) / (1.0 - keep);
  const double yaw = wrap_angle(z.yaw - law.offset);
  const bool any = h.velocity.seeks_course && z.from_start;
  const double share = any ? kOutlierShare : outlier_probability(law, z.duration);
  const double error = angle_difference(yaw, h.mean(kYaw));
  const double log_any = -std::log(2.0 * kPi);
  const double spread = h.covariance(kYaw, kYaw) + slow + white;
  const double good = std::log(1.0 - share) + (any ? log_any : log_normal(error, spread));
  const double bad = std::log(share) + log_any;
  const double sum = std::max(good, bad) + std::log1p(std::exp(-std::abs(good - bad)));
  law.outlier = random.uniform() < std::exp(bad - sum);
  if (law.outlier) return sum;
  if (any) {
    take_heading(h, yaw, slow + white, *z.from_start);
  } else {
    observe(h, kYaw, h.mean(kYaw) + error, lasting);
  }
  return sum;
}

}  // namespace multipath_localization::multipath
