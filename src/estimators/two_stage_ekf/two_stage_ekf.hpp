#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/ekf/chord_alignment.hpp"
#include "estimators/ekf/odometry_state.hpp"
#include "estimators/two_stage_ekf/unbiased_rival.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/filters/two_stage.hpp"
#include "multipath_localization/models/fix/gnss_position.hpp"

namespace multipath_localization {

/// When the bias is estimated, as `bias_estimated` says.
enum class BiasEstimated { kInFault, kAlways };

/// Where the filters are linearised, as `linearised_at` says.
enum class LinearisedAt { kCorrected, kBiasFree };

/// Decisions about [KIM], most of which it leaves open.
struct TwoStageEkfParameters {
  bool compensate = true;
  BiasEstimated bias_estimated = BiasEstimated::kInFault;
  double fault_threshold = 7.81;
  double bias_sigma = 5.0;
  double bias_walk = 1.5;
  bool bias_bounded = true;
  double recovery_odds = 1000.0;
  double reopen_after = 5.0;
  double reopen_yaw_sigma = 0.3;
  double fix_correlation_time = 2.0;
  LinearisedAt linearised_at = LinearisedAt::kCorrected;
  ChordAlignmentParameters alignment;
  DeclaredCovarianceParameters declared{0.5, 50.0, 3.0};  ///< "30cm-50cm", section 2.1
  OdometryNoise odometry;

  void fields(ParameterVisitor& field);
};

/// Complementary integration of odometry and fixes with bias compensation, [KIM]: odometry drives the state,
/// Eq. (5); a fix corrects it, Eq. (6); and where the normalised innovation squared tells that fixes are
/// faulty, Friedland's second stage estimates their bias (C = I, B = 0) and frees the state of it.
///
/// Departs, each by a parameter that can undo it: the bias is estimated from the detection of a fault until
/// its end, and anew when the detector speaks again; it walks, where [KIM] has it constant and says nothing
/// of when; a fault ends when an UnbiasedRival explains the fixes better; a bias beyond belief widens the
/// pose; the odometer's speed scale and gyro bias are states as well, and with their sigmas and walks 0 there
/// are the three of [KIM]; fixes closer than their errors change count as one. Before there is a heading, a
/// ChordAlignment takes the fixes as they are.
///
/// A robot that does not move learns nothing about bias: its fixes are all off by the same.
class TwoStageEkf : public Estimator {
 public:
  /// Draws no random numbers: the seed is not used.
  explicit TwoStageEkf(const TwoStageEkfParameters& parameters, std::uint64_t seed = 0);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  Innovation update(const Measurement& z) override;
  [[nodiscard]] PoseEstimate estimate() const override;
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  static constexpr int kStates = odometry_state::kSize;
  using State = Gaussian<kStates>;
  using Belief = TwoStage<kStates, 2>;

  /// A fix beside what the bias-free estimate expects of it, to first order about where it is linearised.
  struct Observation {
    Eigen::Vector2d innovation;
    Eigen::Matrix<double, 2, kStates> H;
  };

  [[nodiscard]] odometry_state::Vector linearisation_offset() const;
  [[nodiscard]] Observation observe(const GnssFix& fix) const;
  [[nodiscard]] State state() const;
  void begin_tracking();
  void vary_bias(double distance);
  [[nodiscard]] double share_of_fix() const;
  Innovation track(const GnssFix& fix, const Eigen::Matrix2d& R, double share);
  void begin_fault(double bias_sigma);
  void watch_for_the_end(const GnssFix& fix, const Eigen::Matrix2d& R, double share, double log_likelihood);
  [[nodiscard]] bool reopens();
  void reopen();

  TwoStageEkfParameters parameters_;
  FixCheck fix_check_;
  ChordAlignment alignment_;
  std::optional<Belief> tracked_;       ///< once aligned
  bool faulty_ = false;                 ///< the bias is being estimated
  double bias_sigma_ = 0.0;             ///< of the bias when its estimation began [m]
  std::optional<UnbiasedRival> rival_;  ///< in a fault
  std::optional<double> implausible_since_;
  bool standing_ = true;  ///< the robot, since the last increment
  double now_ = 0.0;
  std::optional<double> last_fix_;  ///< [s]
};

}  // namespace multipath_localization
