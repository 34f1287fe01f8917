#include "estimators/multipath/explanations.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <limits>

#include "estimators/multipath/log_normal.hpp"
#include "estimators/multipath/wheel_fault.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kOutlierShare = 0.02;    // what receivers that are well call a fix and is none
constexpr double kLargestOutlier = 40.0;  // [m]
// A bias that stays for minutes is rather an error of the pose: what holds that gains on the shadow, which
// ought to have ended, and outweighs it after about two minutes.
constexpr double kWrongPoseRate = 3e-4;  // [1/s]
constexpr double kLostRate = 1e-4;       // of hypotheses that are wrong in a way no other covers [1/s]
// Of odometry alone, in a way its law does not tell: else a receiver held to begin wrong could never win.
constexpr double kLostInGap = 0.05;
constexpr double kLongGap = 30.0;                // in which that may have happened [s]
constexpr double kNearLost = 6.0;                // [m]
constexpr double kFarLost = 600.0;               // [m]
constexpr double kMostDeclaredInfluence = 10.0;  // of a worse sigma: on shadows, and against their end
constexpr double kSeenNoise = 0.1;  // of velocities over a second, reflected ones among them [m/s]
constexpr double kMostEntry = 0.5;  // probability of entry at one fix
// Whatever a float was off by in a shadow, wrong ambiguities are off by something else.
constexpr double kChangeAnew = 0.5;

constexpr std::size_t kMostExplanations = 7;

double probability(double rate, double duration) { return -std::expm1(-rate * duration); }

/// What two components of the state do between two fixes: keep * before + noise of that variance.
struct Decay {
  double keep = 1.0;
  double variance = 0.0;
};

/// One way to explain a fix.
struct Explanation {
  double log_prior = 0.0;
  bool in_shadow = false;
  Decay slow;
  Decay shadow;
  Matrix2d noise = Matrix2d::Zero();  // white [m^2]
  double displaced = 0.0;             // variance of where the base is instead [m^2]
  bool event = true;
  bool new_shadow = false;
  bool moved_by_bias = false;  // the fixes are right, and the pose is off by what was taken for their bias
  WheelFault fault;
};

class Explainer {
 public:
  Explainer(const Hypothesis& hypothesis, const Sighting& sighting, RandomStream& random);

  Evidence choose(Explanation& chosen);
  void apply(const Explanation& chosen, Hypothesis& hypothesis);

 private:
  [[nodiscard]] Decay slow_decay(double from, double to) const;
  [[nodiscard]] Decay shadow_decay() const;
  void under_open_sky();
  void in_shadow();
  void lost();
  void add(double prior, Explanation explanation);
  void add_staying(double prior, const Explanation& explanation);
  [[nodiscard]] double log_likelihood(const Explanation& explanation) const;

  const Hypothesis& h_;
  const Sighting& z_;
  RandomStream& random_;
  double shadow_level_;    // a receiver that declares less is as smooth in a shadow [m]
  bool standing_;          // wheels that fail may stand while the robot drives
  Matrix2d white_;         // of an open sky [m^2]
  Matrix2d shadow_white_;  // the same by the level that held before the shadow
  ShadowLaw next_shadow_;
  Matrix2d outlier_;
  WheelFault fault_;
  double unseen_time_;                      // without velocities of the receiver [s]
  Vector2d unseen_way_ = Vector2d::Zero();  // beyond that of the wheels, by these [m]
  Matrix2d unseen_;                         // covariance of the motion that the wheels have not seen [m^2]
  double fault_probability_ = 0.0;
  double declared_influence_;
  double log_stay_ = 0.0;

  // Antenna and biases as the hypothesis has them: error and covariances.
  Vector2d error_;
  Matrix2d antenna_;
  Matrix2d with_slow_;
  Matrix2d with_shadow_;
  boost::container::static_vector<Explanation, kMostExplanations> all_;
};

