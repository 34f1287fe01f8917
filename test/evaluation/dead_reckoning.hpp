#pragma once

#include <vector>

#include "multipath_localization/estimators/estimator.hpp"

namespace multipath_localization {

/// The simplest estimator: starts at its prior or at the first fix, then integrates odometry. Keeps a log.
class DeadReckoning : public Estimator {
 public:
  struct Log {
    std::vector<double> predicted;  ///< stamps of increments
    std::vector<double> updated;    ///< stamps of fixes, in the order of their use
  };

  explicit DeadReckoning(Log* log = nullptr) : log_(log) {}

  void start(const std::optional<PosePrior>& prior) override {
    estimate_ = {};
    if (prior) settle(prior->pose);
  }

  void predict(const OdometryIncrement& u) override {
    estimate_.pose = estimate_.pose * displacement(u);
    estimate_.stamp = u.stamp;
    if (log_ != nullptr) log_->predicted.push_back(u.stamp);
  }

  Innovation update(const Measurement& z) override {
    const auto& fix = std::get<GnssFix>(z);
    if (log_ != nullptr) log_->updated.push_back(fix.stamp);
    if (!estimate_.valid) settle({fix.position.x(), fix.position.y(), 0.0});
    return refused(Reason::kAccepted);
  }

  [[nodiscard]] PoseEstimate estimate() const override { return estimate_; }
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override { return {}; }

 private:
  void settle(const Pose2& pose) {
    estimate_.valid = estimate_.aligned = true;
    estimate_.pose = pose;
  }

  PoseEstimate estimate_;
  Log* log_;
};

}  // namespace multipath_localization
