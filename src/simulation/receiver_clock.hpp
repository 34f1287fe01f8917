#pragma once

#include <cstdint>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

struct ReceiverClockParameters {
  double drift_sigma = 50.0;
  double drift_walk = 0.1;
  double steer = 1e-3;

  void fields(ParameterVisitor& field);
};

/// The clock of a GNSS receiver: a quartz that runs free and is put back by a whole step when it has strayed
/// too far.
class ReceiverClock {
 public:
  ReceiverClock(const ReceiverClockParameters& parameters, std::uint64_t seed);

  void step(double duration);  ///< moves on [s]

  [[nodiscard]] double bias() const { return bias_; }    ///< what it adds to a pseudorange [m]
  [[nodiscard]] double drift() const { return drift_; }  ///< what it adds to a range rate [m/s]

 private:
  ReceiverClockParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  double bias_ = 0.0;
  double drift_ = 0.0;
};

}  // namespace multipath_localization
