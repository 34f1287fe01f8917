#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"
#include "simulation/delivery_queue.hpp"
#include "simulation/gauss_markov.hpp"
#include "simulation/zone.hpp"

namespace multipath_localization {

/// An interval without fixes.
struct OutageParameters {
  double start = 0.0;
  double duration = 10.0;

  void fields(ParameterVisitor& field);
};

/// Whether one of the intervals holds `time` [s].
bool outage_at(const std::vector<OutageParameters>& outages, double time);

/// What a simulated fix is made of, as `source` says.
enum class ReceiverSource { kZones, kSatellites };

struct ReceiverParameters {
  ReceiverSource source = ReceiverSource::kZones;
  double rate = 5.0;
  double latency = 0.0;
  double latency_jitter = 0.0;
  double antenna_x = 0.0;
  double antenna_y = 0.0;
  double antenna_z = 1.5;
  double sigma_open = 0.3;
  double sigma_shadow = 1.0;
  double coloured_sigma = 0.0;
  double coloured_time_constant = 10.0;
  double declared_sigma_open = 0.3;
  double declared_sigma_shadow = 0.3;

  void fields(ParameterVisitor& field);
};

/// A GNSS receiver: fixes of the antenna, late and with white, coloured and biased errors.
class Receiver {
 public:
  Receiver(const ReceiverParameters& parameters, const std::vector<OutageParameters>& outages,
           std::uint64_t seed);

  /// Watches one step of `duration` that ended at `time` [s] with the antenna at `antenna_in_map` [m].
  /// Returns the fixes delivered by now: each arrives its latency after its stamp, in order of stamps.
  std::vector<GnssFix> step(const Eigen::Vector2d& antenna_in_map, const Reception& reception, double time,
                            double duration);

  [[nodiscard]] Eigen::Vector2d antenna_in_base() const;
  [[nodiscard]] const ReceiverParameters& parameters() const { return parameters_; }

 private:
  void measure(const Eigen::Vector2d& antenna_in_map, const Reception& reception, double time);

  ReceiverParameters parameters_;
  std::vector<OutageParameters> outages_;
  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  std::int64_t emitted_ = 0;
  GaussMarkov2 coloured_;
  DeliveryQueue<GnssFix> under_way_;
};

}  // namespace multipath_localization
