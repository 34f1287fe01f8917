#include <cmath>
#include <optional>

#include "multipath_localization/core/covariance.hpp"
#include "simulation/gauss_markov.hpp"
#include "simulation/random_ranges.hpp"
#include "simulation/random_receiver.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

namespace ranges = random_ranges;

Eigen::Vector2d of_length(RandomStream& random, double length) {
  const double direction = draw(random, Span{-kPi, kPi});
  return length * Eigen::Vector2d(std::cos(direction), std::sin(direction));
}

/// Why fixes carry a bias for a while, and which.
struct Episode {
  FixFault fault = FixFault::kNone;
  const RandomShadow* shadow = nullptr;
  double length = 0.0;  ///< of the bias [m]

  bool operator!=(const Episode& other) const { return fault != other.fault || shadow != other.shadow; }
};

/// Makes the fixes of a receiver one after the other.
class FixReader {
 public:
  FixReader(const RandomReceiver& receiver, std::uint64_t seed)
      : receiver_(receiver), random_(seed, 0, kRandomFixStream) {
    const bool fixed = receiver_.kind != ReceiverKind::kRtk || chance(random_, 0.6);
    enter(fixed ? static_cast<std::size_t>(kFixed) : below_fixed(), 0.0);
  }

  /// A fix of the antenna at `position`, or none in an outage.
  void read(const Eigen::Vector2d& position, double time, ReadFixes& read) {
    const double duration = time - last_;
    last_ = time;
    go_on(duration);
    if (const RandomOutage* outage = outage_at(time)) {
      ended_ = outage;
      return;
    }
    const RandomShadow* shadow = shadow_at(receiver_, position);
    settle_level(shadow, time);
    settle_after_outage(time);
    FixTruth truth = bias(wanted(shadow, time), time, duration);
    truth.level = level_;
    truth.new_level = entered_;
    entered_ = false;
    read.fixes.push_back(fix(position, time, truth));
    read.truths.push_back(truth);
  }

 private:
  [[nodiscard]] const FixErrors& errors() const { return receiver_.levels[level_]; }

  std::size_t below_fixed() { return chance(random_, 0.6) ? kFloat : kSingle; }

  double waiting_time(double mean) { return -mean * std::log(1.0 - random_.uniform()); }

  void enter(std::size_t level, double time) {
    level_ = level;
    entered_ = true;
    constant_ = of_length(random_, errors().constant);
    slow_ = normal2(random_, errors().slow_sigma);
    until_ = time + waiting_time(level == kFixed ? receiver_.fixed_stretch : receiver_.float_stretch);
    wrong_until_ = time;
    if (receiver_.kind == ReceiverKind::kRtk && level == kFixed &&
        chance(random_, receiver_.wrong_fix_share)) {
      wrong_until_ = time + draw(random_, ranges::kWrongFixDuration);
      wrong_length_ = draw(random_, ranges::kWrongFixOffset);
    }
  }

  void go_on(double duration) {
    const double kept = std::exp(-duration / errors().slow_time);
    slow_ = kept * slow_ + normal2(random_, errors().slow_sigma * std::sqrt(1.0 - kept * kept));
  }

  [[nodiscard]] const RandomOutage* outage_at(double time) const {
    for (const RandomOutage& outage : receiver_.outages) {
      if (outage.when.holds(time)) return &outage;
    }
    return nullptr;
  }

  void settle_level(const RandomShadow* shadow, double time) {
    if (receiver_.kind != ReceiverKind::kRtk) return;
    const bool blocked = shadow != nullptr && receiver_.declares_shadow;
    if (level_ == kFixed) {
      if (blocked || ended_ != nullptr || time >= until_) enter(below_fixed(), time);
    } else if (!blocked && time >= until_) {
      enter(kFixed, time);
    }
  }

  void settle_after_outage(double time) {
    if (ended_ == nullptr) return;
    off_until_ = time + ended_->off_duration;
    off_length_ = ended_->off_bias;
    ended_ = nullptr;
  }

  [[nodiscard]] Episode wanted(const RandomShadow* shadow, double time) const {
    if (shadow != nullptr) return {FixFault::kShadow, shadow, shadow->bias};
    if (time < wrong_until_) return {FixFault::kWrongFix, nullptr, wrong_length_};
    if (time < off_until_) return {FixFault::kAfterOutage, nullptr, off_length_};
    return {};
  }