Explainer::Explainer(const Hypothesis& hypothesis, const Sighting& sighting, RandomStream& random)
    : h_(hypothesis), z_(sighting), random_(random) {
  standing_ = z_.standing && !h_.wheel_fault.any() && z_.fault_probability <= 0.0;
  const double sigma = mean_sigma(z_.fix.covariance);
  white_ = h_.law.white_variance() * z_.fix.covariance;
  shadow_level_ = std::min(h_.level, z_.level);
  shadow_white_ = std::min(1.0, square(shadow_level_ / sigma)) * white_;
  declared_influence_ = std::max(1.0, square(sigma / h_.level));
  const double reach = std::sqrt(h_.law.white_variance()) * sigma;
  outlier_ = square(log_uniform(3.0 * reach, std::max(kLargestOutlier, 4.0 * reach), random_)) *
             Matrix2d::Identity();
  const auto draw = z_.reacquired ? draw_reacquired_law : draw_shadow_law;
  next_shadow_ = draw(h_.law.open_sigma() * h_.level, z_.largest_bias, random_);

  const bool failing = h_.wheel_fault.any();
  fault_ = failing ? h_.wheel_fault : draw_wheel_fault(random_);
  fault_probability_ = failing ? fault_goes_on(z_.unseen(), z_.standing) : z_.fault_probability;
  // Velocities may lie as well as wheels: half of the hypotheses go by neither.
  const double seen_time =
      h_.velocity.seen_time > 0.0 && random_.uniform() < 0.5 ? h_.velocity.seen_time : 0.0;
  if (seen_time > 0.0) unseen_way_ = h_.velocity.unseen;
  unseen_time_ = std::max(0.0, z_.unseen() - seen_time);
  unseen_ = unseen_motion(h_, fault_, z_.usual_speed, unseen_time_) +
            square(kSeenNoise * seen_time) * Matrix2d::Identity();

  const Vector2d lever = rotation(h_.mean(kYaw)) * z_.fix.antenna_in_base;
  const Vector2d by_yaw(-lever.y(), lever.x());
  const Eigen::Matrix<double, kStateSize, 2> PA =
      h_.covariance.leftCols<2>() + h_.covariance.col(kYaw) * by_yaw.transpose();
  error_ = z_.fix.position - h_.mean.head<2>() - lever;
  antenna_ = PA.topRows<2>() + by_yaw * PA.row(kYaw);
  with_slow_ = PA.middleRows<2>(kSlowX) + PA.middleRows<2>(kSlowX).transpose();
  with_shadow_ = PA.middleRows<2>(kShadowX) + PA.middleRows<2>(kShadowX).transpose();
}

/// A stationary process goes on as one when the declared sigma changes: it shrinks at once, and grows by
/// noise. While the robot stands it does not return to zero, so that standing gains no certainty, equation
/// (12).
Decay Explainer::slow_decay(double from, double to) const {
  const double before = square(h_.law.slow_sigma() * from);
  const double after = square(h_.law.slow_sigma() * to);
  const double shrunk = std::min(1.0, to / from);
  const double time = h_.law.slow_time();
  if (standing_) {
    return {shrunk, 2.0 * z_.duration / time * after + std::max(0.0, after - before)};
  }
  const double keep = std::exp(-z_.duration / time) * shrunk;
  return {keep, std::max(0.0, after - square(keep) * before)};
}

Decay Explainer::shadow_decay() const {
  const ShadowLaw& law = h_.shadow_law;
  if (standing_) return {1.0, 2.0 * z_.duration / law.time * square(law.size)};
  const double keep = std::exp(-z_.duration / law.time);
  return {keep, square(law.size) * (1.0 - square(keep))};
}

void Explainer::add(double prior, Explanation explanation) {
  if (prior <= 0.0) return;
  explanation.log_prior = std::log(prior);
  all_.push_back(explanation);
}

/// What was goes on: with a fix as expected, with wheels that fail, or with an outlier.
void Explainer::add_staying(double prior, const Explanation& explanation) {
  log_stay_ = std::log(prior * (1.0 - fault_probability_));
  Explanation as_expected = explanation;
  as_expected.event = false;
  add(prior * (1.0 - kOutlierShare) * (1.0 - fault_probability_), as_expected);
  Explanation failing = explanation;
  failing.fault = fault_;
  add(prior * fault_probability_, failing);
  Explanation outlier = explanation;
  outlier.noise = outlier_;
  add(prior * kOutlierShare, outlier);
}

void Explainer::under_open_sky() {
  const double enter =
      std::min(kMostEntry, probability(z_.shadow_entry_rate * declared_influence_, z_.duration));
  const double stay = 1.0 - enter;
  Explanation open;
  open.slow = slow_decay(h_.level, z_.level);
  open.noise = white_;
  add_staying(stay, open);
  Explanation entered;
  entered.in_shadow = entered.new_shadow = true;
  entered.slow = slow_decay(h_.level, shadow_level_);
  entered.shadow = {0.0, square(next_shadow_.first)};
  entered.noise = shadow_white_ + square(next_shadow_.noise) * Matrix2d::Identity();
  add(enter, entered);
}

