#include "multipath_localization/evaluation/sensor_noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>

#include "multipath_localization/evaluation/metrics.hpp"

namespace multipath_localization {

namespace {

constexpr double kLoud = 2.0;             // residuals over those of the best quarter
constexpr double kMargin = 3.0;           // of odometry beyond the fixes of a stretch [s]
constexpr double kMoving = 0.05;          // [m/s]
constexpr std::size_t kFewStretches = 4;  // for what varies from one to the other
constexpr double kRandomWalk = 1.2;       // see `sensor_noise`
constexpr double kSureDelay = 0.1;        // 1 sigma [s]
constexpr std::size_t kFewestPairs = 50;
constexpr double kSeenWander = 0.05;  // variance of the wander over that of the white noise

/// Increments and fixes between two times.
std::optional<StretchFit> stretch_between(const Drive& drive, const std::vector<GnssFix>& fixes, double from,
                                          double to) {
  std::vector<OdometryIncrement> increments;
  double moving = 0.0;
  for (const OdometryIncrement& increment : drive.odometry) {
    if (increment.stamp < from - kMargin || increment.stamp > to + kMargin) continue;
    increments.push_back(increment);
    if (std::abs(increment.speed) > kMoving) moving += increment.duration;
  }
  std::vector<GnssFix> within;
  for (const GnssFix& fix : fixes) {
    if (fix.stamp >= from && fix.stamp < to) within.push_back(fix);
  }
  if (moving < 0.5 * (to - from)) return std::nullopt;
  return fit_stretch(increments, within);
}

/// Those in which nothing disturbs the fixes.
std::vector<StretchFit> quiet_of(std::vector<StretchFit> all) {
  std::vector<double> rms;
  for (const StretchFit& fit : all) rms.push_back(fit.rms);
  if (rms.empty()) return all;
  const double limit = kLoud * quantile(rms, 0.25);
  all.erase(std::remove_if(all.begin(), all.end(), [&](const StretchFit& fit) { return fit.rms > limit; }),
            all.end());
  return all;
}

/// Half the mean square difference of residuals by lag, in steps of the period of the fixes.
struct StructureFunction {
  double period = 0.0;
  std::vector<double> values;  ///< of lags 1, 2, ... periods, one component [m^2]
};

StructureFunction structure_of(const std::vector<StretchFit>& stretches) {
  StructureFunction result;
  std::vector<double> periods;
  double shortest = 1e9;
  for (const StretchFit& fit : stretches) {
    shortest = std::min(shortest, fit.duration);
    for (std::size_t i = 1; i < fit.residuals.size(); ++i) {
      periods.push_back(fit.residuals[i].stamp - fit.residuals[i - 1].stamp);
    }
  }
  if (periods.empty()) return result;
  result.period = quantile(periods, 0.5);
  const auto lags = static_cast<std::size_t>(0.25 * shortest / result.period);
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    double sum = 0.0;
    std::size_t pairs = 0;
    for (const StretchFit& fit : stretches) {
      for (std::size_t i = lag; i < fit.residuals.size(); ++i) {
        sum += 0.25 * (fit.residuals[i].error - fit.residuals[i - lag].error).squaredNorm();
        ++pairs;
      }
    }
    if (pairs < kFewestPairs) break;
    result.values.push_back(sum / static_cast<double>(pairs));
  }
  return result;
}

/// The white and coloured variances that fit best for one time constant, and how badly.
struct Fit {
  double white = 0.0;
  double coloured = 0.0;
  double misfit = 1e300;
};

Fit fit_of(const StructureFunction& structure, double time_constant) {
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  const auto shape = [&](std::size_t i) {
    return 1.0 - std::exp(-structure.period * static_cast<double>(i + 1) / time_constant);
  };
  for (std::size_t i = 0; i < structure.values.size(); ++i) {
    const Eigen::Vector2d row(1.0, shape(i));
    A += row * row.transpose();
    b += row * structure.values[i];
  }
  Eigen::Vector2d x = A.ldlt().solve(b);
  if (x[1] < 0.0) x = {b[0] / A(0, 0), 0.0};
  if (x[0] < 0.0) x = {0.0, b[1] / A(1, 1)};
  Fit fit{x[0], x[1], 0.0};
  for (std::size_t i = 0; i < structure.values.size(); ++i) {
    fit.misfit += std::pow(x[0] + x[1] * shape(i) - structure.values[i], 2);
  }
  return fit;
}

using Value = std::function<Measured(const StretchFit&)>;

/// Mean over the stretches by their information; sure to what they vary by.
std::optional<Measured> mean_of(const std::vector<StretchFit>& stretches, const Value& value) {
  double weights = 0.0, sum = 0.0, squares = 0.0;
  for (const StretchFit& fit : stretches) {
    const Measured m = value(fit);
    const double weight = 1.0 / (m.sigma * m.sigma);
    weights += weight;
    sum += weight * m.value;
    squares += weight * m.value * m.value;
  }
  if (stretches.empty()) return std::nullopt;
  const double mean = sum / weights;
  const double spread = std::max(squares / weights - mean * mean, 0.0);
  return Measured{mean, std::sqrt(1.0 / weights + spread / static_cast<double>(stretches.size()))};
}

/// Density of the random walk whose rate varies so from stretch to stretch; `length` of a stretch in the
/// walk's own unit. Nothing where the fixes explain most of it.
std::optional<double> walk_of(const std::vector<StretchFit>& stretches, const Value& value, double length) {
  if (stretches.size() < kFewStretches) return std::nullopt;
  const double n = static_cast<double>(stretches.size());
  double mean = 0.0, variance = 0.0, by_fixes = 0.0;
  for (const StretchFit& fit : stretches) mean += value(fit).value / n;
  for (const StretchFit& fit : stretches) {
    variance += std::pow(value(fit).value - mean, 2) / (n - 1.0);
    by_fixes += std::pow(value(fit).sigma, 2) / n;
  }
  if (variance < 2.0 * by_fixes) return std::nullopt;
  return std::sqrt((variance - by_fixes) * length / kRandomWalk);
}

/// How much more a slow wander of the fixes disturbs a fit than the same variance of white noise does: fixes
/// within two time constants are one.
double inflation(const FixNoise& noise, double period) {
  const double white = noise.white_sigma * noise.white_sigma;
  const double coloured = noise.coloured_sigma * noise.coloured_sigma;
  const double together = noise.time_constant ? std::max(2.0 * *noise.time_constant / period, 1.0) : 1.0;
  return (white + coloured * together) / std::max(white + coloured, 1e-12);
}

Value figure(Eigen::Index i, double factor) {
  return [i, factor](const StretchFit& fit) {
    const double value = i == 0 ? fit.scale : i == 1 ? fit.gyro_bias : fit.delay;
    return Measured{value, std::sqrt(factor * fit.covariance(i, i))};
  };
}

}  // namespace

