#include "simulation/receiver.hpp"

#include <algorithm>

#include "multipath_localization/core/random.hpp"
#include "simulation/periods.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

void OutageParameters::fields(ParameterVisitor& field) {
  field("start", start, {0.0, 1e9}, "s", "no fix from here on");
  field("duration", duration, {0.0, 1e9}, "s", "for this long");
}

bool outage_at(const std::vector<OutageParameters>& outages, double time) {
  return std::any_of(outages.begin(), outages.end(), [time](const OutageParameters& outage) {
    return time >= outage.start && time < outage.start + outage.duration;
  });
}

void ReceiverParameters::fields(ParameterVisitor& field) {
  field("source", source, {"zones", "satellites"},
        "of the errors of a fix: zones and the noise below, or the satellites it is computed from");
  field("rate", rate, {0.0, 1e4}, "Hz", "of fixes, at most one per simulation step; 0: none");
  field("latency", latency, {0.0, 60.0}, "s", "from measurement to delivery");
  field("latency_jitter", latency_jitter, {0.0, 60.0}, "s", "added to it at most, uniformly");
  field("antenna_x", antenna_x, {-100.0, 100.0}, "m", "antenna in base, forwards");
  field("antenna_y", antenna_y, {-100.0, 100.0}, "m", "antenna in base, to the left");
  field("antenna_z", antenna_z, {0.0, 100.0}, "m",
        "antenna in base, upwards: satellites see it there, and slopes lean it");
  field("sigma_open", sigma_open, {0.0, 1e3}, "m", "white noise of each component under open sky");
  field("sigma_shadow", sigma_shadow, {0.0, 1e3}, "m", "white noise of each component in a zone");
  field("coloured_sigma", coloured_sigma, {0.0, 1e3}, "m",
        "Gauss-Markov noise of each component, everywhere");
  field("coloured_time_constant", coloured_time_constant, {1e-3, 1e6}, "s", "its correlation time");
  field("declared_sigma_open", declared_sigma_open, {0.0, 1e6}, "m",
        "what the receiver claims under open sky");
  field("declared_sigma_shadow", declared_sigma_shadow, {0.0, 1e6}, "m", "what it claims in a zone");
}

Receiver::Receiver(const ReceiverParameters& parameters, const std::vector<OutageParameters>& outages,
                   std::uint64_t seed)
    : parameters_(parameters),
      outages_(outages),
      seed_(seed),
      coloured_(parameters.coloured_sigma, parameters.coloured_time_constant,
                RandomStream(seed, 0, kReceiverStream)) {}

Eigen::Vector2d Receiver::antenna_in_base() const { return {parameters_.antenna_x, parameters_.antenna_y}; }

void Receiver::measure(const Eigen::Vector2d& antenna_in_map, const Reception& reception, double time) {
  RandomStream random(seed_, steps_, kReceiverNoiseStream);
  const double sigma = reception.in_shadow ? parameters_.sigma_shadow : parameters_.sigma_open;
  const double declared =
      reception.in_shadow ? parameters_.declared_sigma_shadow : parameters_.declared_sigma_open;
  GnssFix fix;
  fix.stamp = time;
  fix.position =
      antenna_in_map + reception.bias + coloured_.value() + normal2(random, sigma);  // Eq. (9) of [NIS]
  fix.covariance = declared * declared * Eigen::Matrix2d::Identity();
  fix.antenna_in_base = antenna_in_base();
  const double late = parameters_.latency + parameters_.latency_jitter * random.uniform();
  under_way_.send(fix, time + late);
}

std::vector<GnssFix> Receiver::step(const Eigen::Vector2d& antenna_in_map, const Reception& reception,
                                    double time, double duration) {
  RandomStream random(seed_, ++steps_, kReceiverStream);
  coloured_.step(duration, random);

  const auto due = periods(time, parameters_.rate);
  if (due > emitted_ && !outage_at(outages_, time)) measure(antenna_in_map, reception, time);
  emitted_ = due;

  return under_way_.take(time);
}

}  // namespace multipath_localization
