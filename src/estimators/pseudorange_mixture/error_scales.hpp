#pragma once

namespace multipath_localization {

/// How large the errors of this receiver under this sky are against those of the parameters, learnt.
struct ErrorScales {
  double range = 1.0;  ///< of ranges
  double rate = 1.0;   ///< of range rates
  double bias = 1.0;   ///< of satellites' biases in line of sight

  /// Of one more range or range rate: `sigmas` off of what was expected, `weight` of being direct.
  void learn_range(double sigmas, double weight);
  void learn_rate(double sigmas, double weight);
  /// Of `duration` [s] with biases of this mean square, a satellite each, over that of the parameters.
  void learn_bias(double sum_of_squares, double satellites, double duration);
  /// Becomes a mixture with others of this `share`.
  void mix(const ErrorScales& other, double share);
};

}  // namespace multipath_localization
