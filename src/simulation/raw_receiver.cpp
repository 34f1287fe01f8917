#include "simulation/raw_receiver.hpp"

#include <cmath>
#include <utility>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/random.hpp"
#include "simulation/code_multipath.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

constexpr double kReferenceCn0 = 45.0;   // of the parameters of noise [dB-Hz]
constexpr double kIonosphere = 350e3;    // height of its thin shell [m]
constexpr double kEarthRadius = 6371e3;  // [m]

/// Path through a thin shell at the height of the ionosphere, over that at the zenith.
double obliquity(double elevation) {
  const double sine = kEarthRadius * std::cos(elevation) / (kEarthRadius + kIonosphere);
  return 1.0 / std::sqrt(1.0 - sine * sine);
}

/// One step of a Gauss-Markov process of standard deviation `sigma`.
double gauss_markov(double value, double sigma, double kept, double normal) {
  return kept * value + sigma * std::sqrt(1.0 - kept * kept) * normal;
}

}  // namespace

void RawReceiverParameters::fields(ParameterVisitor& field) {
  field("elevation_mask_deg", elevation_mask_deg, {0.0, 90.0}, "deg", "lower satellites are left out");
  field("cn0_zenith", cn0_zenith, {0.0, 70.0}, "dB-Hz", "of a satellite overhead in the open, in the mean");
  field("cn0_horizon", cn0_horizon, {0.0, 70.0}, "dB-Hz", "at the horizon; linear in sin(elevation) between");
  field("fading_sigma", fading_sigma, {0.0, 20.0}, "dB", "Gauss-Markov variation of the C/N0 of a satellite");
  field("fading_time_constant", fading_time_constant, {1e-3, 1e6}, "s", "its correlation time");
  field("tracking_threshold", tracking_threshold, {0.0, 70.0}, "dB-Hz", "weaker signals are not tracked");
  field("lock_delay", lock_delay, {0.0, 60.0}, "s", "from a signal's return to its first observation");
  field("code_noise", code_noise, {0.0, 100.0}, "m",
        "white, of a pseudorange at 45 dB-Hz, ten times as much 20 dB below");
  field("doppler_noise", doppler_noise, {0.0, 10.0}, "m/s", "white, of a range rate, likewise");
  field("correlator_spacing", correlator_spacing, {0.01, 1.0}, "chip", "early to late, of the C/A code");
  field("loop_bandwidth", loop_bandwidth, {0.01, 100.0}, "Hz",
        "of the code's loop: echoes whose phase turns faster average out, the jump to another path dies out "
        "with a time constant of 1/4 of its inverse");
  field("atmosphere_sigma", atmosphere_sigma, {0.0, 100.0}, "m",
        "Gauss-Markov delay at the zenith that models and broadcasts leave to each satellite");
  field("atmosphere_time_constant", atmosphere_time_constant, {1e-3, 1e6}, "s", "its correlation time");
  field("inter_system_sigma", inter_system_sigma, {0.0, 1e3}, "m",
        "spread of the constant offsets of the other constellations against GPS, by seed");
  field("declared_floor", declared_floor, {0.1, 100.0}, "m",
        "the declared standard deviation of a pseudorange is the root of the squares of this ...");
  field("declared_ratio", declared_ratio, {0.0, 100.0}, "1",
        "... and of this times its white noise; reflections are not in it");
  field.group("clock", clock, "of the receiver");
}

RawReceiver::RawReceiver(const RawReceiverParameters& parameters, std::vector<Satellite> satellites,
                         SkyView sky, const LocalFrame& map, std::uint64_t seed)
    : parameters_(parameters),
      satellites_(std::move(satellites)),
      sky_(std::move(sky)),
      map_(map),
      seed_(seed),
      clock_(parameters.clock, seed),
      channels_(satellites_.size()) {
  RandomStream random(seed_, 0, kInterSystemStream);
  for (std::size_t i = 1; i < inter_system_.size(); ++i) {
    inter_system_[i] = parameters_.inter_system_sigma * random.normal();
  }
}

std::vector<TrackedSignal> RawReceiver::measure(const AntennaState& antenna, double time) {
  const double duration = epochs_ == 0 ? 0.0 : time - last_;
  clock_.step(duration);
  std::vector<TrackedSignal> all;
  for (std::size_t i = 0; i < satellites_.size(); ++i) {
    Channel& channel = channels_[i];
    const Noise noise = step(i, duration);
    const View seen = view(satellites_[i], antenna, time);
    if (!track(seen, antenna.velocity, time, channel)) continue;
    const SignalPath& path = seen.paths.front();
    TrackedSignal signal{{}, path, channel.code_delay + echoes(seen.paths, antenna.velocity)};
    SatelliteObservation& observation = signal.observation;
    observation.constellation = satellites_[i].constellation;
    observation.satellite = satellites_[i].number;
    observation.pseudorange = seen.range + signal.multipath;
    observation.range_rate = seen.direction.dot(seen.satellite.velocity) - path.arrival.dot(antenna.velocity);
    observation.cn0 = cn0(seen, channel);
    observation.elevation = seen.elevation;
    observation.position = seen.satellite.position;
    observation.velocity = seen.satellite.velocity;
    add_errors(channel, noise, observation);
    all.push_back(signal);
  }
  last_ = time;
  ++epochs_;
  return all;
}

