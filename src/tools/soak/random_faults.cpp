#include "tools/soak/random_faults.hpp"

#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

namespace {

constexpr double kHour = 3600.0;  ///< [s]
constexpr double kTimesAnHour = 3.0;
constexpr double kLongest = 180.0;     ///< of a fault [s]
constexpr double kLongestSlip = 5.0;   ///< [s]
constexpr double kLargestBias = 15.0;  ///< [m]
constexpr double kWalkIn = 60.0;       ///< of a bias, at most [s]
constexpr double kLargestDelay = 1.0;  ///< [s]

/// Throws dice for intervals, kind after kind.
class Dice {
 public:
  Dice(double hours, std::uint64_t seed) : hours_(hours), random_(seed, 0, 0) {}

  double uniform() { return random_.uniform(); }

  /// As many of a kind as there are to be, each anywhere and up to `longest` [s] long.
  template <class Fault>
  std::vector<Fault> throw_all(double longest) {
    std::vector<Fault> faults(static_cast<std::size_t>(std::ceil(kTimesAnHour * hours_)));
    for (Fault& fault : faults) {
      fault.start = kHour * hours_ * uniform();
      fault.duration = longest * uniform();
    }
    return faults;
  }

 private:
  double hours_;
  RandomStream random_;
};

}  // namespace

FaultParameters random_faults(double hours, std::uint64_t seed) {
  Dice dice(hours, seed);
  FaultParameters faults;
  faults.fix.biases = dice.throw_all<BiasFault>(kLongest);
  for (BiasFault& bias : faults.fix.biases) {
    const double length = kLargestBias * dice.uniform();
    const double direction = 2.0 * kPi * dice.uniform();
    bias.east = length * std::cos(direction);
    bias.north = length * std::sin(direction);
    bias.walk_in = kWalkIn * dice.uniform();
  }
  faults.fix.noises = dice.throw_all<NoiseFault>(kLongest);
  faults.fix.spikes = dice.throw_all<SpikeFault>(kLongest);
  faults.fix.outages = dice.throw_all<FaultInterval>(kLongest);
  faults.fix.freezes = dice.throw_all<FaultInterval>(kLongest);
  faults.fix.delays = dice.throw_all<DelayFault>(kLongest);
  for (DelayFault& delay : faults.fix.delays) delay.delay = kLargestDelay * dice.uniform();
  faults.fix.covariances = dice.throw_all<CovarianceFault>(kLongest);
  faults.fix.statuses = dice.throw_all<StatusFault>(kLongest);
  faults.fix.losses = dice.throw_all<ChanceFault>(kLongest);
  faults.fix.duplicates = dice.throw_all<ChanceFault>(kLongest);
  faults.fix.swaps = dice.throw_all<ChanceFault>(kLongest);
  faults.odometry.slips = dice.throw_all<SlipParameters>(kLongestSlip);
  faults.odometry.dead_encoders = dice.throw_all<EncoderFault>(kLongestSlip);
  faults.odometry.losses = dice.throw_all<ChanceFault>(kLongest);
  return faults;
}

}  // namespace multipath_localization
