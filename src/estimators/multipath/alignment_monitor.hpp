#pragma once

namespace multipath_localization::multipath {

/// Tells whether heading and position are settled: the heading is known, and fixes agreed with the odometry
/// over some metres of driving. Once they are they stay so until the heading is lost.
class AlignmentMonitor {
 public:
  /// Starts at a pose that counts as confirmed, or at none or a doubtful one.
  explicit AlignmentMonitor(bool confirmed);

  /// Fixes were weighed over a way of `way` [m]; the heading has that variance [rad^2] now, and velocities
  /// of a receiver or headings have told it or not.
  void update(double way, double yaw_variance, bool told);

  [[nodiscard]] bool aligned() const { return aligned_; }
  /// Driving that is wanted at least until then [m].
  [[nodiscard]] double way_left() const;

 private:
  double way_ = 0.0;  ///< over which fixes were weighed [m]
  double wanted_;     ///< of that [m]
  bool aligned_;
};

}  // namespace multipath_localization::multipath
