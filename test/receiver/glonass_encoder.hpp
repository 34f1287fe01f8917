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

/// Messages of GLONASS, ICD 5.1, figure 4.3 and tables 4.5, 4.13.
namespace multipath_localization::ubx {

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

}  // namespace multipath_localization::ubx
