#include "estimators/multipath/hypothesis_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "estimators/multipath/wheel_fault.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/filters/resampling.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

// Fixes a moment apart are no independent evidence: under open sky one in a second counts in full, in a
// shadow one in five, where reflections are alike in ways no law covers. Events always count in full:
// equation (14).
constexpr double kOpenEvidenceTime = 1.0;      // [s]
constexpr double kShadowEvidenceTime = 5.0;    // [s]
constexpr double kLevelFactor = 1.5;           // a declared sigma that changes by less is the same one
constexpr double kLeastEffective = 0.5;        // share of the hypotheses, below it they are resampled
constexpr std::size_t kMostBesides = 2;        // times as many as wanted, of hypotheses that doubt velocities
constexpr double kKnownHeadingVariance = 0.1;  // fewer hypotheses do once the heading is known [rad^2]
constexpr double kGapTurnRate = 0.3;           // while odometry is missing, turns may add up to this [rad/s]
constexpr double kMostGapTurn = 3.0;           // [rad]
constexpr double kGapYawVariance = 0.01;       // of each hypothesis then [rad^2]
constexpr double kHeadingReach = 0.6;          // [rad]
constexpr std::uint64_t kLevelSeed = 0x8EBC6AF09C88C6E3U;  // draws that receivers without levels do not take
constexpr std::uint32_t kResampling = 0xFFFFFFFEU;         // a random stream beside those of the particles

/// Lets the weights sum up to one.
void normalise(std::vector<Hypothesis>& hypotheses) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Hypothesis& h : hypotheses) highest = std::max(highest, h.log_weight);
  double sum = 0.0;
  for (const Hypothesis& h : hypotheses) sum += std::exp(h.log_weight - highest);
  for (Hypothesis& h : hypotheses) h.log_weight -= highest + std::log(sum);
}

/// The second moments about the means, and the weight of those whose heading agrees.
void add_spread(const std::vector<Hypothesis>& hypotheses, Mixture& m) {
  m.agreement = 0.0;
  for (const Hypothesis& h : hypotheses) {
    const double w = std::exp(h.log_weight);
    Eigen::Vector3d off = h.mean.head<3>() - m.mean.head<3>();
    off(2) = wrap_angle(off(2));
    m.covariance += w * (h.covariance.topLeftCorner<3, 3>() + off * off.transpose());
    const Eigen::Vector2d bias_off = h.bias() - m.bias;
    m.bias_covariance += w * (h.bias_covariance() + bias_off * bias_off.transpose());
    if (std::abs(off(2)) < kHeadingReach) m.agreement += w;
  }
}

/// Weighs by the evidence, of which so much counts where nothing has changed, and none where the robot
/// stands.
double weigh_by(const std::vector<Evidence>& evidence, double tempered, bool standing,
                std::vector<Hypothesis>& hypotheses) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    highest = std::max(highest, hypotheses[i].log_weight + evidence[i].log_likelihood);
  }
  double prior = 0.0;
  double posterior = 0.0;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const double log_weight = hypotheses[i].log_weight;
    prior += std::exp(log_weight);
    posterior += std::exp(log_weight + evidence[i].log_likelihood - highest);
  }
  const double expected = highest + std::log(posterior / prior);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    Hypothesis& h = hypotheses[i];
    const bool parked = standing && !h.wheel_fault.any();
    const double share = parked ? 0.0 : evidence[i].event ? 1.0 : tempered;
    h.log_weight += share * (evidence[i].log_likelihood - expected);
    if (!parked) h.log_weight += (1.0 - share) * evidence[i].log_stay;
  }
  return expected;
}

double weight_if(bool held, double weight) { return held ? weight : 0.0; }

/// Lets the hypotheses go on with the laws of the level that a receiver tells, if it is another one.
void follow_level(FixLevel level, FixLevel& told, std::vector<Hypothesis>& hypotheses, std::uint64_t seed,
                  std::uint32_t step) {
  if (level == FixLevel::kUntold) return;
  const FixLevel before = std::exchange(told, level);
  if (before == level || before == FixLevel::kUntold) return;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    RandomStream random(seed ^ kLevelSeed, step, static_cast<std::uint32_t>(i));
    hypotheses[i].change_level(before, level, random);
  }
}

}  // namespace

OdometryErrors Mixture::odometry_errors() const {
  return {mean(kScale), mean(kGyroBias), mean(kTurnScale), mean(kCurvature), mean(kImuBias)};
}

double evidence_share(const Mixture& mixture, double duration) {
  const double time = kOpenEvidenceTime + (kShadowEvidenceTime - kOpenEvidenceTime) * mixture.shadow;
  return std::min(1.0, duration / time);
}

void HypothesisCloud::clear() {
  hypotheses_.clear();
  mixture_ = {};
  receivers_ = {};
  step_ = 0;
  aid_step_ = 0;
  aids_ = {};
}

void HypothesisCloud::propagate(const OdometrySum& odometry) {
  if (odometry.duration() <= 0.0) return;
  ++step_;
  const double gap_turn = std::min(kMostGapTurn, kGapTurnRate * odometry.missing_time());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    hypotheses_[i].propagate(odometry, settings_.odometry);
    if (gap_turn <= 0.0) continue;
    RandomStream random(seed_, step_, static_cast<std::uint32_t>(i));
    hypotheses_[i].mean(kYaw) = wrap_angle(hypotheses_[i].mean(kYaw) + gap_turn * random.normal());
    hypotheses_[i].covariance(kYaw, kYaw) += kGapYawVariance;
  }
  refresh();
}

