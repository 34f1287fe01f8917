#include "tools/tuning/noise_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "estimators/multipath/odometry_jump.hpp"
#include "multipath_localization/localization/standstill.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kFewestFixes = 50;
constexpr double kFewestMoving = 10.0;  // [s]
constexpr double kClearlyWorse = 2.0;   // of log likelihood
constexpr double kTold = 2.0;           // factor
constexpr double kWalkStep = 0.5;       // of a logarithm, in search of the ends of a range
constexpr double kCoarse = 0.8, kFine = 0.02, kFineAside = 0.1;
constexpr double kLongestDelay = 1.0;  // [s]
constexpr double kDelayStep = 0.1, kFinestDelay = 0.002;
constexpr double kFarthestAntenna = 5.0;  // from where it is told to be [m]
constexpr double kAntennaStep = 0.1;      // [m]
constexpr double kWidestDelay = 0.3;      // range of one that is told, to either side [s]
constexpr double kWidestAntenna = 0.5;    // likewise [m]
constexpr double kApart = 0.02;           // one less the squared correlation of two that are told apart

constexpr double kSpeedVaries = 0.1;  // about its mean, which parts the two
constexpr double kTyresHold = 10.0;   // no wheeled robot changes its speed faster [m/s^2]

constexpr std::size_t kNumbers = 5;

/// Logarithms of the numbers of SensorNoise in their order.
using Logs = std::array<double, kNumbers>;

struct Limits {
  double least, most;
};
constexpr std::array<Limits, kNumbers> kLimits{
    {{1e-4, 1.0}, {1e-4, 1.0}, {1e-3, 100.0}, {1e-3, 100.0}, {1.0, 3000.0}}};

Logs logs_of(const SensorNoise& noise) {
  return {std::log(noise.distance), std::log(noise.yaw), std::log(noise.white), std::log(noise.wander),
          std::log(noise.wander_time)};
}

SensorNoise noise_of(const Logs& logs) {
  return {std::exp(logs[0]), std::exp(logs[1]), std::exp(logs[2]), std::exp(logs[3]), std::exp(logs[4])};
}

bool within(double log, std::size_t i) {
  return log >= std::log(kLimits[i].least) - 1e-9 && log <= std::log(kLimits[i].most) + 1e-9;
}

struct Optimum {
  Logs logs;
  double log_likelihood = 0.0;
};

/// Likelihood on the numbers, with a search that keeps one of them where it is.
class Landscape {
 public:
  explicit Landscape(const FixSequence& sequence) : sequence_(sequence) {}

  [[nodiscard]] double operator()(const Logs& logs) const {
    return sequence_.explain(noise_of(logs)).log_likelihood;
  }

  /// Compass search: each number up or down by `step` while that helps, then half the step down to `finest`.
  [[nodiscard]] Optimum climb(Logs from, double step, double finest, std::size_t kept = kNumbers) const {
    Optimum best{from, (*this)(from)};
    for (; step >= finest; step *= 0.5) {
      while (improve(best, step, kept)) {
      }
    }
    return best;
  }

 private:
  bool improve(Optimum& best, double step, std::size_t kept) const {
    const double before = best.log_likelihood;
    for (std::size_t i = 0; i < kNumbers; ++i) {
      for (const double change : {step, -step}) {
        Logs tried = best.logs;
        tried[i] += change;
        if (i == kept || !within(tried[i], i)) continue;
        const double likelihood = (*this)(tried);
        if (likelihood <= best.log_likelihood) continue;
        best = {tried, likelihood};
        break;
      }
    }
    return best.log_likelihood > before + 1e-3;
  }

  const FixSequence& sequence_;
};

/// Where number `i` becomes clearly worse than at the optimum on the way to `sign`; the limit, and false,
/// where it does not.
std::pair<double, bool> end_of_range(const Landscape& landscape, const Optimum& top, std::size_t i,
                                     double sign) {
  Optimum last = top;
  while (true) {
    Logs next = last.logs;
    next[i] += sign * kWalkStep;
    if (!within(next[i], i)) return {sign > 0.0 ? kLimits[i].most : kLimits[i].least, false};
    Optimum here{next, landscape(next)};  // as good as at the top needs no search for better
    if (top.log_likelihood - here.log_likelihood > 0.5 * kClearlyWorse) {
      here = landscape.climb(next, 0.2, kFineAside, i);
    }
    const double worse = top.log_likelihood - here.log_likelihood;
    if (worse > kClearlyWorse) {
      const double before = std::max(top.log_likelihood - last.log_likelihood, 0.0);
      const double share =  // of a parabola's arm
          (std::sqrt(kClearlyWorse) - std::sqrt(before)) / (std::sqrt(worse) - std::sqrt(before));
      return {std::exp(last.logs[i] + sign * kWalkStep * std::clamp(share, 0.0, 1.0)), true};
    }
    last = here;
  }
}