std::optional<FixNoise> fix_noise(const std::vector<StretchFit>& stretches) {
  const StructureFunction structure = structure_of(stretches);
  if (structure.values.size() < 4) return std::nullopt;
  const double longest = structure.period * static_cast<double>(structure.values.size());
  Fit best;
  double time_constant = 0.0;
  for (double tried = 2.0 * structure.period; tried <= 2.0 * longest; tried *= 1.1) {
    const Fit fit = fit_of(structure, tried);
    if (fit.misfit >= best.misfit) continue;
    best = fit;
    time_constant = tried;
  }
  FixNoise noise{std::sqrt(best.white), 0.0, std::nullopt};
  if (best.coloured < kSeenWander * best.white) return noise;
  noise.coloured_sigma = std::sqrt(best.coloured);
  if (time_constant <= longest) noise.time_constant = time_constant;
  return noise;
}

SensorNoise sensor_noise(const Drive& drive, double stretch) {
  SensorNoise noise;
  const std::vector<GnssFix> fixes = drive.fixes();
  if (fixes.empty() || drive.odometry.empty()) return noise;
  std::vector<StretchFit> all;
  for (double from = fixes.front().stamp + kMargin; from + stretch <= fixes.back().stamp; from += stretch) {
    if (auto fit = stretch_between(drive, fixes, from, from + stretch)) all.push_back(std::move(*fit));
  }
  std::vector<double> late;
  for (const RecordedMeasurement& recorded : drive.measurements)
    late.push_back(recorded.arrival - stamp_of(recorded.measurement));
  noise.latency = quantile(late, 0.5);
  noise.stretches = all.size();
  const std::vector<StretchFit> quiet = quiet_of(all);
  noise.quiet = quiet.size();
  for (const StretchFit& fit : quiet) {
    noise.time += fit.duration;
    noise.way += fit.way;
  }
  noise.fix = fix_noise(quiet);
  if (!noise.fix) return noise;
  const double period = noise.time / static_cast<double>(quiet.size() * quiet.front().residuals.size());
  const double factor = inflation(*noise.fix, period);
  noise.scale = mean_of(quiet, figure(0, factor));
  noise.gyro_bias = mean_of(quiet, figure(1, factor));
  noise.delay = mean_of(quiet, figure(2, factor));
  if (noise.delay && noise.delay->sigma > kSureDelay) noise.delay.reset();
  const double count = static_cast<double>(quiet.size());
  noise.distance_noise = walk_of(quiet, figure(0, factor), noise.way / count);
  noise.yaw_noise = walk_of(quiet, figure(1, factor), noise.time / count);
  return noise;
}

}  // namespace multipath_localization
