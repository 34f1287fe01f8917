#pragma once

#include <Eigen/Core>
#include <array>

#include "estimators/pseudorange_mixture/belief.hpp"
#include "estimators/pseudorange_mixture/motion_law.hpp"
#include "estimators/pseudorange_mixture/satellite_slots.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

/// How the unknowns behind a pseudorange change with time.
struct ReceiverStateNoise {
  double position_walk = 0.05;
  double up_walk = 0.05;
  double clock_walk = 0.2;
  double drift_walk = 0.03;
  double offset_sigma = 15.0;
  double bias_sigma = 4.5;
  double bias_time = 1000.0;

  void fields(ParameterVisitor& field);
};

/// A row of the observation matrix: zero but in a few places.
class SparseRow {
 public:
  void set(int state, double value) {
    states_[static_cast<std::size_t>(size_)] = state;
    values_[static_cast<std::size_t>(size_)] = value;
    ++size_;
  }
  template <class Column>
  [[nodiscard]] double dot(const Column& x) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) sum += values_[i] * x(states_[i]);
    return sum;
  }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] int state(int i) const { return states_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double value(int i) const { return values_[static_cast<std::size_t>(i)]; }

 private:
  static constexpr std::size_t kMost = 9;
  std::array<int, kMost> states_{};
  std::array<double, kMost> values_{};
  int size_ = 0;
};

/// Gaussian over what pseudoranges and odometry depend on: x, y [m] and yaw [rad] of the base in map, speed
/// scale [1] and gyro bias [rad/s] of the odometry, height of the antenna in map [m], receiver clock against
/// GPS time [m] and its drift [m/s], the velocity in map that the odometry does not see, east and north
/// [m/s], what the ionosphere delays at the zenith beyond what the ranges are corrected by [m], and one
/// number in metres for each slot: the slowly varying bias of a satellite in line of sight, or the offset of
/// another constellation's clock. Storage is of fixed size.
struct PseudorangeBelief {
  enum State : int { kUp = kPlanarSize, kClock, kDrift, kVelocityEast, kVelocityNorth, kZenithDelay, kFixed };
  static constexpr int kMaxSize = kFixed + SatelliteSlots::kCapacity;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxSize, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxSize, kMaxSize>;

  Vector mean = Vector::Zero(kFixed);
  Matrix covariance = Matrix::Zero(kFixed, kFixed);

  [[nodiscard]] Pose2 pose() const { return {mean(kX), mean(kY), mean(kYaw)}; }
  [[nodiscard]] static int state_of(int slot) { return kFixed + slot; }

  /// The part that odometry moves.
  [[nodiscard]] Belief planar() const;

  /// One more slot at the end: zero, of this variance.
  void append(double variance);
  /// Without a slot; the last one moves into its place.
  void remove(int slot);

  /// Moves on by the odometry summed up since the last call, and by the unseen velocity as the law has it.
  void propagate(const PreintegratedOdometry& odometry, const MotionLaw& law,
                 const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise,
                 const SatelliteSlots& slots);

  /// P H' of size n x 1.
  [[nodiscard]] Vector covariance_with(const SparseRow& H) const;
  /// Corrects by one number: `innovation` z - h(x) with variance S of it, PHt = P H'.
  void correct(const Vector& PHt, double S, double innovation);

  /// Forgets one state: this value and variance, uncorrelated with the rest.
  void renew(int state, double value, double variance);

 private:
  /// The unseen velocity moves the position over `dt` [s] and decays, an Ornstein-Uhlenbeck process.
  void slip(double dt, const MotionLaw& law);
  /// The unseen velocity ends with that of the wheels, which stand for `dt` [s].
  void settle(double dt);
  /// Biases decay, offsets walk.
  void change_slots(double dt, const ReceiverStateNoise& noise, const SatelliteSlots& slots);
  /// Q of the fixed states; R turns from the base at the start of the sum to map.
  void add_noise(const PreintegratedOdometry& odometry, const Eigen::Matrix2d& R,
                 const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise);
};

}  // namespace multipath_localization