Told told(const Landscape& landscape, const Optimum& top, std::size_t i) {
  Told result;
  result.value = std::exp(top.logs[i]);
  std::tie(result.low, result.low_told) = end_of_range(landscape, top, i, -1.0);
  std::tie(result.high, result.high_told) = end_of_range(landscape, top, i, 1.0);
  return result;
}

/// Delay and how much further ahead the antenna is than told, with the likelihood of a noise and both. A
/// delay moves the antenna back by the way of that time, so at one speed the two are one.
class DelayAndAntenna {
 public:
  using Point = Eigen::Vector2d;  ///< [s], [m]

  DelayAndAntenna(const std::vector<OdometryIncrement>& odometry, const std::vector<GnssFix>& fixes,
                  const SensorNoise& noise)
      : odometry_(odometry), fixes_(fixes), noise_(noise) {}

  /// Log likelihood, as of all fixes whatever the delay leaves out.
  [[nodiscard]] double operator()(const Point& at) const {
    std::vector<GnssFix> moved = fixes_;
    for (GnssFix& fix : moved) fix.antenna_in_base.x() += at.y();
    const FixSequence sequence(odometry_, moved, at.x());
    return sequence.explain(noise_).log_likelihood /
           static_cast<double>(std::max(sequence.size(), kFewestFixes)) * static_cast<double>(fixes_.size());
  }

  [[nodiscard]] Point likeliest() const {
    Point best(0.0, 0.0);
    double likelihood = (*this)(best);
    for (double step = 1.0; step >= kFinestDelay / kDelayStep; step *= 0.5) {
      while (climbs(step, best, likelihood)) {
      }
    }
    return best;
  }

  /// Covariance by the curvature there; nothing where the two are not told apart.
  [[nodiscard]] std::optional<Eigen::Matrix2d> covariance(const Point& top) const {
    const Point h = curvature_step();
    const auto at = [&](double i, double j) { return (*this)(top + Point(i * h.x(), j * h.y())); };
    const double centre = at(0, 0);
    Eigen::Matrix2d information;
    information(0, 0) = -(at(1, 0) - 2.0 * centre + at(-1, 0)) / (h.x() * h.x());
    information(1, 1) = -(at(0, 1) - 2.0 * centre + at(0, -1)) / (h.y() * h.y());
    information(0, 1) = information(1, 0) =
        -(at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4.0 * h.x() * h.y());
    const double own = information(0, 0) * information(1, 1);
    if (!(information(0, 0) > 0.0) || !(information.determinant() > kApart * own)) return std::nullopt;
    return information.inverse();
  }

  /// Variance of the antenna's place there, the delay being known; infinite where the drive does not tell
  /// [m^2].
  [[nodiscard]] double variance_of_antenna(const Point& top) const {
    const Point step(0.0, curvature_step().y());
    const double bend = 2.0 * (*this)(top) - (*this)(top + step) - (*this)(top - step);
    return bend > 0.0 ? step.squaredNorm() / bend : std::numeric_limits<double>::infinity();
  }

 private:
  /// Goes from `best` wherever a step of that size raises the likelihood; false where none does.
  bool climbs(double step, Point& best, double& likelihood) const {
    bool moved = false;
    for (const Point& way : {Point(1, 0), Point(0, 1), Point(1, 1), Point(1, -1)}) {
      for (const double signed_step : {step, -step}) {
        const Point tried = best + signed_step * way.cwiseProduct(Point(kDelayStep, kAntennaStep));
        const double there = (*this)(tried);
        const bool beyond = std::abs(tried.x()) > kLongestDelay || std::abs(tried.y()) > kFarthestAntenna;
        if (there <= likelihood || beyond) continue;
        best = tried;
        likelihood = there;
        moved = true;
      }
    }
    return moved;
  }

  static Point curvature_step() { return {0.5 * kDelayStep, 0.5 * kAntennaStep}; }

  const std::vector<OdometryIncrement>& odometry_;
  const std::vector<GnssFix>& fixes_;
  SensorNoise noise_;
};

