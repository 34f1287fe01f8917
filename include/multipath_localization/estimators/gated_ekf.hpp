#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/estimators/fix_check.hpp"
#include "multipath_localization/filters/kalman.hpp"
#include "multipath_localization/models/gnss_position.hpp"
#include "multipath_localization/models/preintegrated_odometry.hpp"

namespace multipath_localization {

struct GatedEkfParameters {
  double gate = 11.83;
  double reopen_after = 5.0;
  double reopen_yaw_sigma = 0.1;
  double alignment_distance = 5.0;
  double alignment_yaw_sigma = 0.3;
  DeclaredCovarianceParameters declared;
  OdometryNoise odometry;

  void fields(ParameterVisitor& field);
};

/// Extended Kalman filter over x, y, yaw, the odometer's speed scale and its gyro bias, with a chi-square
/// gate on the normalised innovation squared. The gate has a way back: fixes rejected for `reopen_after`
/// seconds on end open it.
///
/// Started without a prior, or with a heading of more than 1 rad standard deviation, it first follows the
/// fixes; the heading comes from turning the chord of the odometry on to the chord of the fixes, which is
/// valid in reverse as well. Until then the estimate is not aligned.
class GatedEkf : public Estimator {
 public:
  /// Draws no random numbers: the seed is not used.
  explicit GatedEkf(const GatedEkfParameters& parameters, std::uint64_t seed = 0);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  Innovation update(const Measurement& z) override;
  [[nodiscard]] PoseEstimate estimate() const override;
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  enum State : int { kX, kY, kYaw, kScale, kGyroBias, kStates };
  enum class Phase { kWaiting, kFollowing, kTracking };

  /// Where the chords of odometry and fixes begin.
  struct Anchor {
    Eigen::Vector2d antenna_in_odom;
    Eigen::Vector2d antenna_in_map;
    Eigen::Matrix2d covariance;  ///< of antenna_in_map
    double stamp;
  };

  [[nodiscard]] Pose2 pose() const;
  void set_odometer_errors_unknown();
  void follow(const GnssFix& fix, const Eigen::Matrix2d& R);
  void try_to_align(const GnssFix& fix, const Eigen::Matrix2d& R);
  void align(const GnssFix& fix, const Eigen::Matrix2d& R, double yaw);
  Innovation track(const GnssFix& fix, const Eigen::Matrix2d& R);
  [[nodiscard]] bool reopens();

  GatedEkfParameters parameters_;
  FixCheck fix_check_;
  Phase phase_ = Phase::kWaiting;
  Gaussian<kStates> belief_;
  double now_ = 0.0;
  Pose2 base_in_odom_;
  std::optional<Anchor> anchor_;
  std::optional<double> rejecting_since_;
};

}  // namespace multipath_localization