void Explainer::in_shadow() {
  const double leave = probability(
      h_.shadow_law.leave_rate / std::min(kMostDeclaredInfluence, declared_influence_), z_.duration);
  const double change = z_.refixed ? kChangeAnew : probability(h_.shadow_law.change_rate, z_.duration);
  const double stay = (1.0 - leave) * (1.0 - change);
  Explanation on;
  on.in_shadow = true;
  on.slow = slow_decay(h_.level, shadow_level_);
  on.shadow = shadow_decay();
  on.noise = shadow_white_ + square(h_.shadow_law.noise) * Matrix2d::Identity();
  add_staying(stay, on);
  Explanation moved = on;
  moved.moved_by_bias = true;
  moved.noise = white_;
  const double wrong = standing_ ? 0.0 : probability(kWrongPoseRate, z_.duration) * likelier_if_moved(h_);
  add(stay * std::min(1.0, wrong), moved);
  Explanation changed = on;
  changed.new_shadow = true;
  changed.shadow = {0.0, square(next_shadow_.first)};
  changed.noise = shadow_white_ + square(next_shadow_.noise) * Matrix2d::Identity();
  add((1.0 - leave) * change, changed);
  Explanation left;
  left.slow = slow_decay(h_.level, z_.level);
  left.shadow = {0.0, 0.0};
  left.noise = white_;
  add(leave, left);
}

void Explainer::lost() {
  if (standing_) return;
  Explanation lost;
  lost.slow = slow_decay(h_.level, z_.level);
  lost.shadow = {0.0, 0.0};
  lost.noise = white_;
  lost.displaced = square(log_uniform(kNearLost, kFarLost, random_));
  const double in_gap = z_.after_gap ? kLostInGap : 0.0;
  add(probability(kLostRate, z_.unseen()) + in_gap * probability(1.0 / kLongGap, z_.unseen()), lost);
}

double Explainer::log_likelihood(const Explanation& e) const {
  const double a = e.slow.keep;
  const double c = e.shadow.keep;
  Vector2d innovation = error_ - a * h_.mean.segment<2>(kSlowX);
  Matrix2d S = antenna_ + a * with_slow_ + square(a) * h_.covariance.block<2, 2>(kSlowX, kSlowX) + e.noise;
  if (e.in_shadow && c != 0.0) {
    const Matrix2d across = h_.covariance.block<2, 2>(kSlowX, kShadowX);
    innovation -= c * h_.mean.segment<2>(kShadowX);
    S += c * (with_shadow_ + a * (across + across.transpose())) +
         square(c) * h_.covariance.block<2, 2>(kShadowX, kShadowX);
  }
  S.diagonal().array() += e.slow.variance + (e.in_shadow ? e.shadow.variance : 0.0) + e.displaced;
  if (e.fault.any()) innovation -= unseen_way_, S += unseen_;
  return log_normal(innovation, S);
}

Evidence Explainer::choose(Explanation& chosen) {
  h_.in_shadow ? in_shadow() : under_open_sky();
  lost();
  std::array<double, kMostExplanations> weight{};
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < all_.size(); ++k) {
    weight[k] = all_[k].log_prior + log_likelihood(all_[k]);
    highest = std::max(highest, weight[k]);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < all_.size(); ++k) sum += weight[k] = std::exp(weight[k] - highest);
  double rest = random_.uniform() * sum;
  std::size_t k = 0;
  while (k + 1 < all_.size() && (rest -= weight[k]) > 0.0) ++k;
  chosen = all_[k];
  return {highest + std::log(sum), log_stay_, chosen.event};
}

void Explainer::apply(const Explanation& chosen, Hypothesis& h) {
  decay(h, kSlowX, chosen.slow.keep, chosen.slow.variance);
  decay(h, kShadowX, chosen.shadow.keep, chosen.shadow.variance);
  if (chosen.new_shadow) h.shadow_law = next_shadow_;
  if (chosen.moved_by_bias) move_by_bias(h);
  h.in_shadow = chosen.in_shadow && !chosen.moved_by_bias;
  if (z_.refixed && h.in_shadow && held(random_)) hold(h.shadow_law, random_);
  h.level = h.in_shadow ? shadow_level_ : z_.level;
  if (chosen.fault.any()) {
    const double turning = h.wheel_fault.any() ? unseen_time_ : z_.unseen();
    h.wheel_fault = chosen.fault;
    fail(h, unseen_way_, unseen_, z_.turns_by_gyro ? 0.0 : turning, random_);
  }
  h.wheel_fault = chosen.fault;
  h.velocity.forget_way();
  if (chosen.displaced > 0.0) lose(h, chosen.displaced, random_);
  h.correct(z_.fix, chosen.noise);
}

}  // namespace

Evidence explain(Hypothesis& hypothesis, const Sighting& sighting, RandomStream& random) {
  Explainer explainer(hypothesis, sighting, random);
  Explanation chosen;
  const Evidence evidence = explainer.choose(chosen);
  explainer.apply(chosen, hypothesis);
  return evidence;
}

}  // namespace multipath_localization::multipath
