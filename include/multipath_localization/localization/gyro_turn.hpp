#pragma once

#include <deque>
#include <optional>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What becomes of a gyro.
enum class GyroStanding {
  kAbsent,    ///< it has said nothing yet
  kUsed,      ///< turns are its
  kSilent,    ///< it says nothing, or what it says comes too late
  kFrozen,    ///< it says the same to the bit while the wheels turn otherwise
  kReversed,  ///< it turns the other way round than the wheels
  kTooLarge,  ///< it turns several times as far as the wheels, as one that counts in degrees
};

/// A sentence on it: "yaw rate is used".
const char* to_string(GyroStanding standing);

/// Gives increments of odometry the turn that a gyro has measured, wherever it has: its rate integrated over
/// the interval, linear between two samples. Where it is silent, or contradicts the wheels, they keep the
/// turn of the wheels.
///
/// Wheels that skid see turns that are none, so that a gyro that turns less than they do is believed; one
/// that turns against them is not, nor one that turns several times as far, until they agree again. Wheels
/// that see no turns at all contradict nothing. What a frozen gyro missed until that was seen is made good.
class GyroTurn {
 public:
  /// Takes a sample. One that is not finite is left out, as is one that is not later than the last, unless it
  /// goes back by over a second: then the clock has, and what was before is forgotten.
  void add(const YawRate& sample);

  /// The increment, settled by Standstill, with the gyro's turn where that counts; increments in order. Of a
  /// base `at_rest` the gyro tells its bias, `rate_at_rest`, unless it says that the base is being turned.
  OdometryIncrement with_turn(const OdometryIncrement& wheels, bool at_rest);

  [[nodiscard]] GyroStanding standing() const;
  /// Samples a second, 0 before the second one [Hz].
  [[nodiscard]] double frequency() const { return interval_ > 0.0 ? 1.0 / interval_ : 0.0; }

 private:
  struct Node {
    YawRate sample;
    double turn = 0.0;  ///< since the first sample [rad]
  };
  /// What gyro and wheels turned within the same pieces of time: sums of products [rad^2].
  struct Products {
    double gyro = 0.0;
    double wheels = 0.0;
    double both = 0.0;
  };

  /// How far samples may lie from an instant and still tell of it [s].
  [[nodiscard]] double reach() const;
  /// Turn since the first sample up to then [rad]; nothing where samples do not reach it.
  [[nodiscard]] std::optional<double> turn_until(double stamp) const;
  /// The gyro's over the increment [rad].
  std::optional<double> turn_over(const OdometryIncrement& u);
  void compare(const OdometryIncrement& wheels, double turn);
  void judge();
  /// For how long the latest samples have been the same [s].
  [[nodiscard]] double equal_for() const;

  std::deque<Node> samples_;
  double interval_ = 0.0;     ///< between samples, smoothed [s]
  double last_change_ = 0.0;  ///< stamp of the first of the samples that are equal now [s]
  double missed_turn_ = 0.0;  ///< of the wheels beyond the gyro since then [rad]
  bool frozen_ = false;
  std::optional<double> given_;  ///< turn that the increments so far were given, up to the end of the last
  double given_until_ = 0.0;     ///< [s]
  double piece_time_ = 0.0;      ///< of the piece that is being summed up [s]
  double piece_gyro_ = 0.0;      ///< [rad]
  double piece_wheels_ = 0.0;    ///< [rad]
  Products products_;
  GyroStanding verdict_ = GyroStanding::kUsed;  ///< of the comparison with the wheels
  bool covers_ = false;                         ///< the last increment
};

}  // namespace multipath_localization
