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

/// Messages of GPS and QZSS, IS-GPS-200, figure 20-1 and tables 20-I and 20-III.
namespace multipath_localization::ubx {

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

}  // namespace multipath_localization::ubx
