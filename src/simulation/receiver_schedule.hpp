#pragma once

#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/delivery_queue.hpp"
#include "simulation/receiver.hpp"

namespace multipath_localization {

/// When a receiver measures, and when what it measured arrives.
class ReceiverSchedule {
 public:
  ReceiverSchedule(const ReceiverParameters& parameters, const std::vector<OutageParameters>& outages,
                   std::uint64_t seed);

  /// Whether an epoch falls into the step that ends at `time` [s], outside of outages. Once per step.
  bool due(double time);

  /// Sends what was measured at `time` [s] on its way; it arrives its latency later, in order of stamps.
  void send(std::vector<Measurement> measured, double time);

  /// What has arrived by `time` [s] and was not taken before.
  std::vector<Measurement> take(double time);

 private:
  ReceiverParameters parameters_;
  std::vector<OutageParameters> outages_;
  std::uint64_t seed_;
  std::int64_t epochs_ = 0;
  DeliveryQueue<std::vector<Measurement>> under_way_;
};

}  // namespace multipath_localization
