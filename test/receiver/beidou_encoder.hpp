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

/// Messages of BeiDou, B1I ICD, figures 5-6 to 5-14 (D1) and 5-16 to 5-26 (D2).
namespace multipath_localization::ubx {

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

}  // namespace multipath_localization::ubx
