#include "simulation/fix_faults.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

template <class Fault>
bool any_at(const std::vector<Fault>& faults, double time) {
  return std::any_of(faults.begin(), faults.end(), [time](const Fault& fault) { return fault.holds(time); });
}

/// The numbers of a noise for the step that leads to the fix of that number.
RandomStream numbers(std::uint64_t seed, std::uint32_t step, SimulationStream stream, std::size_t noise) {
  return {seed, step, stream + static_cast<std::uint32_t>(noise)};
}

}  // namespace

Eigen::Vector2d BiasFault::offset(double time) const {
  if (!holds(time)) return Eigen::Vector2d::Zero();
  const double reached = walk_in > 0.0 ? std::min((time - start) / walk_in, 1.0) : 1.0;
  return reached * Eigen::Vector2d(east, north);
}

FixFaults::FixFaults(const FixFaultParameters& parameters, std::uint64_t seed, double start)
    : parameters_(parameters), seed_(seed), start_(start) {
  for (const ZoneParameters& zone : parameters_.zones) {
    const auto index = static_cast<std::uint32_t>(zones_.size());
    zones_.emplace_back(zone, seed, kFaultZoneStream - kZoneStream + index);
  }
  for (const NoiseFault& noise : parameters_.noises) {
    coloured_.emplace_back(noise.coloured_sigma, noise.time_constant,
                           numbers(seed, 0, kFixColouredNoiseStream, coloured_.size()));
  }
}

bool FixFaults::take(const GnssFix& fix, double now) {
  const double measured = fix.stamp - start_;
  SpoiltFix spoilt{taken_, taken_, fix, now};
  ++taken_;
  move_on(measured);
  const Eigen::Vector2d error = error_of(fix, measured);
  if (any_at(parameters_.outages, measured) || happens(parameters_.losses, measured, kFixLossStream)) {
    return false;
  }
  spoilt.fix.position += error;
  for (const CovarianceFault& lie : parameters_.covariances) {
    if (lie.holds(measured)) spoilt.fix.covariance *= lie.sigma_factor * lie.sigma_factor;
  }
  if (shown_ && any_at(parameters_.freezes, measured)) {
    spoilt.shown = shown_->shown;
    spoilt.fix.position = shown_->fix.position;
    spoilt.fix.covariance = shown_->fix.covariance;
  }
  shown_ = spoilt;
  send(spoilt, measured);
  return true;
}

std::vector<SpoiltFix> FixFaults::release(double now) { return under_way_.take(now); }

std::optional<int> FixFaults::status(double stamp) const {
  for (const StatusFault& fault : parameters_.statuses) {
    if (fault.holds(stamp - start_)) return fault.status;
  }
  return std::nullopt;
}

bool FixFaults::happens(const std::vector<ChanceFault>& faults, double time, std::uint32_t stream) const {
  const double drawn = RandomStream(seed_, taken_, stream).uniform();
  return std::any_of(faults.begin(), faults.end(),
                     [=](const ChanceFault& fault) { return fault.holds(time) && drawn < fault.share; });
}

void FixFaults::move_on(double measured) {
  const double duration = last_ ? std::max(measured - *last_, 0.0) : 0.0;
  last_ = measured;
  for (Zone& zone : zones_) zone.step(duration);
  for (std::size_t i = 0; i < coloured_.size(); ++i) {
    RandomStream random = numbers(seed_, taken_, kFixColouredNoiseStream, i);
    coloured_[i].step(duration, random);
  }
}

Eigen::Vector2d FixFaults::error_of(const GnssFix& fix, double measured) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  const auto zone =
      std::find_if(zones_.begin(), zones_.end(), [&](const Zone& z) { return z.depth(fix.position) > 0.0; });
  zone_.reset();
  if (zone != zones_.end()) {
    zone_ = static_cast<std::size_t>(zone - zones_.begin());
    sum += zone->bias(fix.position);
  }
  for (const BiasFault& bias : parameters_.biases) sum += bias.offset(measured);
  for (std::size_t i = 0; i < coloured_.size(); ++i) {
    if (!parameters_.noises[i].holds(measured)) continue;
    RandomStream random = numbers(seed_, taken_, kFixWhiteNoiseStream, i);
    sum += coloured_[i].value() + normal2(random, parameters_.noises[i].white_sigma);
  }
  RandomStream random(seed_, taken_, kFixSpikeStream);
  const double drawn = random.uniform();
  const double direction = 2.0 * kPi * random.uniform();
  for (const SpikeFault& spike : parameters_.spikes) {
    if (!spike.holds(measured) || drawn >= spike.share) continue;
    sum += spike.length * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  }
  return sum;
}

void FixFaults::send(SpoiltFix fix, double measured) {
  if (!held_ && happens(parameters_.swaps, measured, kFixSwapStream)) {
    held_ = fix;
    return;
  }
  const double drawn = RandomStream(seed_, taken_, kFixDelayStream).uniform();
  for (const DelayFault& delay : parameters_.delays) {
    if (delay.holds(measured)) fix.arrival += delay.delay + delay.jitter * drawn;
  }
  const auto deliver = [&](SpoiltFix out) {
    out.arrival = last_arrival_ = std::max(fix.arrival, last_arrival_);
    under_way_.send(out, out.arrival);
  };
  deliver(fix);
  if (happens(parameters_.duplicates, measured, kFixDuplicateStream)) deliver(fix);
  if (held_) deliver(*held_);
  held_.reset();
}

}  // namespace multipath_localization
