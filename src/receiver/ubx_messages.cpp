#include "receiver/ubx_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "receiver/byte_reader.hpp"

namespace multipath_localization {

namespace {

constexpr int kUnknownSlot = 255;        // of a GLONASS satellite
constexpr int kChannelOffset = 7;        // u-blox's frequency identifier - k
constexpr double kFastestDoppler = 1e5;  // of anything that is a satellite's [Hz]
constexpr std::size_t kRawxHeader = 16, kMeasurement = 32, kSfrbxHeader = 8, kWord = 4;  // bytes

/// A signal by its identifiers in UBX. Of several of a satellite the first in this list counts.
struct Signal {
  int system;
  int signal;
  Constellation constellation;
  bool b1c;
};
constexpr std::array<Signal, 9> kSignals = {{{0, 0, Constellation::kGps, false},
                                             {2, 0, Constellation::kGalileo, false},
                                             {2, 1, Constellation::kGalileo, false},
                                             {3, 0, Constellation::kBeidou, false},
                                             {3, 1, Constellation::kBeidou, false},
                                             {3, 5, Constellation::kBeidou, true},
                                             {3, 6, Constellation::kBeidou, true},
                                             {5, 0, Constellation::kQzss, false},
                                             {6, 0, Constellation::kGlonass, false}}};

const Signal* signal_of(int system, int signal) {
  const auto* const found = std::find_if(kSignals.begin(), kSignals.end(), [&](const Signal& known) {
    return known.system == system && known.signal == signal;
  });
  return found == kSignals.end() ? nullptr : found;
}

bool numbered(Constellation constellation, int number) {
  return number > 0 && !(constellation == Constellation::kGlonass && number == kUnknownSlot);
}

/// An observation and the signal it is of.
struct Measurement {
  const Signal* signal = nullptr;
  RawObservation observation;
};

/// The next one; without a signal where it is not of use.
Measurement take_measurement(ByteReader& in) {
  Measurement measurement;
  RawObservation& observation = measurement.observation;
  observation.pseudorange = in.take<double>();
  in.skip(sizeof(double));  // carrier phase
  const double doppler = in.take<float>();
  const int system = in.take<std::uint8_t>();
  observation.satellite.number = in.take<std::uint8_t>();
  const int signal = in.take<std::uint8_t>();
  in.skip(3);  // channel, lock time
  const int cn0 = in.take<std::uint8_t>();
  in.skip(3);  // standard deviations
  const bool valid = (in.take<std::uint8_t>() & 1U) != 0;
  in.skip(1);
  measurement.signal = signal_of(system, signal);
  if (measurement.signal == nullptr) return measurement;
  observation.satellite.constellation = measurement.signal->constellation;
  observation.b1c = measurement.signal->b1c;
  // Zero is how the receiver, as RINEX, says that it has none.
  if (doppler != 0.0 && std::abs(doppler) < kFastestDoppler) observation.doppler = doppler;
  if (cn0 > 0) observation.cn0 = cn0;
  const bool of_use = valid && observation.pseudorange > 0.0 && std::isfinite(observation.pseudorange) &&
                      numbered(observation.satellite.constellation, observation.satellite.number);
  if (!of_use) measurement.signal = nullptr;
  return measurement;
}

/// Adds it, or puts it in the place of a less good one of the same satellite.
void add(const Measurement& measurement, std::vector<Measurement>& all) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const Measurement& other) {
    return other.observation.satellite == measurement.observation.satellite;
  });
  if (same == all.end()) {
    all.push_back(measurement);
  } else if (measurement.signal < same->signal) {
    *same = measurement;
  }
}

}  // namespace

std::optional<ReceiverEpoch> read_rawx(std::string_view payload) {
  if (payload.size() < kRawxHeader) return std::nullopt;
  ByteReader in(payload);
  const auto second = in.take<double>();
  const auto week = in.take<std::uint16_t>();
  const auto leap_seconds = in.take<std::int8_t>();
  const std::size_t count = in.take<std::uint8_t>();
  const unsigned status = in.take<std::uint8_t>();
  in.skip(3);  // version, reserved
  const bool timed = week > 0 && second >= 0.0 && second < kSecondsOfWeek;
  if (payload.size() != kRawxHeader + kMeasurement * count || !timed) return std::nullopt;

  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < count; ++i) {
    const Measurement measurement = take_measurement(in);
    if (measurement.signal != nullptr) add(measurement, measurements);
  }
  ReceiverEpoch epoch;
  epoch.raw.time = {week, second};
  epoch.raw.observations.reserve(measurements.size());
  for (const Measurement& measurement : measurements) {
    epoch.raw.observations.push_back(measurement.observation);
  }
  if ((status & 1U) != 0) epoch.leap_seconds = leap_seconds;
  epoch.clock_reset = (status & 2U) != 0;
  return epoch;
}

std::optional<Subframe> read_sfrbx(std::string_view payload) {
  if (payload.size() < kSfrbxHeader) return std::nullopt;
  ByteReader in(payload);
  const int system = in.take<std::uint8_t>();
  const int number = in.take<std::uint8_t>();
  const Signal* signal = signal_of(system, in.take<std::uint8_t>());
  const int frequency = in.take<std::uint8_t>();
  const std::size_t count = in.take<std::uint8_t>();
  in.skip(3);  // channel of the receiver, version, reserved
  const bool of_use = signal != nullptr && !signal->b1c && numbered(signal->constellation, number);
  if (payload.size() != kSfrbxHeader + kWord * count || !of_use) return std::nullopt;
  Subframe subframe;
  subframe.satellite = {signal->constellation, number};
  subframe.channel = frequency - kChannelOffset;
  subframe.words.reserve(count);
  for (std::size_t i = 0; i < count; ++i) subframe.words.push_back(in.take<std::uint32_t>());
  return subframe;
}

}  // namespace multipath_localization
