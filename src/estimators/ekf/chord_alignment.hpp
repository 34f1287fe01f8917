#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimators/ekf/odometry_state.hpp"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/filters/kalman.hpp"

namespace multipath_localization {

struct ChordAlignmentParameters {
  double alignment_distance = 5.0;
  double alignment_yaw_sigma = 0.3;

  void fields(ParameterVisitor& field);
};

/// Finds the heading that a Kalman filter of fixes and odometry starts with. Until then the position is that
/// of the fixes; the heading comes from turning the chord of the odometry on to the chord of the fixes, which
/// is valid in reverse as well.
class ChordAlignment {
 public:
  using State = Gaussian<odometry_state::kSize>;

  ChordAlignment(const ChordAlignmentParameters& parameters, const OdometryNoise& noise);

  /// Forgets everything and starts at the prior, or, without a usable one, with everything unknown. A prior
  /// with a heading of more than 1 rad standard deviation counts for its position only.
  void start(const std::optional<PosePrior>& prior);

  /// Carries on by a usable increment, while not aligned.
  void predict(const OdometryIncrement& u);

  /// Takes a sound fix with its covariance R (2x2). The innovation is zero for the first one.
  Innovation update(const GnssFix& fix, const Eigen::Matrix2d& R);

  [[nodiscard]] bool started() const { return started_; }  ///< whether there is a position
  [[nodiscard]] bool aligned() const { return aligned_; }  ///< whether there is a heading too
  /// What the chord is short of, at least [m].
  [[nodiscard]] double missing() const { return aligned_ ? 0.0 : missing_; }
  [[nodiscard]] const State& state() const { return state_; }

 private:
  /// Where the chords of odometry and fixes begin.
  struct Anchor {
    Eigen::Vector2d antenna_in_odom;
    Eigen::Vector2d antenna_in_map;
    Eigen::Matrix2d covariance;  ///< of antenna_in_map
    double moving_time;          ///< until then [s]
  };

  [[nodiscard]] Pose2 pose() const { return odometry_state::pose(state_.mean); }
  void follow(const GnssFix& fix, const Eigen::Matrix2d& R);
  void try_to_align(const GnssFix& fix, const Eigen::Matrix2d& R);
  void align(const GnssFix& fix, const Eigen::Matrix2d& R, double yaw);

  ChordAlignmentParameters parameters_;
  OdometryNoise noise_;
  State state_;
  bool started_ = false;
  bool aligned_ = false;
  double moving_time_ = 0.0;  ///< since the start, standstill left out [s]
  Pose2 base_in_odom_;
  std::optional<Anchor> anchor_;
  double missing_ = 0.0;  ///< of the chord [m], less than 0 where it is long enough
};

}  // namespace multipath_localization
