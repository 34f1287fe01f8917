#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bit_strings.hpp"
#include "rinex/atmosphere.hpp"
#include "rinex/ephemerides.hpp"

/// Messages of Galileo, OS SIS ICD, tables 38 to 46.
namespace multipath_localization::ubx {

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

}  // namespace multipath_localization::ubx
