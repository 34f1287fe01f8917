#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "multipath_localization/core/angle.hpp"
#include "rinex/atmosphere.hpp"
#include "rinex/ephemerides.hpp"
#include "rinex/observation_file.hpp"

/// What a u-blox receiver sends, made from what it heard: the way back of src/receiver, after the interface
/// specifications of u-blox, IS-GPS-200, the Galileo OS SIS ICD, BeiDou's B1I ICD and GLONASS's ICD 5.1.
namespace multipath_localization::ubx {

using Words = std::vector<std::uint32_t>;

/// Bits one after the other, as '0' and '1'.
class Bits {
 public:
  Bits& put(std::int64_t value, int width) {
    for (int i = width - 1; i >= 0; --i) text_ += (value >> i & 1) != 0 ? '1' : '0';
    return *this;
  }
  /// `value` in units of 2^`exponent`, in two's complement or without sign.
  Bits& scaled(double value, int width, int exponent) {
    return put(std::llround(std::ldexp(value, -exponent)), width);
  }
  Bits& angle(double radians, int width, int exponent) { return scaled(radians / kPi, width, exponent); }
  /// The first bit is the sign, the others the magnitude.
  Bits& sign_magnitude(double value, int width, int exponent) {
    put(std::signbit(value) ? 1 : 0, 1);
    return scaled(std::abs(value), width - 1, exponent);
  }
  Bits& add(const std::string& bits) {
    text_ += bits;
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::string part(std::size_t first, std::size_t count) const {
    return text_.substr(first, count);
  }

 private:
  std::string text_;
};

inline std::int64_t number_of(const std::string& bits) {
  std::int64_t value = 0;
  for (const char bit : bits) value = 2 * value + (bit - '0');
  return value;
}

/// Words of 32 bits, the last filled up.
inline Words words_of(std::string bits) {
  while (bits.size() % 32 != 0) bits += '0';
  Words words;
  for (std::size_t i = 0; i < bits.size(); i += 32) {
    words.push_back(static_cast<std::uint32_t>(number_of(bits.substr(i, 32))));
  }
  return words;
}

/// Padding and parity, of which nothing is to be assumed, are set to something.
inline std::uint32_t padded(const std::string& data, int parity) {
  const auto value = static_cast<std::uint32_t>(number_of(data));
  return 3U << 30 | value << parity | ((1U << parity) - 1U) / 3U;
}

inline std::int64_t week_second(const GnssTime& time) { return std::llround(time.second); }

// ---- GPS and QZSS, IS-GPS-200, figure 20-1 and tables 20-I and 20-III.

inline Bits gps_head(int number, const GnssTime& sent) {
  Bits bits;
  bits.put(0x8B, 8).put(0, 16);
  return bits.put(week_second(sent) / 6 + 1, 17).put(0, 2).put(number, 3).put(0, 2);
}

inline Words gps_words(const Bits& bits) {
  Words words;
  for (std::size_t i = 0; i < 10; ++i) words.push_back(padded(bits.part(24 * i, 24), 6));
  return words;
}

struct GpsCodes {
  int issue = 77;
  int health = 0;
};

inline std::vector<Words> gps_subframes(const BroadcastOrbit& orbit, const GnssTime& sent,
                                        GpsCodes codes = {}) {
  const Eigen::Vector3d& a = orbit.clock_polynomial;
  Bits one = gps_head(1, sent);
  one.put(sent.week % 1024, 10).put(1, 2).put(2, 4).put(orbit.healthy ? codes.health : 32, 6).put(0, 2);
  one.put(0, 88).scaled(orbit.group_delay, 8, -31).put(codes.issue, 8);
  one.scaled(orbit.clock_reference.second, 16, 4).scaled(a(2), 8, -55).scaled(a(1), 16, -43);
  one.scaled(a(0), 22, -31).put(0, 2);
  Bits two = gps_head(2, sent);
  two.put(codes.issue, 8).scaled(orbit.radius_correction.x(), 16, -5);
  two.angle(orbit.mean_motion_difference, 16, -43).angle(orbit.mean_anomaly, 32, -31);
  two.scaled(orbit.latitude_correction.y(), 16, -29).scaled(orbit.eccentricity, 32, -33);
  two.scaled(orbit.latitude_correction.x(), 16, -29).scaled(orbit.root_axis, 32, -19);
  two.scaled(orbit.toe, 16, 4).put(0, 8);
  Bits three = gps_head(3, sent);
  three.scaled(orbit.inclination_correction.y(), 16, -29).angle(orbit.node, 32, -31);
  three.scaled(orbit.inclination_correction.x(), 16, -29).angle(orbit.inclination, 32, -31);
  three.scaled(orbit.radius_correction.y(), 16, -5).angle(orbit.perigee, 32, -31);
  three.angle(orbit.node_rate, 24, -43).put(codes.issue, 8).angle(orbit.inclination_rate, 14, -43).put(0, 2);
  return {gps_words(one), gps_words(two), gps_words(three)};
}

inline Words gps_ionosphere_page(const KlobucharCoefficients& ionosphere, const GnssTime& sent) {
  Bits four = gps_head(4, sent);
  four.put(1, 2).put(56, 6);
  constexpr std::array<int, 4> kAlpha = {-30, -27, -24, -24}, kBeta = {11, 14, 16, 16};
  for (std::size_t i = 0; i < 4; ++i) four.scaled(ionosphere.alpha(static_cast<int>(i)), 8, kAlpha[i]);
  for (std::size_t i = 0; i < 4; ++i) four.scaled(ionosphere.beta(static_cast<int>(i)), 8, kBeta[i]);
  return gps_words(four.put(0, 24 * 5));
}

// ---- Galileo, OS SIS ICD, tables 38 to 46.

/// By long division.
inline std::int64_t crc24q_of(std::string bits) {
  const std::string generator = "1100001100100110011111011";
  const std::size_t count = bits.size();
  bits += std::string(24, '0');
  for (std::size_t i = 0; i < count; ++i) {
    if (bits[i] == '0') continue;
    for (std::size_t j = 0; j < generator.size(); ++j) bits[i + j] = bits[i + j] == generator[j] ? '0' : '1';
  }
  return number_of(bits.substr(count));
}

inline Words galileo_pages(const Bits& word) {
  Bits even, odd;
  even.put(0, 2).add(word.part(0, 112));
  odd.put(2, 2).add(word.part(112, 16)).put(0x5A5A5A5A5A, 40).put(0, 24);
  odd.put(crc24q_of(even.text() + odd.text()), 24);
  even.put(0, 14);
  return words_of(even.text() + odd.put(0, 22).text() + std::string(32, '1'));  // u-blox sends one word more
}

struct GalileoCodes {
  int issue = 77;
  int health = 0;    ///< of E1 B
  int validity = 0;  ///< of its data
  int accuracy = 107;
};

inline std::vector<Words> galileo_words(const BroadcastOrbit& orbit, const GnssTime& sent,
                                        GalileoCodes codes = {}) {
  const Eigen::Vector3d& a = orbit.clock_polynomial;
  std::array<Bits, 5> words;
  for (int i = 0; i < 4; ++i) words[static_cast<std::size_t>(i)].put(i + 1, 6).put(codes.issue, 10);
  words[0].put(std::llround(orbit.toe / 60.0), 14).angle(orbit.mean_anomaly, 32, -31);
  words[0].scaled(orbit.eccentricity, 32, -33).scaled(orbit.root_axis, 32, -19).put(0, 2);
  words[1].angle(orbit.node, 32, -31).angle(orbit.inclination, 32, -31).angle(orbit.perigee, 32, -31);
  words[1].angle(orbit.inclination_rate, 14, -43).put(0, 2);
  words[2].angle(orbit.node_rate, 24, -43).angle(orbit.mean_motion_difference, 16, -43);
  words[2].scaled(orbit.latitude_correction.y(), 16, -29).scaled(orbit.latitude_correction.x(), 16, -29);
  words[2].scaled(orbit.radius_correction.y(), 16, -5).scaled(orbit.radius_correction.x(), 16, -5);
  words[2].put(codes.accuracy, 8);
  words[3].put(orbit.satellite.number, 6).scaled(orbit.inclination_correction.y(), 16, -29);
  words[3].scaled(orbit.inclination_correction.x(), 16, -29);
  words[3].put(std::llround(orbit.clock_reference.second / 60.0), 14);
  words[3].scaled(a(0), 31, -34).scaled(a(1), 21, -46).scaled(a(2), 6, -59).put(0, 2);
  words[4].put(5, 6).put(0, 41).put(0, 10).scaled(orbit.group_delay, 10, -32).put(0, 2);
  words[4].put(orbit.healthy ? codes.health : 1, 2).put(0, 1).put(codes.validity, 1);
  words[4].put(sent.week - 1024, 12).put(week_second(sent), 20).put(0, 23);
  std::vector<Words> pages;
  for (const Bits& word : words) pages.push_back(galileo_pages(word));
  return pages;
}

/// The words that are of no ephemeris: spare with the time, and offsets between scales of time.
inline std::vector<Words> galileo_other_words(const GnssTime& sent) {
  Bits spare, offsets;
  spare.put(0, 6).put(2, 2).put(0, 88).put(sent.week - 1024, 12).put(week_second(sent), 20);
  offsets.put(6, 6).put(0, 99).put(week_second(sent), 20).put(0, 3);
  return {galileo_pages(spare), galileo_pages(offsets)};
}

// ---- BeiDou, B1I ICD, figures 5-6 to 5-14 (D1) and 5-16 to 5-26 (D2).

inline Words beidou_words(const Bits& bits) {
  Words words = {padded(bits.part(0, 26), 4)};
  for (std::size_t i = 0; i < 9; ++i) words.push_back(padded(bits.part(26 + 22 * i, 22), 8));
  return words;
}

inline Bits beidou_head(int frame, std::int64_t second) {
  Bits bits;
  return bits.put(0x712, 11).put(0, 4).put(frame, 3).put(second, 20);
}

/// Health to the delay of B2I, which D1 and D2 begin with alike.
inline void put_beidou_health(const BroadcastOrbit& orbit, const GnssTime& sent, Bits& bits) {
  const GnssTime toc = orbit.clock_reference + -14.0;
  bits.put(orbit.healthy ? 0 : 1, 1).put(1, 5).put(2, 4).put((sent + -14.0).week - 1356, 13);
  bits.put(week_second(toc) / 8, 17).put(std::llround(orbit.group_delay * 1e10), 10).put(-100, 10);
}

inline std::vector<Words> beidou_d1(const BroadcastOrbit& orbit, const GnssTime& sent) {
  const Eigen::Vector3d& a = orbit.clock_polynomial;
  const std::int64_t second = week_second(sent + -14.0) / 30 * 30;
  const std::int64_t toe = std::llround(orbit.toe / 8.0);
  Bits one = beidou_head(1, second);
  put_beidou_health(orbit, sent, one);
  one.put(0, 64).scaled(a(2), 11, -66).scaled(a(0), 24, -33).scaled(a(1), 22, -50).put(1, 5);
  Bits two = beidou_head(2, second + 6);
  two.angle(orbit.mean_motion_difference, 16, -43).scaled(orbit.latitude_correction.y(), 18, -31);
  two.angle(orbit.mean_anomaly, 32, -31).scaled(orbit.eccentricity, 32, -33);
  two.scaled(orbit.latitude_correction.x(), 18, -31).scaled(orbit.radius_correction.y(), 18, -6);
  two.scaled(orbit.radius_correction.x(), 18, -6).scaled(orbit.root_axis, 32, -19).put(toe >> 15, 2);
  Bits three = beidou_head(3, second + 12);
  three.put(toe & 0x7FFF, 15).angle(orbit.inclination, 32, -31);
  three.scaled(orbit.inclination_correction.y(), 18, -31).angle(orbit.node_rate, 24, -43);
  three.scaled(orbit.inclination_correction.x(), 18, -31).angle(orbit.inclination_rate, 14, -43);
  three.angle(orbit.node, 32, -31).angle(orbit.perigee, 32, -31).put(0, 1);
  return {beidou_words(one), beidou_words(two), beidou_words(three)};
}

inline std::vector<Words> beidou_d2(const BroadcastOrbit& orbit, const GnssTime& sent) {
  const Eigen::Vector3d& a = orbit.clock_polynomial;
  const std::int64_t second = week_second(sent + -14.0) / 30 * 30;
  const auto field = [](double value, int width, int exponent) {
    return Bits().scaled(value, width, exponent).text();
  };
  const auto angle = [](double value, int width, int exponent) {
    return Bits().angle(value, width, exponent).text();
  };
  const std::string a1 = field(a(1), 22, -50), cuc = field(orbit.latitude_correction.y(), 18, -31);
  const std::string e = field(orbit.eccentricity, 32, -33), i0 = angle(orbit.inclination, 32, -31);
  const std::string cic = field(orbit.inclination_correction.y(), 18, -31);
  const std::string node_rate = angle(orbit.node_rate, 24, -43), perigee = angle(orbit.perigee, 32, -31);
  std::vector<Bits> pages;
  for (int i = 0; i < 10; ++i) pages.push_back(beidou_head(1, second + 3 * i).put(i + 1, 4));
  put_beidou_health(orbit, sent, pages[0]);
  pages[2].put(0, 38).add(field(a(0), 24, -33)).add(a1.substr(0, 4));
  pages[3].add(a1.substr(4)).add(field(a(2), 11, -66)).put(1, 5);
  pages[3].add(angle(orbit.mean_motion_difference, 16, -43)).add(cuc.substr(0, 14));
  pages[4].add(cuc.substr(14)).add(angle(orbit.mean_anomaly, 32, -31));
  pages[4].add(field(orbit.latitude_correction.x(), 18, -31)).add(e.substr(0, 10));
  pages[5].add(e.substr(10)).add(field(orbit.root_axis, 32, -19)).add(cic.substr(0, 10));
  pages[6].add(cic.substr(10)).add(field(orbit.inclination_correction.x(), 18, -31));
  pages[6].put(std::llround(orbit.toe / 8.0), 17).add(i0.substr(0, 21));
  pages[7].add(i0.substr(21)).add(field(orbit.radius_correction.y(), 18, -6));
  pages[7].add(field(orbit.radius_correction.x(), 18, -6)).add(node_rate.substr(0, 19));
  pages[8].add(node_rate.substr(19)).add(angle(orbit.node, 32, -31)).add(perigee.substr(0, 27));
  pages[9].add(perigee.substr(27)).add(angle(orbit.inclination_rate, 14, -43));
  std::vector<Words> words;
  for (Bits& page : pages) {
    page.put(0, static_cast<int>(224 - page.text().size()));
    words.push_back(beidou_words(page));
  }
  return words;
}

// ---- GLONASS, ICD 5.1, figure 4.3 and tables 4.5, 4.13.

/// The bits of a string that each check bit is of, numbered from its end as the ICD does.
inline const std::array<std::vector<int>, 7>& glonass_checks() {
  const auto ranges = [](std::vector<std::pair<int, int>> all) {
    std::vector<int> bits;
    for (const auto& [first, last] : all) {
      for (int i = first; i <= last; ++i) bits.push_back(i);
    }
    return bits;
  };
  static const std::array<std::vector<int>, 7> checks = {
      std::vector<int>{9,  10, 12, 13, 15, 17, 19, 20, 22, 24, 26, 28, 30, 32, 34, 35, 37, 39, 41, 43, 45,
                       47, 49, 51, 53, 55, 57, 59, 61, 63, 65, 66, 68, 70, 72, 74, 76, 78, 80, 82, 84},
      std::vector<int>{9,  11, 12, 14, 15, 18, 19, 21, 22, 25, 26, 29, 30, 33, 34, 36, 37, 40, 41, 44, 45,
                       48, 49, 52, 53, 56, 57, 60, 61, 64, 65, 67, 68, 71, 72, 75, 76, 79, 80, 83, 84},
      ranges({{10, 12},
              {16, 19},
              {23, 26},
              {31, 34},
              {38, 41},
              {46, 49},
              {54, 57},
              {62, 65},
              {69, 72},
              {77, 80},
              {85, 85}}),
      ranges({{13, 19}, {27, 34}, {42, 49}, {58, 65}, {73, 80}}),
      ranges({{20, 34}, {50, 65}, {81, 85}}),
      ranges({{35, 65}}),
      ranges({{66, 85}})};
  return checks;
}

/// With its check bits.
inline Words glonass_words(const Bits& data) {
  const auto bit = [&](int number) { return data.text()[static_cast<std::size_t>(85 - number)] == '1'; };
  std::string checks;  // bit 1 first
  bool odd = false;
  for (const auto& check : glonass_checks()) {
    bool sum = false;
    for (const int number : check) sum = sum != bit(number);
    checks += sum ? '1' : '0';
    odd = odd != sum;
  }
  for (int number = 9; number <= 85; ++number) odd = odd != bit(number);
  checks += odd ? '1' : '0';
  return words_of(data.text() + std::string(checks.rbegin(), checks.rend()) + std::string(11, '0') +
                  "0000000000000001" + std::string(12, '0') + "0001");
}

inline std::vector<Words> glonass_strings(const GlonassOrbit& orbit, int leap_seconds) {
  const double of_day = std::fmod(orbit.reference.second - leap_seconds + 3 * 3600.0, 86400.0);
  const auto head = [](int number) { return Bits().put(0, 1).put(number, 4); };
  const auto put_axis = [&](Bits& bits, int axis) {
    bits.sign_magnitude(orbit.velocity(axis) / 1e3, 24, -20);
    bits.sign_magnitude(orbit.acceleration(axis) / 1e3, 5, -30);
    bits.sign_magnitude(orbit.position(axis) / 1e3, 27, -11);
  };
  Bits one = head(1).put(0, 2).put(1, 2);
  const auto minutes = static_cast<std::int64_t>(of_day) / 60;
  one.put(minutes / 60, 5).put(minutes % 60, 6).put(0, 1);
  put_axis(one, 0);
  Bits two = head(2).put(orbit.healthy ? 0 : 4, 3).put(1, 1).put(std::llround(of_day / 900.0), 7).put(0, 5);
  put_axis(two, 1);
  Bits three = head(3).put(1, 1).sign_magnitude(orbit.clock_drift, 11, -40).put(0, 1).put(3, 2).put(0, 1);
  put_axis(three, 2);
  // The day counts from that which began the leap year: 1 January 2024 for those of broadcast.hpp.
  Bits four = head(4).sign_magnitude(-orbit.clock, 22, -30).put(0, 5).put(0, 5).put(0, 14).put(0, 1);
  four.put(4, 4).put(0, 3).put(176, 11).put(orbit.satellite.number, 5).put(1, 2);
  return {glonass_words(one), glonass_words(two), glonass_words(three), glonass_words(four)};
}

// ---- UBX, u-blox ZED-F9P interface description.

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
