#include "ros/messages/epoch_conversions.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/models/pseudorange/pseudorange.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kMostSatellites = 256;
constexpr double kNearestRange = 1e6, kFurthestRange = 1e8;  ///< clock of the receiver included [m]
constexpr double kStrongest = 100.0;                         ///< [dB-Hz]

static_assert(Pseudorange::GPS == static_cast<int>(Constellation::kGps));
static_assert(Pseudorange::GLONASS == static_cast<int>(Constellation::kGlonass));
static_assert(Pseudorange::GALILEO == static_cast<int>(Constellation::kGalileo));
static_assert(Pseudorange::BEIDOU == static_cast<int>(Constellation::kBeidou));
static_assert(Pseudorange::QZSS == static_cast<int>(Constellation::kQzss));

/// False for NaN.
bool within(double value, double low, double high) { return value >= low && value <= high; }

bool unknown_or_within(double value, double low, double high) {
  return std::isnan(value) || within(value, low, high);
}

template <class Xyz>
Eigen::Vector3d vector(const Xyz& message) {
  return {message.x, message.y, message.z};
}

template <class Xyz>
void assign(Xyz& message, const Eigen::Vector3d& vector) {
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
}

bool usable(const Pseudorange& message, const EpochParameters& parameters) {
  const Eigen::Vector3d velocity = vector(message.velocity);
  return message.constellation < kConstellations &&
         within(message.pseudorange, kNearestRange, kFurthestRange) &&
         within(vector(message.position).norm(), kLowestOrbit, kHighestOrbit) &&
         unknown_or_within(message.range_rate, -kFastestRangeRate, kFastestRangeRate) &&
         (velocity.hasNaN() || velocity.norm() <= kFastestRangeRate) &&
         unknown_or_within(message.cn0, 0.0, kStrongest) &&
         unknown_or_within(message.elevation, -0.5 * kPi, 0.5 * kPi) &&
         !(message.sigma > parameters.largest_sigma);
}

/// The usable satellites, each once.
std::vector<Pseudorange> usable_satellites(const GnssEpoch& message, const EpochParameters& parameters) {
  std::vector<Pseudorange> kept;
  std::set<std::pair<int, int>> named;
  for (const Pseudorange& pseudorange : message.pseudoranges) {
    if (!usable(pseudorange, parameters)) continue;
    if (named.insert({pseudorange.constellation, pseudorange.satellite}).second) kept.push_back(pseudorange);
  }
  return kept;
}

SatelliteObservation to_observation(const Pseudorange& message, const LocalFrame& map, double default_sigma) {
  SatelliteObservation observation;
  observation.constellation = static_cast<Constellation>(message.constellation);
  observation.satellite = message.satellite;
  observation.pseudorange = message.pseudorange;
  observation.range_rate = message.range_rate;
  observation.cn0 = message.cn0;
  observation.sigma = message.sigma > 0.0 ? message.sigma : default_sigma;
  observation.position = map.satellite_to_map(vector(message.position));
  observation.elevation = std::isnan(message.elevation)
                              ? std::asin(observation.position.z() / observation.position.norm())
                              : message.elevation;
  const Eigen::Vector3d velocity = vector(message.velocity);
  if (!velocity.hasNaN()) {
    observation.velocity = map.satellite_velocity_to_map(vector(message.position), velocity);
  }
  return observation;
}

Pseudorange to_message(const SatelliteObservation& observation, const LocalFrame& map) {
  Pseudorange message;
  message.constellation = static_cast<std::uint8_t>(observation.constellation);
  message.satellite = static_cast<std::uint16_t>(observation.satellite);
  message.pseudorange = observation.pseudorange;
  message.range_rate = observation.range_rate;
  message.cn0 = observation.cn0;
  message.elevation = observation.elevation;
  message.sigma = observation.sigma;
  assign(message.position, map.satellite_to_ecef(observation.position));
  assign(message.velocity, map.satellite_velocity_to_ecef(observation.position, observation.velocity));
  return message;
}

}  // namespace

void EpochParameters::fields(ParameterVisitor& field) {
  field("default_sigma", default_sigma, {1e-3, 1e3}, "m", "of a pseudorange that declares none");
  field("largest_sigma", largest_sigma, {1.0, 1e6}, "m", "a satellite that declares more is left out");
}

Reason check(const GnssEpoch& message, const EpochParameters& parameters) {
  if (message.header.stamp.isZero()) return Reason::kZeroStamp;
  if (!is_short(message.header.frame_id)) return Reason::kInvalidFrame;
  if (message.pseudoranges.size() > kMostSatellites) return Reason::kTooManySatellites;
  return usable_satellites(message, parameters).empty() ? Reason::kTooFewSatellites : Reason::kAccepted;
}

CheckedEpoch to_epoch(const GnssEpoch& message, const LocalFrame& map, const EpochParameters& parameters,
                      const Eigen::Vector2d& antenna_in_base) {
  CheckedEpoch checked;
  checked.reason = check(message, parameters);
  if (checked.reason != Reason::kAccepted) return checked;
  checked.epoch.stamp = message.header.stamp.toSec();
  checked.epoch.antenna_in_base = antenna_in_base;
  for (const Pseudorange& pseudorange : usable_satellites(message, parameters)) {
    checked.epoch.observations.push_back(to_observation(pseudorange, map, parameters.default_sigma));
  }
  checked.dropped = message.pseudoranges.size() - checked.epoch.observations.size();
  return checked;
}

std::optional<Geodetic> solve_geodetic(const GnssEpoch& message, const EpochParameters& parameters) {
  const LocalFrame anywhere(Geodetic{});
  const CheckedEpoch checked = to_epoch(message, anywhere, parameters);
  return solve_geodetic(checked.epoch.observations, anywhere);
}

GnssEpoch to_message(const PseudorangeEpoch& epoch, const LocalFrame& map, const std_msgs::Header& header) {
  GnssEpoch message;
  message.header = header;
  for (const SatelliteObservation& observation : epoch.observations) {
    message.pseudoranges.push_back(to_message(observation, map));
  }
  return message;
}

}  // namespace multipath_localization
