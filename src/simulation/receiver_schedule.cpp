#include "simulation/receiver_schedule.hpp"

#include <utility>

#include "multipath_localization/core/random.hpp"
#include "simulation/periods.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

ReceiverSchedule::ReceiverSchedule(const ReceiverParameters& parameters,
                                   const std::vector<OutageParameters>& outages, std::uint64_t seed)
    : parameters_(parameters), outages_(outages), seed_(seed) {}

bool ReceiverSchedule::due(double time) {
  const auto epochs = periods(time, parameters_.rate);
  if (epochs == epochs_) return false;
  epochs_ = epochs;
  return !outage_at(outages_, time);
}

void ReceiverSchedule::send(std::vector<Measurement> measured, double time) {
  RandomStream random(seed_, static_cast<std::uint32_t>(epochs_), kReceiverLatencyStream);
  const double late = parameters_.latency + parameters_.latency_jitter * random.uniform();
  under_way_.send(std::move(measured), time + late);
}

std::vector<Measurement> ReceiverSchedule::take(double time) {
  std::vector<Measurement> arrived;
  for (const std::vector<Measurement>& measured : under_way_.take(time)) {
    arrived.insert(arrived.end(), measured.begin(), measured.end());
  }
  return arrived;
}

}  // namespace multipath_localization