/// A value and its range by a variance.
Told with_range(double value, double variance, double widest) {
  const double off = std::sqrt(2.0 * kClearlyWorse * variance);
  return {value, value - off, value + off, off < widest, off < widest};
}

/// By how much the speed varies about its mean while the robot moves, as a share of it.
double speed_variation(const std::vector<OdometryIncrement>& odometry, double from, double to) {
  double time = 0.0;
  double way = 0.0;
  double squares = 0.0;
  for (const OdometryIncrement& u : odometry) {
    if (u.stamp < from || u.stamp > to || standing(u)) continue;
    time += u.duration;
    way += u.speed * u.duration;
    squares += u.speed * u.speed * u.duration;
  }
  return squares * time > way * way ? std::sqrt(squares * time / (way * way) - 1.0) : 0.0;
}

/// Whether odometry leaps by what no robot drives, as encoders do that lose or make up ticks.
bool leaps(const std::vector<OdometryIncrement>& odometry) {
  OdometryJump jump({kTyresHold, std::numeric_limits<double>::infinity(), 0.0}, {});
  for (const OdometryIncrement& u : odometry) jump.add(u);
  return jump.take().speed;
}

void fit_delay(const std::vector<OdometryIncrement>& odometry, const std::vector<GnssFix>& fixes,
               const SensorNoise& noise, NoiseFit& fit) {
  const DelayAndAntenna likelihood(odometry, fixes, noise);
  const DelayAndAntenna::Point top = likelihood.likeliest();
  const bool apart = speed_variation(odometry, fixes.front().stamp, fixes.back().stamp) > kSpeedVaries;
  const double speed = fit.way / fit.moving_time;
  fit.odometry_leaps = leaps(odometry);
  // A leap ahead in the odometry looks like fixes that come late.
  auto covariance = apart && !fit.odometry_leaps ? likelihood.covariance(top) : std::nullopt;
  // The curvature at the top may promise what the likelihood does not keep: an antenna elsewhere explains it.
  const DelayAndAntenna::Point undelayed(0.0, top.y() - top.x() * speed);
  const bool clear = likelihood(top) - likelihood(undelayed) > kClearlyWorse;
  if (covariance && !clear && square(top.x()) > 2.0 * kClearlyWorse * (*covariance)(0, 0)) covariance.reset();
  const Eigen::Vector2d variance = covariance
                                       ? Eigen::Vector2d(covariance->diagonal())
                                       : Eigen::Vector2d::Constant(kFarthestAntenna * kFarthestAntenna);
  fit.delay = with_range(top.x(), variance.x(), kWidestDelay);
  fit.antenna_ahead = with_range(top.y(), variance.y(), kWidestAntenna);
  fit.behind = with_range(top.x() * speed - top.y(), likelihood.variance_of_antenna(top), kWidestAntenna);
}

}  // namespace

bool Told::told() const { return low_told && high_told && value < kTold * low && high < kTold * value; }

NoiseFit fit_noise(const std::vector<OdometryIncrement>& reported, const std::vector<GnssFix>& fixes) {
  const std::vector<OdometryIncrement> odometry = settled(reported);
  NoiseFit fit;
  const FixSequence undelayed(odometry, fixes, 0.0);
  fit.fixes = undelayed.size();
  fit.way = undelayed.way();
  fit.moving_time = undelayed.moving_time();
  if (fit.fixes < kFewestFixes || fit.moving_time < kFewestMoving) return fit;
  const Optimum rough = Landscape(undelayed).climb(logs_of({}), kCoarse, 0.1);
  fit_delay(odometry, fixes, noise_of(rough.logs), fit);

  std::vector<GnssFix> placed = fixes;
  for (GnssFix& fix : placed) fix.antenna_in_base.x() += fit.antenna_ahead.value;
  const FixSequence sequence(odometry, placed, fit.delay.value);
  const Landscape landscape(sequence);
  const Optimum top = landscape.climb(rough.logs, 0.4, kFine);
  fit.distance = told(landscape, top, 0);
  fit.yaw = told(landscape, top, 1);
  fit.white = told(landscape, top, 2);
  fit.wander = told(landscape, top, 3);
  fit.wander_time = told(landscape, top, 4);
  const Explanation best = sequence.explain(noise_of(top.logs));
  fit.scale = best.scale;
  fit.gyro_bias = best.gyro_bias;
  return fit;
}

}  // namespace multipath_localization
