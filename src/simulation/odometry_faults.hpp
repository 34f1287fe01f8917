#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/fix_faults.hpp"
#include "simulation/odometer.hpp"

namespace multipath_localization {

/// A wheel of a differential drive, or both, that stands still as its encoder has it; the yaw rate is that of
/// the wheels.
struct EncoderFault : FaultInterval {
  std::string wheel = "left";
  double wheel_separation = 0.5;

  void fields(ParameterVisitor& field);
};

/// What goes wrong with wheel odometry. Of several faults of one kind at a time the first counts.
struct OdometryFaultParameters {
  std::vector<SlipParameters> slips;
  std::vector<EncoderFault> dead_encoders;
  std::vector<ChanceFault> losses;

  void fields(ParameterVisitor& field);
};

/// Stands between the odometry and whoever uses it, and spoils it. Times are on the clock of the stamps,
/// of an increment that of its end. Deterministic by seed.
class OdometryFaults {
 public:
  /// The faults' times count from `start`.
  OdometryFaults(const OdometryFaultParameters& parameters, std::uint64_t seed, double start = 0.0)
      : parameters_(parameters), seed_(seed), start_(start) {}

  /// What the encoders make of that motion.
  [[nodiscard]] OdometryIncrement distorted(OdometryIncrement increment) const;

  /// Whether the next message, of that stamp, is lost. Once per message.
  bool next_is_lost(double stamp);

  /// The increment as it comes out: distorted; lost, and then its time belongs to the next one, of which the
  /// speed and yaw rate stand for both, as where messages are read.
  std::optional<OdometryIncrement> spoil(const OdometryIncrement& increment);

  /// A phrase for each fault that is there at `now`.
  [[nodiscard]] std::vector<std::string> active(double now) const;

 private:
  OdometryFaultParameters parameters_;
  std::uint64_t seed_;
  double start_;
  std::uint32_t messages_ = 0;
  double lost_ = 0.0;  ///< time of what was lost since the last that was not [s]
};

}  // namespace multipath_localization
