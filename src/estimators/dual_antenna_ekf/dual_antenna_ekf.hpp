#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/ekf/rejection_streak.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/filters/kalman.hpp"
#include "multipath_localization/models/fix/dual_antenna.hpp"
#include "multipath_localization/models/fix/gnss_position.hpp"

namespace multipath_localization {

/// Whose covariance a pair of fixes has, as `pose_covariance` says.
enum class PoseCovariance { kDeclared, kMeasured };

struct DualAntennaEkfParameters {
  double wheel_separation = 0.35;
  double wheel_noise = 0.1;
  double wheel_noise_at_rest = 0.002;
  double noise_period = 0.01;
  bool heading_jacobian = true;
  bool wrap_innovation = true;
  bool subtract_mean = false;
  PoseCovariance pose_covariance = PoseCovariance::kDeclared;
  PoseErrorParameters pose_error;
  double gate = 100.0;
  double fix_gate = 100.0;
  double baseline_gate = 9.0;
  double baseline_tolerance = 0.02;
  double reopen_after = 5.0;
  double reopen_yaw_sigma = 0.1;
  double alignment_yaw_sigma = 0.3;
  DeclaredCovarianceParameters declared{0.004, 50.0, 0.02};

  void fields(ParameterVisitor& field);
};

/// The Kalman filter of [KAM], Eqs. (1)-(10): the pose x = (x, y, theta) of a differential-drive robot is
/// predicted by its wheel speeds and corrected by the poses that pairs of RTK fixes tell, at rest as well as
/// in motion.
///
/// Departs, each an option: F holds the derivative of the position to the heading, where Eq. (3) prints the
/// identity; the heading's innovation is wrapped; the mean of Eq. (11) may be taken off. Departs besides: Q
/// lives in wheel speeds and is mapped into the state, where Eq. (4) adds 2x2 to 3x3; wheels at rest have a
/// noise of their own; pairs pass a gate and a check of their baseline.
///
/// A single fix corrects the position, for when one of two antennas is lost; the heading, once known, goes on
/// by the odometry and by what the motion shows of it. Neither gate locks out: what is rejected for
/// `reopen_after` seconds on end is then taken. A wrong baseline is refused as long as it lasts.
class DualAntennaEkf : public Estimator {
 public:
  /// Throws ParameterError when the error of poses is none. Draws no random numbers: the seed is not used.
  explicit DualAntennaEkf(const DualAntennaEkfParameters& parameters, std::uint64_t seed = 0);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  [[nodiscard]] bool uses(std::size_t kind) const override { return kind == kFixKind || kind == kDualKind; }
  Innovation update(const Measurement& z) override;
  [[nodiscard]] PoseEstimate estimate() const override;
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  enum State : int { kX, kY, kYaw, kStates };
  enum class Phase { kWaiting, kFollowing, kTracking };

  [[nodiscard]] Pose2 pose() const;
  Innovation take(const DualAntennaFix& fixes);
  Innovation take(const GnssFix& fix);
  [[nodiscard]] std::optional<Reason> defect(const DualAntennaFix& fixes);
  void follow(const GnssFix& fix);
  void align(const DualAntennaPose& told);
  Innovation track(const DualAntennaPose& told);
  Innovation track(const GnssFix& fix);
  template <int M>
  Innovation correct(const Eigen::Matrix<double, M, 1>& y, const Eigen::Matrix<double, M, kStates>& H,
                     const Eigen::Matrix<double, M, M>& R, double gate, RejectionStreak& rejections);

  DualAntennaEkfParameters parameters_;
  PoseError pose_error_;
  Eigen::Vector3d mean_error_;  ///< what is taken off poses
  FixCheck left_check_;
  FixCheck right_check_;
  FixCheck single_check_;
  Phase phase_ = Phase::kWaiting;
  Gaussian<kStates> belief_;
  double now_ = 0.0;
  RejectionStreak rejected_pairs_;
  RejectionStreak rejected_fixes_;  ///< single ones
};

}  // namespace multipath_localization
