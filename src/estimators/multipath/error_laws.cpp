#include "estimators/multipath/error_laws.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

/// Prior of a logarithm: normal, cut off below.
struct Prior {
  double median;
  double log_sigma;
  double least;

  [[nodiscard]] double bounded(double log) const { return std::max(log, std::log(least)); }
  [[nodiscard]] double draw(double widened, RandomStream& random) const {
    return bounded(std::log(median) + widened * log_sigma * random.normal());
  }
};

// Declared sigmas are right within a factor of three for two receivers of three, and off by ten for some.
// They describe the slow error rather than the white one.
constexpr Prior kWhite = {0.5, 1.2, 0.02};
// A receiver whose own filter is smooth shows little error for minutes and then metres: never below 0.3.
constexpr Prior kSlow = {1.0, 1.2, 0.3};
// From a receiver's own filter to what satellites' orbits take to change; a longer one would say that fixes
// and odometry made from the same signals agree for ever.
constexpr double kLeastSlowTime = 2.0;      // [s]
constexpr double kLargestSlowTime = 150.0;  // [s]
// Odometry is what its data sheet says within a factor of two; its constants are steady or not at all.
constexpr Prior kOdometry = {1.0, 0.8, 0.01};
constexpr Prior kWalk = {1.0, 1.3, 0.01};
// From one that costs as much as the robot to one that feels every stone, ten times either way.
constexpr Prior kGyro = {1.0, 1.2, 0.05};

constexpr double kFixMemory = 300.0;        // a receiver keeps its quality for minutes: a street [s]
constexpr double kOdometryMemory = 1000.0;  // a robot keeps its own for longer: a surface, a tyre [s]
// Of one robot in five the odometry is what its data sheet does not know: speeds from a receiver, worn gears.
constexpr double kRoughShare = 0.2;
constexpr double kRough = 2.5;          // log sigmas of such a one
constexpr double kRedrawn = 1.5;        // log sigmas of a law that changes at once, a heavy tail
constexpr double kBlindShare = 0.5;     // nothing tells odometry without turns from a straight way
constexpr double kBlindMemory = 100.0;  // straight ways are shorter than that [s]

// A shadow is one where its bias stands out of the errors of an open sky, and matters at all.
constexpr double kLeastShadow = 1.5;          // [m]
constexpr double kShadowToOpen = 3.0;         // [open_sigma]
constexpr double kLeastShadowTime = 3.0;      // a car passing a house [s]
constexpr double kLargestShadowTime = 300.0;  // a reflection that stays, a wrong ambiguity [s]
constexpr double kLeastShadowNoise = 0.005;   // of its size: a carrier phase that is wrong by whole waves
constexpr double kLargestShadowNoise = 0.3;   // of its size: code phase under changing reflections
// Of some the bias hardly moves and the noise is that of an open sky: a wrong ambiguity, one strong
// reflection. Without them a pose that is off would explain such fixes better than a shadow.
constexpr double kConstantShare = 0.3;
constexpr double kLeastConstantTime = 1e4;    // 20 m walk by 0.28 m in a second, which coarse fixes hide [s]
constexpr double kLeastFirstBias = 0.1;       // of its size: biases walk in or jump
constexpr double kShadowEndRate = 0.08;       // a side of a house at walking pace [1/s]
constexpr double kShadowEndRateSpread = 3.0;  // a factor up and down: from 4 to 40 s
constexpr double kShadowChangeRate = 1 / 30.0;  // another reflection: a house or two further [1/s]
// A receiver that begins anew may begin wrong, by an ambiguity or among reflections, and hold on to that
// until it finds out: after a minute, or after ten.
constexpr double kHeldShare = 0.3;
constexpr double kShortestHeld = 60.0;  // [s]
constexpr double kLongestHeld = 600.0;  // [s]
constexpr double kHeldTime = 1e7;       // so that 40 m walk by less than a carrier's wave in a minute [s]

void step(double& log, const Prior& prior, double duration, double memory, RandomStream& random) {
  const double keep = std::exp(-duration / memory);
  const double mean = std::log(prior.median);
  log = prior.bounded(mean + keep * (log - mean) +
                      prior.log_sigma * std::sqrt(1.0 - keep * keep) * random.normal());
}

bool happens(double duration, double time, RandomStream& random) {
  return random.uniform() < duration / time;
}

/// Of a bias that walks in a second by no more than what it hides in.
double constant_time(double size, double open_sigma) {
  return std::max(kLeastConstantTime, 2.0 * square(size / open_sigma));
}

