#include "multipath_localization/simulation/receiver_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/simulation/streams.hpp"

namespace multipath_localization {

ReceiverSchedule::ReceiverSchedule(const ReceiverParameters& parameters,
                                   const std::vector<OutageParameters>& outages, std::uint64_t seed)
    : parameters_(parameters), outages_(outages), seed_(seed) {}

bool ReceiverSchedule::due(double time) {
  const auto epochs = static_cast<std::int64_t>(std::floor(time * parameters_.rate + 1e-6));
  if (epochs == epochs_) return false;
  epochs_ = epochs;
  return !outage_at(outages_, time);
}

void ReceiverSchedule::send(std::vector<Measurement> measured, double time) {
  RandomStream random(seed_, static_cast<std::uint32_t>(epochs_), kReceiverLatencyStream);
  const double late = parameters_.latency + parameters_.latency_jitter * random.uniform();
  const double after_last = under_way_.empty() ? time : under_way_.back().time;
  under_way_.push_back({std::max(time + late, after_last), std::move(measured)});
}

std::vector<Measurement> ReceiverSchedule::take(double time) {
  std::vector<Measurement> arrived;
  while (!under_way_.empty() && under_way_.front().time <= time + 1e-9) {
    const std::vector<Measurement>& measured = under_way_.front().measured;
    arrived.insert(arrived.end(), measured.begin(), measured.end());
    under_way_.pop_front();
  }
  return arrived;
}

}  // namespace multipath_localization
