#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "multipath_localization/localization/localizer.hpp"

namespace multipath_localization {

/// Follows the odometry exactly, accepts every fix, and remembers what it was told.
class Recorder : public Estimator {
 public:
  void start(const std::optional<PosePrior>& prior) override {
    ++starts;
    estimate_.pose = prior ? prior->pose : Pose2{};
    increments.clear();
    innovations.clear();
  }

  void predict(const OdometryIncrement& u) override {
    increments.push_back(u);
    estimate_.pose = estimate_.pose * displacement(u);
    estimate_.stamp = u.stamp;
  }

  Innovation update(const Measurement& z) override {
    Innovation innovation;
    innovation.reason = verdict;
    innovation.covariance = 2.0 * Eigen::Matrix2d::Identity();
    if (!std::holds_alternative<GnssFix>(z)) return innovation;
    const auto& fix = std::get<GnssFix>(z);
    innovation.innovation = fix.position - estimate_.pose * fix.antenna_in_base;
    innovations.push_back(innovation.innovation);
    covariances.push_back(fix.covariance);
    used_at.push_back(estimate_.stamp);
    return innovation;
  }

  [[nodiscard]] PoseEstimate estimate() const override { return estimate_; }
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override { return {}; }

  PoseEstimate estimate_;
  Reason verdict = Reason::kAccepted;
  int starts = 0;
  std::vector<OdometryIncrement> increments;
  std::vector<Eigen::Vector2d> innovations;
  std::vector<Eigen::Matrix2d> covariances;
  std::vector<double> used_at;
};

class LocalizerTest : public testing::Test {
 protected:
  static constexpr double kStep = 0.1;  ///< [s]
  static inline const Eigen::Vector2d kAntenna{0.5, 0.2};

  LocalizerTest() { make(LocalizerParameters{}); }

  void make(const LocalizerParameters& parameters) {
    auto made = std::make_unique<Recorder>();
    recorder = made.get();
    localizer = std::make_unique<Localizer>(std::move(made), parameters);
    localizer->start(std::nullopt);
  }

  /// Drives for a while in steps of kStep.
  void drive(double duration, double speed = 1.0, double yaw_rate = 0.0) {
    const double end = now + duration;
    while (now < end - 1e-9) {
      const OdometryIncrement u{now + kStep, kStep, speed, yaw_rate};
      now += kStep;
      path.push_back(u);
      localizer->add(u);
    }
  }

  /// Where the base truly was, by the odometry so far.
  [[nodiscard]] Pose2 base_in_map(double stamp) const {
    Pose2 pose;
    for (OdometryIncrement u : path) {
      const double start = u.stamp - u.duration;
      if (start >= stamp) break;
      u.duration = std::min(u.duration, stamp - start);
      pose = pose * displacement(u);
    }
    return pose;
  }

  /// A faultless fix as it is measured at `stamp`.
  [[nodiscard]] GnssFix fix_at(double stamp) const {
    GnssFix fix;
    fix.stamp = stamp;
    fix.antenna_in_base = kAntenna;
    fix.position = base_in_map(stamp) * kAntenna;
    return fix;
  }

  /// The one report there is.
  Reason reason_of(double stamp) {
    localizer->take_reports();
    localizer->add(Measurement(fix_at(stamp)));
    const auto reports = localizer->take_reports();
    EXPECT_EQ(reports.size(), 1U);
    return reports.empty() ? Reason::kUnused : reports[0].innovation.reason;
  }

  Recorder* recorder = nullptr;
  std::unique_ptr<Localizer> localizer;
  std::vector<OdometryIncrement> path;
  double now = 10.0;
};

}  // namespace multipath_localization