void HypothesisCloud::let_wheels_fail(double probability, double speed, double duration, bool standing,
                                      bool turns_by_gyro) {
  ++step_;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    RandomStream random(seed_, step_, static_cast<std::uint32_t>(i));
    Hypothesis& h = hypotheses_[i];
    const double chance = h.wheel_fault.any() ? fault_goes_on(duration, standing) : probability;
    const bool failing = random.uniform() < chance;
    if (!failing) h.wheel_fault = {};
    if (failing && !h.wheel_fault.any()) h.wheel_fault = draw_wheel_fault(random);
    if (failing) move_unseen(h, speed, duration, turns_by_gyro, random);
  }
  refresh();
}

double HypothesisCloud::weigh(Sighting sighting) {
  attend(sighting);
  const double sigma = mean_sigma(sighting.fix.covariance);
  std::optional<double>& level = receivers_.level;
  if (!level) {
    level = sigma;
    for (Hypothesis& h : hypotheses_) h.level = sigma;
  }
  const bool changed = sigma > *level * kLevelFactor || sigma < *level / kLevelFactor;
  if (changed) level = sigma;
  sighting.level = *level;
  ++step_;
  follow_level(sighting.fix.level, receivers_.told, hypotheses_, seed_, step_);
  std::vector<Evidence> evidence(hypotheses_.size());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    RandomStream random(seed_, step_, static_cast<std::uint32_t>(i));
    Hypothesis& h = hypotheses_[i];
    const bool fault = h.wheel_fault.any() || sighting.fault_probability > 0.0;
    wander_fixes(h.law, sighting.duration, random);
    if (!sighting.standing || fault) wander_odometry(h.law, sighting.unseen(), random);
    evidence[i] = explain(h, sighting, random);
  }
  const bool standing = sighting.standing && sighting.fault_probability <= 0.0;
  const double expected =
      weigh_by(evidence, evidence_share(mixture_, sighting.duration), standing, hypotheses_);
  refresh();
  resample();
  return expected;
}

void HypothesisCloud::take_in(const HypothesisCloud& other, double share) {
  const std::size_t count = hypotheses_.size();
  for (Hypothesis& h : hypotheses_) h.log_weight += std::log1p(-share);
  hypotheses_.insert(hypotheses_.end(), other.hypotheses_.begin(), other.hypotheses_.end());
  for (std::size_t i = count; i < hypotheses_.size(); ++i) {
    hypotheses_[i].log_weight += std::log(share);
    hypotheses_[i].velocity.seeks_course = false;
  }
  refresh();
  resample(count);
}

void HypothesisCloud::resample(std::optional<std::size_t> wanted) {
  const auto particles = static_cast<std::size_t>(settings_.particles);
  const bool settled = mixture_.covariance(2, 2) < kKnownHeadingVariance;
  const std::size_t most = hypotheses_.size();
  const std::size_t count = wanted.value_or(settled ? particles : std::max(most, particles));
  const bool effective = mixture_.effective_size > kLeastEffective * static_cast<double>(count);
  const bool enough = count == most || (aids_.any() && settled && most <= kMostBesides * particles);
  if (!wanted && effective && enough) return;
  if (aids_.any()) {
    RandomStream random(seed_ ^ kAidSeed, aid_step_ + step_, kResampling);
    const bool agreed = mixture_.covariance(2, 2) < kAgreedVariance;
    hypotheses_ = drawn_by_kind(hypotheses_, aids_, agreed, count, random);
    return refresh();
  }
  std::vector<double> weights;
  weights.reserve(hypotheses_.size());
  for (const Hypothesis& h : hypotheses_) weights.push_back(std::exp(h.log_weight));
  RandomStream random(seed_, step_, kResampling);
  hypotheses_ = selected(hypotheses_, systematic_resampling(weights, count, random.uniform()));
  for (Hypothesis& h : hypotheses_) h.log_weight = -std::log(static_cast<double>(count));
  refresh();
}

void HypothesisCloud::refresh() {
  normalise(hypotheses_);
  Mixture m;
  m.covariance.setZero();
  Eigen::Vector3d log_noise = Eigen::Vector3d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();
  double velocity = 0.0;
  double heading = 0.0;
  double squares = 0.0;
  for (const Hypothesis& h : hypotheses_) {
    const double w = std::exp(h.log_weight);
    squares += square(w);
    m.mean += w * h.mean;
    direction += w * Eigen::Vector2d(std::cos(h.mean(kYaw)), std::sin(h.mean(kYaw)));
    m.bias += w * h.bias();
    log_noise += w * Eigen::Vector3d(h.law.log_way, h.law.log_turn, h.law.log_gyro);
    m.white_variance +=
        w * (h.law.white_variance() * square(h.level) + (h.in_shadow ? square(h.shadow_law.noise) : 0.0));
    m.slow_variance += w * square(h.law.slow_sigma() * h.level);
    m.shadow += weight_if(h.in_shadow, w);
    m.wheel_fault += weight_if(h.wheel_fault.any(), w);
    velocity += weight_if(h.velocity.believed && !h.velocity.outlier, w);
    heading += weight_if(h.heading.believed && !h.heading.outlier, w);
  }
  if (aids_.velocity) m.velocity = velocity;
  if (aids_.heading) m.heading = heading;
  m.mean(kYaw) = std::atan2(direction.y(), direction.x());
  m.odometry_noise = {std::exp(2.0 * log_noise(0)), std::exp(2.0 * log_noise(1)),
                      std::exp(2.0 * log_noise(2))};
  m.effective_size = 1.0 / squares;
  add_spread(hypotheses_, m);
  for (std::size_t k = 0; k < receivers_.others.size(); ++k)
    m.others.push_back(errors_of_other(hypotheses_, k));
  mixture_ = m;
}

}  // namespace multipath_localization::multipath
