#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/delivery_queue.hpp"
#include "simulation/fault_interval.hpp"
#include "simulation/gauss_markov.hpp"
#include "simulation/zone.hpp"

namespace multipath_localization {

struct BiasFault : FaultInterval {
  double east = 5.0;
  double north = 0.0;
  double walk_in = 0.0;

  void fields(ParameterVisitor& field);
  /// Of a fix measured at `time` [m].
  [[nodiscard]] Eigen::Vector2d offset(double time) const;
};

struct NoiseFault : FaultInterval {
  double white_sigma = 0.0;
  double coloured_sigma = 1.0;
  double time_constant = 20.0;

  void fields(ParameterVisitor& field);
};

/// Something that happens to some messages only, by chance.
struct ChanceFault : FaultInterval {
  double share = 0.1;

  void fields(ParameterVisitor& field);
};

struct SpikeFault : ChanceFault {
  double length = 15.0;

  void fields(ParameterVisitor& field);
};

struct DelayFault : FaultInterval {
  double delay = 0.5;
  double jitter = 0.0;

  void fields(ParameterVisitor& field);
};

struct CovarianceFault : FaultInterval {
  double sigma_factor = 0.1;

  void fields(ParameterVisitor& field);
};

struct StatusFault : FaultInterval {
  int status = -1;

  void fields(ParameterVisitor& field);
};

/// What goes wrong with fixes. Of several faults of one kind at a time biases, noises, spikes and delays add
/// up, factors multiply, and of statuses the first counts.
struct FixFaultParameters {
  std::vector<ZoneParameters> zones;
  std::vector<BiasFault> biases;
  std::vector<NoiseFault> noises;
  std::vector<SpikeFault> spikes;
  std::vector<FaultInterval> outages;
  std::vector<FaultInterval> freezes;
  std::vector<DelayFault> delays;
  std::vector<CovarianceFault> covariances;
  std::vector<StatusFault> statuses;
  std::vector<ChanceFault> losses;
  std::vector<ChanceFault> duplicates;
  std::vector<ChanceFault> swaps;

  void fields(ParameterVisitor& field);
};

/// A fix as it comes out. Fixes that went in count from 0.
struct SpoiltFix {
  std::size_t source = 0;  ///< which one it is
  std::size_t shown = 0;   ///< whose position it shows, an earlier one's where the receiver is frozen
  GnssFix fix;
  double arrival = 0.0;  ///< [s]
};

/// Stands between a receiver and whoever uses it, and spoils the fixes. Times are on the clock of the stamps.
/// Deterministic by seed, whatever other faults there are.
class FixFaults {
 public:
  /// The faults' times count from `start`. Throws ParameterError when a zone is a polygon of fewer than three
  /// corners.
  FixFaults(const FixFaultParameters& parameters, std::uint64_t seed, double start = 0.0);

  /// Takes a fix that the receiver delivers at `now`. Whether it will come out.
  bool take(const GnssFix& fix, double now);

  /// What has come out by `now` and was not taken before.
  std::vector<SpoiltFix> release(double now);

  /// The status that a fix of that stamp claims; nothing: its own.
  [[nodiscard]] std::optional<int> status(double stamp) const;

  /// A phrase for each fault that is there at `now`; a zone where the last fix was in one.
  [[nodiscard]] std::vector<std::string> active(double now) const;

 private:
  [[nodiscard]] bool happens(const std::vector<ChanceFault>& faults, double time, std::uint32_t stream) const;
  Eigen::Vector2d error_of(const GnssFix& fix, double measured);
  void move_on(double measured);
  void send(SpoiltFix fix, double measured);

  FixFaultParameters parameters_;
  std::uint64_t seed_;
  double start_;
  std::uint32_t taken_ = 0;
  std::vector<Zone> zones_;
  std::vector<GaussMarkov2> coloured_;  ///< of each noise
  std::optional<std::size_t> zone_;     ///< the last fix was in
  std::optional<double> last_;          ///< when the fix before was measured, after the start [s]
  std::optional<SpoiltFix> shown_;      ///< the last, whose position a frozen receiver goes on to show
  std::optional<SpoiltFix> held_;       ///< waits for the next one to overtake it
  double last_arrival_ = -1e300;        ///< of what was sent before [s]
  DeliveryQueue<SpoiltFix> under_way_;
};

}  // namespace multipath_localization
