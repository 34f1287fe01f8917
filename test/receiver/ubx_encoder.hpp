#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "beidou_encoder.hpp"
#include "bit_strings.hpp"
#include "galileo_encoder.hpp"
#include "glonass_encoder.hpp"
#include "gps_encoder.hpp"
#include "rinex/ephemerides.hpp"
#include "rinex/observation_file.hpp"

/// What a u-blox receiver sends, made from what it heard: the way back of src/receiver, after the interface
/// specifications of u-blox, IS-GPS-200, the Galileo OS SIS ICD, BeiDou's B1I ICD and GLONASS's ICD 5.1.
namespace multipath_localization::ubx {

// UBX, u-blox ZED-F9P interface description.

template <class Number>
void put(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &number, sizeof(number));
  bytes.append(raw.data(), raw.size());
}

inline std::string frame(std::uint8_t kind, std::uint8_t id, const std::string& payload) {
  std::string body = {static_cast<char>(kind), static_cast<char>(id)};
  put(body, static_cast<std::uint16_t>(payload.size()));
  body += payload;
  std::uint8_t a = 0, b = 0;
  for (const char byte : body) {
    a = static_cast<std::uint8_t>(a + static_cast<unsigned char>(byte));
    b = static_cast<std::uint8_t>(b + a);
  }
  return "\xb5\x62" + body + static_cast<char>(a) + static_cast<char>(b);
}

inline std::uint8_t system_of(Constellation constellation) {
  constexpr std::array<std::uint8_t, kConstellations> kSystems = {0, 6, 2, 3, 5};
  return kSystems[static_cast<std::size_t>(constellation)];
}

inline std::string sfrbx_payload(const SatelliteId& satellite, const Words& words, int channel = 0,
                                 int signal = 0) {
  std::string payload;
  for (const int byte : {static_cast<int>(system_of(satellite.constellation)), satellite.number, signal,
                         channel + 7, static_cast<int>(words.size()), 3, 2, 0}) {
    put(payload, static_cast<std::uint8_t>(byte));
  }
  for (const std::uint32_t word : words) put(payload, word);
  return payload;
}

/// One measurement as 32 bytes.
inline std::string measurement(const RawObservation& raw, int signal, int channel = 0, bool valid = true) {
  std::string bytes;
  put(bytes, raw.pseudorange);
  put(bytes, raw.pseudorange / 0.19);
  put(bytes, static_cast<float>(std::isnan(raw.doppler) ? 0.0 : raw.doppler));
  for (const int byte : {static_cast<int>(system_of(raw.satellite.constellation)), raw.satellite.number,
                         signal, channel + 7}) {
    put(bytes, static_cast<std::uint8_t>(byte));
  }
  put(bytes, std::uint16_t{64500});
  for (const int byte : {std::isnan(raw.cn0) ? 0 : static_cast<int>(raw.cn0), 5, 1, 2, valid ? 7 : 6, 0}) {
    put(bytes, static_cast<std::uint8_t>(byte));
  }
  return bytes;
}

/// `measurements`: 32 bytes each.
inline std::string rawx_payload(const GnssTime& time, const std::string& measurements, int status = 1,
                                int leap_seconds = 18) {
  std::string payload;
  put(payload, time.second);
  put(payload, static_cast<std::uint16_t>(time.week));
  put(payload, static_cast<std::int8_t>(leap_seconds));
  put(payload, static_cast<std::uint8_t>(measurements.size() / 32));
  put(payload, static_cast<std::uint8_t>(status));
  return payload + std::string("\1\0\0", 3) + measurements;
}

inline std::string rawx(const RawEpoch& epoch) {
  std::string measurements;
  for (const RawObservation& raw : epoch.observations) measurements += measurement(raw, raw.b1c ? 5 : 0);
  return frame(2, 0x15, rawx_payload(epoch.time, measurements));
}

inline std::string sfrbx(const SatelliteId& satellite, const std::vector<Words>& all, int channel = 0) {
  const int signal = satellite.constellation == Constellation::kGalileo ? 1 : 0;
  std::string bytes;
  for (const Words& words : all) bytes += frame(2, 0x13, sfrbx_payload(satellite, words, channel, signal));
  return bytes;
}

/// All that the satellite sends of its ephemeris from `sent` on.
inline std::vector<Words> broadcast(const Ephemeris& ephemeris, const GnssTime& sent) {
  if (const auto* glonass = std::get_if<GlonassOrbit>(&ephemeris)) {
    return glonass_strings(*glonass, leap_seconds_at(glonass->reference));
  }
  const auto& orbit = std::get<BroadcastOrbit>(ephemeris);
  const int issue = static_cast<int>(orbit.toe / 600.0) % 256;
  switch (orbit.satellite.constellation) {
    case Constellation::kGalileo: {
      const std::vector<Words> words = galileo_words(orbit, sent, {issue});
      const std::vector<Words> others = galileo_other_words(sent);
      return {words[1], words[3], others[1], words[0], words[2], words[4], others[0]};
    }
    case Constellation::kBeidou:
      return geostationary(orbit.satellite) ? beidou_d2(orbit, sent) : beidou_d1(orbit, sent);
    default: return gps_subframes(orbit, sent, {issue});
  }
}

inline SatelliteId satellite_of(const Ephemeris& ephemeris) {
  return std::visit([](const auto& orbit) { return orbit.satellite; }, ephemeris);
}

inline std::string sfrbx(const Ephemeris& ephemeris, const GnssTime& sent) {
  const auto* glonass = std::get_if<GlonassOrbit>(&ephemeris);
  return sfrbx(satellite_of(ephemeris), broadcast(ephemeris, sent),
               glonass == nullptr ? 0 : glonass->channel);
}

}  // namespace multipath_localization::ubx
