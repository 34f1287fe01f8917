#pragma once

#include <vector>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// How the errors of a fix behave in one kind of place, for one kind of receiver, and how the robot moves
/// apart from its odometry.
///
/// The fix is position + bias + white noise. The bias is a Gauss-Markov process that switches between two
/// modes: `open` (small, of receiver and atmosphere) and `shadow` (large, of reflected and diffracted
/// signals), the time-varying mean of Eq. (10) of [NIS]. The white noise switches between quiet and noisy.
struct ReceiverClass {
  double prior = 0.0;
  double entry_rate = 1e-6;
  bool always_shadow = false;
  double quiet_sigma = 0.3;
  double noisy_sigma = 1.0;
  double open_bias_sigma = 0.3;
  double open_bias_time = 20.0;
  double shadow_bias_sigma = 5.0;
  double shadow_bias_time = 60.0;
  double shadow_bias_walk = 0.22;
  double shadow_entry_sigma = 3.0;
  double shadow_entry_rate = 0.02;
  double shadow_exit_rate = 0.05;
  double shadow_at_start = 0.3;
  double open_noisy_entry_rate = 0.001;
  double open_noisy_exit_rate = 3.0;
  double shadow_noisy_entry_rate = 0.05;
  double shadow_noisy_exit_rate = 0.05;
  double slip_rate = 0.005;
  double outlier_probability = 0.01;
  double outlier_sigma = 15.0;
  double jump_rate = 0.05;
  double unseen_motion = 0.0;
  double yaw_walk = 0.0;

  /// Variance of the white noise an axis [m^2].
  [[nodiscard]] double noise_variance(bool noisy) const;
  void fields(ParameterVisitor& field);
};

/// The classes the default filter samples from.
struct ReceiverClasses {
  ReceiverClass street;
  ReceiverClass canyon;
  ReceiverClass noisy;
  ReceiverClass drifting;
  ReceiverClass wheel_fault;

  ReceiverClasses();
  void fields(ParameterVisitor& field);
  [[nodiscard]] const ReceiverClass& operator[](std::size_t index) const;
};

inline constexpr std::size_t kReceiverClassCount = 5;
inline constexpr std::size_t kCanyon = 1;
inline constexpr std::size_t kWheelFault = 4;

}  // namespace multipath_localization
