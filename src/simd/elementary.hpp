#pragma once

#include <cmath>
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

// Polynomials go by pairs of coefficients: half the latency of Horner's scheme.

/// sin(x) and cos(x) for |x| <= pi / 2: absolute error below 1e-9, like that of all below.
inline SinCos sincos_quarter(double x) {
  const double z = x * x;
  const double zz = z * z;
  const double s = (0.99999999988985219 + z * -0.16666666541439395) +
                   zz * ((0.0083333292644620401 + z * -0.00019840702863036082) +
                         zz * (2.7518855655347254e-06 + z * -2.3794713780265261e-08));
  const double c = (0.99999999978065216 + z * -0.49999999358471177) +
                   zz * ((0.041666636258052426 + z * -0.0013888361400112475) +
                         zz * (2.4760161346665687e-05 + z * -2.6051495140026534e-07));
  return {x * s, c};
}

/// sin and cos of pi t, |t| < 1e6.
inline SinCos sincos_pi(double t) {
  const double shifted = t + kRounding;
  const std::uint64_t half_turns = bits_of(shifted);
  const auto [s, c] = sincos_quarter((t - (shifted - kRounding)) * kPi);
  return {negate_if_odd(s, half_turns), negate_if_odd(c, half_turns)};
}

/// sin(x) / x for |x| <= pi.
inline double sinc(double x) {
  const double z = x * x;
  const double zz = z * z;
  return (0.99999999926382623 + z * -0.16666665931801729) +
         zz * ((0.0083333213530590461 + z * -0.00019840536615066837) +
               zz * ((2.753589932650803e-06 + z * -2.4729256501171175e-08) + zz * 1.3614601577059138e-10));
}

/// tan(x) for |x| < pi / 2: relative error below 1e-9. A quotient of polynomials up to pi / 4, its reciprocal
/// of the complement beyond.
inline double tan(double x) {
  const double size = std::abs(x);
  const bool steep = size > 0.25 * kPi;
  const double t = steep ? 0.5 * kPi - size : size;
  const double z = t * t;
  const double upper = t * (1.0000000000220871 + z * (-0.11136143913814067 + z * 0.0010751546546427364));
  const double lower = 1.0 + z * (-0.44469477080962738 + z * 0.015973391643303001);
  return std::copysign((steep ? lower : upper) / (steep ? upper : lower), x);
}

/// e^x for x <= 700: relative error below 1e-9. Below -700 and for NaN: 0.
inline double exp(double x) {
  const double shifted = x * 1.4426950408889634 + kRounding;
  const double n = shifted - kRounding;
  const double r = x - n * 0.6931471805599453;
  const double rr = r * r;
  const double p = (1.0 + r) + rr * ((0.50000000676427588 + r * 0.16666665869417427) +
                                     rr * ((0.04166629509278027 + r * 0.0083334970084551127) +
                                           rr * (0.0013944648649828942 + r * 0.00019790352255005454)));
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
