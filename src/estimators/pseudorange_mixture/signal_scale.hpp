#pragma once

#include <array>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What C/N0 a receiver usually has. Antennas and receivers differ by ten decibels and more, so that a C/N0
/// says only against that whether a signal is strong.
class SignalScale {
 public:
  /// The satellites of one more epoch, that stands for `duration` [s].
  void add(const std::vector<SatelliteObservation>& observations, double duration);

  /// C/N0 that one signal in ten exceeds, of all seen, old ones forgotten over some minutes [dB-Hz]: those in
  /// line of sight, whatever the street hides. NaN before there is any.
  [[nodiscard]] double strong() const;

 private:
  static constexpr std::size_t kBins = 64;  // of a decibel each: receivers tell 0..63 dB-Hz
  std::array<double, kBins> seen_{};        ///< time by C/N0 [s]
};

}  // namespace multipath_localization