RawReceiver::View RawReceiver::view(const Satellite& satellite, const AntennaState& antenna,
                                    double time) const {
  View seen;
  seen.satellite = at_transmission(satellite.orbit, map_, antenna.position, time);
  const Eigen::Vector3d way = seen.satellite.position - antenna.position;
  seen.range = way.norm();
  seen.direction = way / seen.range;
  seen.elevation = std::asin(seen.direction.z());
  if (seen.elevation >= parameters_.elevation_mask_deg * kPi / 180.0) {
    seen.paths = sky_.paths(antenna.position, seen.direction);
  }
  return seen;
}

RawReceiver::Noise RawReceiver::step(std::size_t index, double duration) {
  RandomStream random(seed_, epochs_, kSatelliteStream + static_cast<std::uint32_t>(index));
  const auto kept = [&](double time_constant) {
    return epochs_ == 0 ? 0.0 : std::exp(-duration / time_constant);
  };
  Channel& channel = channels_[index];
  channel.atmosphere = gauss_markov(channel.atmosphere, parameters_.atmosphere_sigma,
                                    kept(parameters_.atmosphere_time_constant), random.normal());
  channel.fading = gauss_markov(channel.fading, parameters_.fading_sigma,
                                kept(parameters_.fading_time_constant), random.normal());
  const double code = random.normal();
  return {code, random.normal()};
}

double RawReceiver::cn0(const View& view, const Channel& channel) const {
  const double rise = parameters_.cn0_zenith - parameters_.cn0_horizon;
  return parameters_.cn0_horizon + rise * std::sin(view.elevation) + channel.fading -
         view.paths.front().loss_db;
}

bool RawReceiver::track(const View& view, const Eigen::Vector3d& velocity, double time,
                        Channel& channel) const {
  if (view.paths.empty() || cn0(view, channel) < parameters_.tracking_threshold) {
    channel.tracked_since.reset();
    return false;
  }
  const SignalPath& path = view.paths.front();
  if (channel.tracked_since) {
    // The carrier carries the code along the path of now; the loop only closes what is left between them.
    channel.code_delay += (view.direction - path.arrival).dot(velocity) * (time - last_);
    const double kept = std::exp(-4.0 * parameters_.loop_bandwidth * (time - last_));
    channel.code_delay = path.delay + kept * (channel.code_delay - path.delay);
  } else {
    channel.tracked_since = epochs_ == 0 ? time - parameters_.lock_delay : time;
    channel.code_delay = path.delay;
  }
  return time - *channel.tracked_since >= parameters_.lock_delay - 1e-9;
}

double RawReceiver::echoes(const std::vector<SignalPath>& paths, const Eigen::Vector3d& velocity) const {
  const SignalPath& tracked = paths.front();
  double error = 0.0;
  for (std::size_t i = 1; i < paths.size(); ++i) {
    const double delay = paths[i].delay - tracked.delay;
    const double fading = (paths[i].arrival - tracked.arrival).dot(velocity) / kL1Wavelength;  // [Hz]
    const double averaged = std::hypot(1.0, fading / parameters_.loop_bandwidth);
    const double amplitude = std::pow(10.0, (tracked.loss_db - paths[i].loss_db) / 20.0);
    const Echo echo{amplitude, delay, 2.0 * kPi * delay / kL1Wavelength};
    error += code_multipath(echo, parameters_.correlator_spacing) / averaged;
  }
  return error;
}

void RawReceiver::add_errors(const Channel& channel, const Noise& noise,
                             SatelliteObservation& observation) const {
  const double weakness = std::pow(10.0, (kReferenceCn0 - observation.cn0) / 20.0);
  observation.pseudorange +=
      clock_.bias() + inter_system_[static_cast<std::size_t>(observation.constellation)] +
      obliquity(observation.elevation) * channel.atmosphere + weakness * parameters_.code_noise * noise.code;
  observation.range_rate += clock_.drift() + weakness * parameters_.doppler_noise * noise.doppler;
  observation.sigma =
      std::hypot(parameters_.declared_floor, parameters_.declared_ratio * weakness * parameters_.code_noise);
}

}  // namespace multipath_localization
