#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/ekf/chord_alignment.hpp"
#include "estimators/ekf/odometry_state.hpp"
#include "estimators/ekf/rejection_streak.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/filters/kalman.hpp"
#include "multipath_localization/models/fix/gnss_position.hpp"

namespace multipath_localization {

struct GatedEkfParameters {
  double gate = 11.83;
  double reopen_after = 5.0;
  double reopen_yaw_sigma = 0.1;
  ChordAlignmentParameters alignment;
  DeclaredCovarianceParameters declared;
  OdometryNoise odometry;

  void fields(ParameterVisitor& field);
};

/// Extended Kalman filter over x, y, yaw, the odometer's speed scale and its gyro bias, with a chi-square
/// gate on the normalised innovation squared. The gate has a way back: fixes rejected for `reopen_after`
/// seconds on end open it.
///
/// Started without a prior, or with a heading of more than 1 rad standard deviation, it first follows the
/// fixes until a ChordAlignment has found the heading. Until then the estimate is not aligned.
class GatedEkf : public Estimator {
 public:
  /// Draws no random numbers: the seed is not used.
  explicit GatedEkf(const GatedEkfParameters& parameters, std::uint64_t seed = 0);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  Innovation update(const Measurement& z) override;
  void tune(ParameterVisitor& field) override { parameters_.fields(field); }
  [[nodiscard]] PoseEstimate estimate() const override;
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  [[nodiscard]] const ChordAlignment::State& belief() const;
  Innovation track(const GnssFix& fix, const Eigen::Matrix2d& R);

  GatedEkfParameters parameters_;
  FixCheck fix_check_;
  ChordAlignment alignment_;
  std::optional<ChordAlignment::State> tracked_;  ///< once aligned
  double now_ = 0.0;
  RejectionStreak rejections_;
};

}  // namespace multipath_localization
