#include "ros/gnss_receiver_node/driver_messages.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "receiver/byte_reader.hpp"
#include "ros/messages/message_bytes.hpp"

namespace multipath_localization {

namespace {

constexpr const char* kMeasurements = "0eafeb530a3e6637722c4e296734c119";
constexpr const char* kOrbit = "b4346f99e431c870e392a438684c0fe8";
constexpr const char* kGlonassOrbit = "6893dee0d8b1c9325a6693f3488e0144";
constexpr double kB1I = 1561.098e6;    // [Hz]
constexpr double kTolerance = 1e3;     // of a carrier's frequency [Hz]
constexpr double kGlonassL1 = 1602e6;  // and its channels, up to 7 MHz away [Hz]
constexpr double kGlonassBand = 7.5e6;
constexpr std::size_t kMostSignals = 64;  // of a satellite

/// Takes the count of a list out that stands at `place` and says as much as the byte at `told` does; nothing
/// unless that many items of that size follow.
std::optional<std::string> without_count(std::string bytes, std::size_t place, std::size_t told,
                                         std::size_t item) {
  constexpr std::size_t kCount = sizeof(std::uint32_t);
  if (bytes.size() < place + kCount) return std::nullopt;
  const std::size_t count = ByteReader(std::string_view(bytes).substr(place)).take<std::uint32_t>();
  const bool fits =
      count == static_cast<unsigned char>(bytes[told]) && bytes.size() == place + kCount + count * item;
  if (!fits) return std::nullopt;
  return bytes.erase(place, kCount);
}

/// gnss_comm numbers satellites through: GPS, GLONASS, Galileo, BeiDou.
std::optional<SatelliteId> satellite_of(std::uint32_t number) {
  struct Block {
    Constellation constellation;
    std::uint32_t size;
  };
  constexpr std::array<Block, 4> kBlocks = {{{Constellation::kGps, 32},
                                             {Constellation::kGlonass, 27},
                                             {Constellation::kGalileo, 38},
                                             {Constellation::kBeidou, 63}}};
  if (number == 0) return std::nullopt;
  for (const Block& block : kBlocks) {
    if (number <= block.size) return SatelliteId{block.constellation, static_cast<int>(number)};
    number -= block.size;
  }
  return std::nullopt;
}

GnssTime take_time(ByteReader& in) {
  const auto week = in.take<std::uint32_t>();
  const auto second = in.take<double>();
  const bool exists = week < 10000 && second >= 0.0 && second < kSecondsOfWeek;
  if (!exists) throw std::out_of_range("no time of GPS");
  return {static_cast<int>(week), second};
}

template <class Number>
std::vector<double> take_list(ByteReader& in) {
  const auto count = in.take<std::uint32_t>();
  if (count > kMostSignals) throw std::out_of_range("more signals than any satellite has");
  std::vector<double> all;
  all.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) all.push_back(static_cast<double>(in.take<Number>()));
  return all;
}

bool near(double frequency, double carrier, double tolerance = kTolerance) {
  return std::abs(frequency - carrier) < tolerance;
}

/// How good a signal is, 1 the best; 0: not used.
int rank_of(Constellation constellation, double frequency) {
  if (constellation == Constellation::kGlonass) return near(frequency, kGlonassL1, kGlonassBand) ? 1 : 0;
  if (constellation == Constellation::kBeidou && near(frequency, kB1I)) return 1;
  if (!near(frequency, kL1Frequency)) return 0;
  return constellation == Constellation::kBeidou ? 2 : 1;
}

double at(const std::vector<double>& values, std::size_t place) {
  return place < values.size() ? values[place] : std::nan("");
}

/// The next satellite's time and best signal; nothing for the signal where none is of use.
struct Heard {
  GnssTime time;
  std::optional<RawObservation> observation;
};

Heard take_satellite(ByteReader& in) {
  Heard heard;
  heard.time = take_time(in);
  const std::optional<SatelliteId> satellite = satellite_of(in.take<std::uint32_t>());
  const std::vector<double> frequencies = take_list<double>(in);
  const std::vector<double> cn0 = take_list<double>(in);
  take_list<std::uint8_t>(in);  // losses of lock
  take_list<std::uint8_t>(in);  // codes
  const std::vector<double> pseudoranges = take_list<double>(in);
  for (int i = 0; i < 3; ++i) take_list<double>(in);  // its standard deviation, phase and that of the phase
  const std::vector<double> dopplers = take_list<double>(in);
  take_list<double>(in);        // its standard deviation
  take_list<std::uint8_t>(in);  // status
  int best = 0;
  for (std::size_t i = 0; satellite && i < frequencies.size(); ++i) {
    const int rank = rank_of(satellite->constellation, frequencies[i]);
    const bool better = rank != 0 && (best == 0 || rank < best) && at(pseudoranges, i) > 0.0;
    if (!better) continue;
    best = rank;
    heard.observation =
        RawObservation{*satellite, at(pseudoranges, i), at(dopplers, i), at(cn0, i), rank == 2};
  }
  return heard;
}

BroadcastOrbit take_orbit(ByteReader& in) {
  BroadcastOrbit orbit;
  const std::optional<SatelliteId> satellite = satellite_of(in.take<std::uint32_t>());
  if (!satellite) throw std::out_of_range("no satellite");
  orbit.satellite = *satellite;
  const bool galileo = satellite->constellation == Constellation::kGalileo;
  const GnssTime sent = take_time(in);
  orbit.reference = take_time(in);
  orbit.sent = sent - orbit.reference;
  orbit.clock_reference = take_time(in);
  const auto next = [&in] { return in.take<double>(); };
  orbit.toe = next();
  in.skip(3 * sizeof(std::uint32_t));  // week, issues of data
  const auto health = in.take<std::uint32_t>();
  orbit.healthy = (galileo ? health & 7U : health) == 0;  // of Galileo E1 B's alone
  in.skip(sizeof(std::uint32_t) + sizeof(double));        // code, accuracy
  orbit.root_axis = std::sqrt(next());
  orbit.eccentricity = next();
  orbit.inclination = next();
  orbit.perigee = next();
  orbit.node = next();
  orbit.mean_anomaly = next();
  orbit.mean_motion_difference = next();
  orbit.node_rate = next();
  orbit.inclination_rate = next();
  for (Eigen::Vector2d* cosine_and_sine :
       {&orbit.latitude_correction, &orbit.radius_correction, &orbit.inclination_correction}) {
    cosine_and_sine->y() = next();
    cosine_and_sine->x() = next();
  }
  for (Eigen::Index i = 0; i < orbit.clock_polynomial.size(); ++i) orbit.clock_polynomial[i] = next();
  const double first = next();
  const double second = next();
  orbit.group_delay = galileo ? second : first;
  return orbit;
}

GlonassOrbit take_glonass_orbit(ByteReader& in) {
  GlonassOrbit orbit;
  const std::optional<SatelliteId> satellite = satellite_of(in.take<std::uint32_t>());
  if (!satellite || satellite->constellation != Constellation::kGlonass)
    throw std::out_of_range("no satellite");
  orbit.satellite = *satellite;
  const GnssTime sent = take_time(in);
  orbit.reference = take_time(in);
  orbit.sent = sent - orbit.reference;
  orbit.channel = in.take<std::int32_t>();
  in.skip(sizeof(std::uint32_t));  // issue of data
  orbit.healthy = in.take<std::uint32_t>() == 0;
  in.skip(sizeof(std::uint32_t) + sizeof(double));  // age, accuracy
  for (Eigen::Vector3d* vector : {&orbit.position, &orbit.velocity, &orbit.acceleration}) {
    for (Eigen::Index i = 0; i < vector->size(); ++i) (*vector)[i] = in.take<double>();
  }
  orbit.clock = -in.take<double>();
  orbit.clock_drift = in.take<double>();
  return orbit;
}

/// What `read` makes of the bytes; nothing where they end early or hold what cannot be.
template <class Read>
auto read_whole(const topic_tools::ShapeShifter& message, const Read& read)
    -> decltype(std::optional(read(std::declval<ByteReader&>()))) {
  const std::string bytes = bytes_of(message);
  ByteReader in(bytes);
  try {
    return read(in);
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<std::string> rawx_payload(const topic_tools::ShapeShifter& message) {
  return without_count(bytes_of(message), 16, 11, 32);
}

std::optional<std::string> sfrbx_payload(const topic_tools::ShapeShifter& message) {
  return without_count(bytes_of(message), 8, 4, 4);
}

std::optional<RawEpoch> gnss_comm_epoch(const topic_tools::ShapeShifter& message) {
  if (message.getMD5Sum() != kMeasurements) return std::nullopt;
  const auto epoch = read_whole(message, [](ByteReader& in) {
    RawEpoch read;
    const auto count = in.take<std::uint32_t>();
    for (std::uint32_t i = 0; i < count; ++i) {
      const Heard heard = take_satellite(in);
      if (i == 0) read.time = heard.time;
      if (heard.observation) read.observations.push_back(*heard.observation);
    }
    return read;
  });
  return epoch && epoch->time.week > 0 ? epoch : std::nullopt;
}

std::optional<Ephemeris> gnss_comm_ephemeris(const topic_tools::ShapeShifter& message) {
  const std::string& md5sum = message.getMD5Sum();
  std::optional<Ephemeris> ephemeris;
  if (md5sum == kOrbit) {
    ephemeris = read_whole(message, [](ByteReader& in) { return Ephemeris(take_orbit(in)); });
  } else if (md5sum == kGlonassOrbit) {
    ephemeris = read_whole(message, [](ByteReader& in) { return Ephemeris(take_glonass_orbit(in)); });
  }
  return ephemeris && possible(*ephemeris) ? ephemeris : std::nullopt;
}

}  // namespace multipath_localization