/// The bias is what it is for minutes, as smooth as under an open sky.
void let_last(ShadowLaw& law, RandomStream& random) {
  law.noise = 0.0;
  law.leave_rate = law.change_rate = 1.0 / log_uniform(kShortestHeld, kLongestHeld, random);
}

double draw_slow_time(RandomStream& random) {
  return std::log(log_uniform(kLeastSlowTime, kLargestSlowTime, random));
}

}  // namespace

double log_uniform(double low, double high, RandomStream& random) {
  return low * std::exp(random.uniform() * std::log(high / low));
}

double FixLaw::white_variance() const { return std::exp(2.0 * log_white); }
double FixLaw::slow_sigma() const { return std::exp(log_slow); }
double FixLaw::slow_time() const { return std::exp(log_slow_time); }
double FixLaw::open_sigma() const { return std::exp(std::max(log_white, log_slow)); }

NoiseFactors ErrorLaw::odometry_noise() const {
  return {std::exp(2.0 * log_way), std::exp(2.0 * log_turn), std::exp(2.0 * log_gyro)};
}

double draw_gyro_noise(RandomStream& random) { return kGyro.draw(1.0, random); }

FixLaw draw_fix_law(RandomStream& random) {
  FixLaw law;
  law.log_white = kWhite.draw(1.0, random);
  law.log_slow = kSlow.draw(1.0, random);
  law.log_slow_time = draw_slow_time(random);
  return law;
}

ErrorLaw draw_error_law(RandomStream& random) {
  ErrorLaw law;
  static_cast<FixLaw&>(law) = draw_fix_law(random);
  const double widened = random.uniform() < kRoughShare ? kRough : 1.0;
  law.log_way = kOdometry.draw(widened, random);
  law.log_turn = kOdometry.draw(widened, random);
  law.log_walk = kWalk.draw(1.0, random);
  law.blind = random.uniform() < kBlindShare;
  return law;
}

void wander_fixes(FixLaw& law, double duration, RandomStream& random) {
  step(law.log_white, kWhite, duration, kFixMemory, random);
  step(law.log_slow, kSlow, duration, kFixMemory, random);
  if (happens(duration, kFixMemory, random)) law.log_slow_time = draw_slow_time(random);
}

void wander_odometry(ErrorLaw& law, double duration, RandomStream& random) {
  step(law.log_way, kOdometry, duration, kOdometryMemory, random);
  step(law.log_turn, kOdometry, duration, kOdometryMemory, random);
  step(law.log_walk, kWalk, duration, kOdometryMemory, random);
  if (happens(duration, kBlindMemory, random)) law.blind = random.uniform() < kBlindShare;
  if (happens(duration, kOdometryMemory, random)) {
    law.log_way = kOdometry.draw(kRedrawn, random);
    law.log_walk = kWalk.draw(kRedrawn, random);
  }
}

double still_wrong(double age) {
  return kHeldShare * std::exp(-age / std::sqrt(kShortestHeld * kLongestHeld));
}

bool held(RandomStream& random) { return random.uniform() < kHeldShare; }

ShadowLaw draw_shadow_law(double open_sigma, double largest, RandomStream& random) {
  ShadowLaw law;
  const double least = std::max(kLeastShadow, kShadowToOpen * open_sigma);
  law.size = log_uniform(least, std::max(largest, kShadowToOpen * least), random);
  const bool constant = random.uniform() < kConstantShare;
  law.time = constant ? constant_time(law.size, open_sigma)
                      : log_uniform(kLeastShadowTime, kLargestShadowTime, random);
  law.noise = constant ? 0.0 : law.size * log_uniform(kLeastShadowNoise, kLargestShadowNoise, random);
  law.first = law.size * log_uniform(kLeastFirstBias, 1.0, random);
  law.leave_rate = kShadowEndRate * log_uniform(1.0 / kShadowEndRateSpread, kShadowEndRateSpread, random);
  law.change_rate = kShadowChangeRate;
  return law;
}

void hold(ShadowLaw& law, RandomStream& random) {
  law.time = kHeldTime;
  let_last(law, random);
}

ShadowLaw draw_reacquired_law(double open_sigma, double largest, RandomStream& random) {
  ShadowLaw law = draw_shadow_law(open_sigma, largest, random);
  law.first = law.size;
  if (!held(random)) return law;
  law.time = constant_time(law.size, open_sigma);
  let_last(law, random);
  return law;
}

}  // namespace multipath_localization::multipath
