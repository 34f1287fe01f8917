#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

/// A robot on a winding road: odometry at 20 Hz with constant and random errors as `OdometryNoise` has them,
/// fixes at 5 Hz of truth + bias + white noise, delivered late by `latency`.
class SimulatedDrive {
 public:
  explicit SimulatedDrive(std::uint64_t seed) : seed_(seed) {
    RandomStream random(seed_, 0, 0);
    errors = {noise_.scale_sigma * random.normal(), noise_.gyro_bias_sigma * random.normal()};
  }

  Pose2 truth{5.0, -3.0, 2.0};
  OdometerErrors errors;
  Eigen::Vector2d antenna = Eigen::Vector2d::Zero();
  double fix_sigma = 0.3;
  FixStatus status = FixStatus::kSingle;
  double speed = 2.0;
  double lateral_speed = 0.0;  ///< beside it [m/s]
  double bend = 0.3;           ///< largest yaw rate [rad/s]
  double latency = 0.0;        ///< [s]
  double time = 0.0;
  std::function<Eigen::Vector2d(double)> bias = [](double) { return Eigen::Vector2d(0.0, 0.0); };
  /// What becomes of the odometry on its way.
  std::function<OdometryIncrement(const OdometryIncrement&)> spoilt = [](const OdometryIncrement& u) {
    return u;
  };
  bool receiving = true;

  /// Drives on for `duration`, calling `observe` after each fix has been made (and delivered, if not late).
  void run(
      Localizer& localizer, double duration, const std::function<void()>& observe = [] {}) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 0; i < steps; ++i) {
      localizer.add(spoilt(drive()));
      if (step_ % kStepsPerFix == 0 && receiving) underway_.push_back(fix());
      while (!underway_.empty() && underway_.front().stamp + latency < time + 1e-9) {
        localizer.add(Measurement(underway_.front()));
        underway_.pop_front();
      }
      if (step_ % kStepsPerFix == 0) observe();
    }
  }

  /// The same with fixes for `before`, without any for `outage` and with them for `after` [s].
  void run_through_outage(Localizer& localizer, double before, double outage, double after) {
    run(localizer, before);
    receiving = false;
    run(localizer, outage);
    receiving = true;
    run(localizer, after);
  }

  /// What the receiver says now.
  [[nodiscard]] GnssFix fix() const {
    RandomStream random(seed_, step_, 2);
    GnssFix fix;
    fix.stamp = time;
    const double east = random.normal();
    fix.position = truth * antenna + bias(time) + fix_sigma * Eigen::Vector2d(east, random.normal());
    fix.covariance = fix_sigma * fix_sigma * Eigen::Matrix2d::Identity();
    fix.antenna_in_base = antenna;
    fix.status = status;
    return fix;
  }

 private:
  static constexpr double kStep = 0.05;
  static constexpr std::uint32_t kStepsPerFix = 4;

  OdometryIncrement drive() {
    RandomStream random(seed_, ++step_, 1);
    time = kStep * step_;
    if (speed == 0.0 && lateral_speed == 0.0) return {time, kStep, 0.0, errors.gyro_bias};
    const OdometryIncrement measured{time, kStep, speed, bend * std::sin(0.2 * time), lateral_speed};
    const double along = noise_.distance * std::sqrt(std::abs(speed) * kStep) * random.normal();
    truth =
        moved(truth, measured, errors) * Pose2{along, 0.0, noise_.yaw * std::sqrt(kStep) * random.normal()};
    return measured;
  }

  OdometryNoise noise_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  std::deque<GnssFix> underway_;
};

/// A bias that wanders about zero: first-order Gauss-Markov, as a function of time asked for in order.
class WanderingBias {
 public:
  WanderingBias(double sigma, double correlation_time, std::uint64_t seed)
      : sigma_(sigma), correlation_time_(correlation_time), random_(seed, 0, 9) {
    bias_ = draw();
  }

  Eigen::Vector2d operator()(double time) {
    const double factor = std::exp(-(time - time_) / correlation_time_);
    if (time > time_) bias_ = factor * bias_ + std::sqrt(1.0 - factor * factor) * draw();
    time_ = time;
    return bias_;
  }

 private:
  Eigen::Vector2d draw() {
    const double east = random_.normal();
    return sigma_ * Eigen::Vector2d(east, random_.normal());
  }

  double sigma_;
  double correlation_time_;
  RandomStream random_;
  double time_ = 0.0;
  Eigen::Vector2d bias_;
};

inline Eigen::Vector2d position_error(const PoseEstimate& estimate, const Pose2& truth) {
  return estimate.pose.position() - truth.position();
}

/// All numbers of an estimate: two that are equal here are equal to the byte.
inline std::vector<double> numbers_of(const PoseEstimate& e) {
  std::vector<double> all = {e.valid ? 1.0 : 0.0,
                             e.aligned ? 1.0 : 0.0,
                             e.stamp,
                             e.pose.x,
                             e.pose.y,
                             e.pose.yaw,
                             e.dominance,
                             e.shadow_probability,
                             e.bias.x(),
                             e.bias.y(),
                             e.effective_sample_size};
  const auto append = [&](const auto& matrix) {
    all.insert(all.end(), matrix.data(), matrix.data() + matrix.size());
  };
  append(e.covariance);
  append(e.position_covariance_overall);
  append(e.bias_covariance);
  return all;
}

/// Squared error of position over its stated covariance: 2 degrees of freedom.
inline double nees(const PoseEstimate& estimate, const Pose2& truth) {
  const Eigen::Vector2d error = position_error(estimate, truth);
  return error.dot(estimate.covariance.topLeftCorner<2, 2>().inverse() * error);
}

inline bool all_finite(const PoseEstimate& estimate) {
  const std::vector<double> numbers = numbers_of(estimate);
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// Root of the mean square error of position.
class RootMeanSquare {
 public:
  void add(const Eigen::Vector2d& error) { sum_ += error.squaredNorm(), ++count_; }
  [[nodiscard]] double value() const { return std::sqrt(sum_ / count_); }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

}  // namespace multipath_localization
