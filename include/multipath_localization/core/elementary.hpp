#pragma once

#include <cstdint>
#include <cstring>

#include "multipath_localization/core/angle.hpp"

/// Elementary functions without a branch or a table, for loops that a compiler is to vectorise.
namespace multipath_localization::elementary {

inline std::uint64_t bits_of(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

inline double from_bits(std::uint64_t bits) {
  double x = 0.0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// x, negated where `count` is odd: in bits, for want of a comparison of 64-bit integers in SSE2.
inline double negate_if_odd(double x, std::uint64_t count) { return from_bits(bits_of(x) ^ (count << 63U)); }

/// Adding it puts the nearest integer into the low bits of the sum, for |x| < 2^51.
inline constexpr double kRounding = 6755399441055744.0;

inline double round(double x) { return (x + kRounding) - kRounding; }

struct SinCos {
  double sin;
  double cos;
};

/// sin and cos of pi t, |t| < 1e6: absolute error below 1e-11, like that of all below.
inline SinCos sincos_pi(double t) {
  const double shifted = t + kRounding;
  const std::uint64_t half_turns = bits_of(shifted);
  const double r = (t - (shifted - kRounding)) * kPi;
  const double z = r * r;
  const double s =
      0.9999999999999497 + z * (-0.16666666666467156 +
                                z * (0.008333333320381333 +
                                     z * (-0.00019841266686950886 +
                                          z * (2.7556953201090336e-06 +
                                               z * (-2.503027830476107e-08 + z * 1.5411353960495754e-10)))));
  const double c =
      0.9999999999992482 +
      z * (-0.49999999997013095 +
           z * (0.04166666647286715 + z * (-0.0013888884171043153 +
                                           z * (2.4801039947342094e-05 +
                                                z * (-2.752467111247572e-07 + z * 1.9907515352321303e-09)))));
  return {negate_if_odd(r * s, half_turns), negate_if_odd(c, half_turns)};
}

/// sin(x) / x for |x| <= pi.
inline double sinc(double x) {
  const double z = x * x;
  return 0.999999999993218 +
         z * (-0.16666666657839002 +
              z * (0.00833333314478161 +
                   z * (-0.00019841254490312796 +
                        z * (2.7556704778027057e-06 +
                             z * (-2.5038723586677384e-08 +
                                  z * (1.5896781912160256e-10 + z * -6.611013487754748e-13))))));
}

/// tan(x) for |x| < pi / 2: relative error below 1e-11. A Pade approximant up to pi / 4, its reciprocal of
/// the complement beyond.
inline double tan(double x) {
  const double size = x < 0.0 ? -x : x;
  const bool steep = size > 0.25 * kPi;
  const double t = steep ? 0.5 * kPi - size : size;
  const double z = t * t;
  const double upper = t * (135135.0 + z * (-17325.0 + z * (378.0 - z)));
  const double lower = 135135.0 + z * (-62370.0 + z * (3150.0 - 28.0 * z));
  const double tangent = (steep ? lower : upper) / (steep ? upper : lower);
  return x < 0.0 ? -tangent : tangent;
}

/// e^x for x <= 700: relative error below 1e-11. Below -700 and for NaN: 0.
inline double exp(double x) {
  const double shifted = x * 1.4426950408889634 + kRounding;
  const double n = shifted - kRounding;
  const double r = x - n * 0.6931471805599453;
  const double p = 1.0 + r +
                   r * r *
                       (0.499999999995196 +
                        r * (0.16666666786640366 +
                             r * (0.041666667054207455 +
                                  r * (0.008333281267328874 +
                                       r * (0.001388879641863822 +
                                            r * (0.0001990924612601782 + r * 2.488761405097983e-05))))));
  const double scaled = from_bits(bits_of(p) + (bits_of(shifted) << 52U));
  return x >= -700.0 ? scaled : 0.0;
}

/// The natural logarithm of a positive, normal number.
inline double log(double x) {
  constexpr std::uint64_t kOne = 0x3ff0000000000000U;       // bits of 1
  constexpr std::uint64_t kRootHalf = 0x3fe6a09e667f3bcdU;  // bits of sqrt(1/2)
  const std::uint64_t bits = bits_of(x);
  const std::uint64_t exponent =
      (bits + (kOne - kRootHalf)) >> 52U;  // biased, of x / m with m in sqrt(1/2)..sqrt(2)
  const double e = from_bits(exponent | 0x4330000000000000U) - (4503599627370496.0 + 1023.0);
  const double f = from_bits(bits - ((exponent - 1023U) << 52U)) - 1.0;
  const double s = f / (2.0 + f);  // log(1 + f) = 2 atanh(s)
  const double z = s * s;
  return e * 0.6931471805599453 +
         (2.0 * s + s * z *
                        (0.6666666575752995 +
                         z * (0.40000338917889694 + z * (0.2853605210868416 + z * 0.2361741675999051))));
}

/// The angle in [-pi, pi], |angle| < 1e6.
inline double wrap(double angle) { return angle - 2.0 * kPi * round(angle * (0.5 / kPi)); }

/// The same in single precision, twice as many at a time, for random deviates: absolute error below 3e-7.
namespace single {

inline std::uint32_t bits_of(float x) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

inline float from_bits(std::uint32_t bits) {
  float x = 0.0F;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

struct SinCos {
  float sin;
  float cos;
};

/// sin and cos of pi t, |t| <= 1.
inline SinCos sincos_pi(float t) {
  const float shifted = t + 12582912.0F;
  const std::uint32_t sign = bits_of(shifted) << 31U;  // of a whole number of half turns
  const float r = (t - (shifted - 12582912.0F)) * static_cast<float>(kPi);
  const float z = r * r;
  const float s =
      1.0F + z * (-1.6666658e-1F + z * (8.3330497e-3F + z * (-1.9809017e-4F + z * 2.6051077e-6F)));
  const float c =
      1.0F +
      z * (-0.5F + z * (4.1666634e-2F + z * (-1.3888361e-3F + z * (2.4760109e-5F + z * -2.6050657e-7F))));
  return {from_bits(bits_of(r * s) ^ sign), from_bits(bits_of(c) ^ sign)};
}

/// The natural logarithm of 2^-32 <= x <= 1: relative error below 2e-7.
inline float log(float x) {
  const auto exponent =
      static_cast<std::int32_t>(bits_of(x) - 0x3f3504f3U) >> 23;  // of x / m, m in sqrt(1/2)..sqrt(2)
  const float f = from_bits(bits_of(x) - (static_cast<std::uint32_t>(exponent) << 23U)) - 1.0F;
  const float z = f * f;
  const float p =
      0.33333856F +
      f * (-0.250017454F +
           f * (0.199654663F +
                f * (-0.165656941F + f * (0.148763658F + f * (-0.143496528F + f * 0.0891883178F)))));
  return static_cast<float>(exponent) * 0.69314718056F + (f - 0.5F * z + f * z * p);
}

}  // namespace single

}  // namespace multipath_localization::elementary