  [[nodiscard]] static bool follows(const Episode& episode, ShadowLaw law) {
    return episode.shadow != nullptr && episode.shadow->law == law;
  }

  FixTruth bias(const Episode& episode, double time, double duration) {
    FixTruth truth;
    truth.fault = episode.fault;
    const bool jumps = follows(episode, ShadowLaw::kJumping);
    truth.new_bias = episode != episode_ || (jumps && time >= next_jump_);
    if (truth.new_bias) {
      if (episode != episode_) began_ = time;
      episode_ = episode;
      bias_ = of_length(random_, episode.length);
      if (jumps) next_jump_ = time + waiting_time(episode.shadow->interval);
    } else if (episode.shadow != nullptr) {
      truth.bias_turn = episode.shadow->turn_rate * duration;
      bias_ = rotation(truth.bias_turn) * bias_;
    }
    if (episode.fault == FixFault::kNone) return truth;
    const bool walks = follows(episode, ShadowLaw::kWalkingIn);
    truth.bias_part = walks ? std::min(1.0, (time - began_) / episode.shadow->interval) : 1.0;
    truth.bias_sigma = episode.length / std::sqrt(2.0);
    truth.bias = truth.bias_part * bias_;
    if (episode.shadow != nullptr) truth.extra_white_sigma = episode.shadow->noise * episode.shadow->bias;
    return truth;
  }

  GnssFix fix(const Eigen::Vector2d& position, double time, FixTruth& truth) {
    GnssFix fix;
    fix.stamp = time;
    fix.status = receiver_.statuses[level_];
    const Eigen::Vector2d own = slow_ + normal2(random_, errors().white_sigma);
    const Eigen::Vector2d extra = normal2(random_, truth.extra_white_sigma);
    fix.position = position + constant_ + truth.bias + receiver_.shape * own + extra;
    if (chance(random_, receiver_.outlier_share)) {
      truth.fault = FixFault::kOutlier;
      fix.position += of_length(random_, draw(random_, ranges::kOutlier));
    }
    const double sigma = declared(truth);
    fix.covariance =
        symmetric<2>(sigma * sigma * receiver_.declared_shape * receiver_.declared_shape.transpose());
    return fix;
  }

  [[nodiscard]] double declared(const FixTruth& truth) const {
    if (receiver_.declared_sigma > 0.0) return receiver_.declared_sigma;
    const bool told = truth.fault == FixFault::kShadow && receiver_.declares_shadow;
    return std::hypot(errors().sigma(), told ? truth.bias_sigma : 0.0) / receiver_.optimism;
  }

  const RandomReceiver& receiver_;
  RandomStream random_;
  double last_ = 0.0;
  std::size_t level_ = 0;
  bool entered_ = true;
  double until_ = 0.0;  ///< the level changes then
  Eigen::Vector2d constant_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d slow_ = Eigen::Vector2d::Zero();
  const RandomOutage* ended_ = nullptr;  ///< since the last fix
  double wrong_until_ = 0.0;
  double wrong_length_ = 0.0;
  double off_until_ = 0.0;
  double off_length_ = 0.0;
  Episode episode_;
  double began_ = 0.0;  ///< the episode
  double next_jump_ = 0.0;
  Eigen::Vector2d bias_ = Eigen::Vector2d::Zero();
};

}  // namespace

ReadFixes read_fixes(const RandomReceiver& receiver, const std::vector<MotionStep>& steps, std::uint64_t seed,
                     const Eigen::Vector2d& antenna_in_base) {
  ReadFixes read;
  FixReader reader(receiver, seed);
  const auto stride = static_cast<std::size_t>(receiver.period_ms / kWayStepMs);
  for (std::size_t n = 1; n * stride <= steps.size(); ++n) {
    const double time = static_cast<double>(n * stride) * kWayStepMs / 1000.0;
    reader.read(steps[n * stride - 1].base_in_map * antenna_in_base, time, read);
  }
  for (GnssFix& fix : read.fixes) fix.antenna_in_base = antenna_in_base;
  return read;
}

}  // namespace multipath_localization
