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

/// The one where the lowest bit of `choice` is set, else the other: in bits, for want of a comparison of
/// 64-bit integers in SSE2.
inline double select(std::uint64_t choice, double one, double other) {
  const std::uint64_t mask = std::uint64_t{0} - (choice & 1U);
  return from_bits((bits_of(one) & mask) | (bits_of(other) & ~mask));
}

/// x, negated where the bit of weight 2 of `quadrant` is set.
inline double flip_sign(double x, std::uint64_t quadrant) {
  return from_bits(bits_of(x) ^ ((quadrant & 2U) << 62U));
}

/// Adding it puts the nearest integer into the low bits of the sum, for |x| < 2^51.
inline constexpr double kRounding = 6755399441055744.0;

inline double round(double x) { return (x + kRounding) - kRounding; }

struct SinCos {
  double sin;
  double cos;
};

/// sin and cos of pi t, |t| < 1e6: absolute error below 1e-11, like that of all below.
inline SinCos sincos_pi(double t) {
  const double shifted = 2.0 * t + kRounding;
  const std::uint64_t quadrant = bits_of(shifted);
  const double r = (t - 0.5 * (shifted - kRounding)) * kPi;
  const double z = r * r;
  const double s =
      r + r * z *
              (-0.1666666664421115 +
               z * (0.00833332932790438 + z * (-0.00019839261153553107 + z * 2.717345650842148e-06)));
  const double c = 1.0 - 0.5 * z +
                   z * z *
                       (0.04166666664792706 + z * (-0.0013888885546465954 +
                                                   z * (2.479991133138164e-05 + z * -2.723713530631061e-07)));
  return {flip_sign(select(quadrant, c, s), quadrant), flip_sign(select(quadrant, s, c), quadrant + 1)};
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
  const double r = (x - n * 6.93145751953125e-1) - n * 1.42860682030941723212e-6;
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

/// The same in single precision, twice as many at a time, for random deviates: absolute error below 2e-7.
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
  const float shifted = 2.0F * t + 12582912.0F;
  const std::uint32_t quadrant = bits_of(shifted);
  const float r = (t - 0.5F * (shifted - 12582912.0F)) * static_cast<float>(kPi);
  const float z = r * r;
  const float s = r + r * z * (-1.6666654671e-1F + z * (8.332100708e-3F + z * -1.950392966e-4F));
  const float c = 1.0F - 0.5F * z + z * z * (4.166665465e-2F + z * (-1.388765414e-3F + z * 2.44638036e-5F));
  const bool odd = (quadrant & 1U) != 0;
  return {from_bits(bits_of(odd ? c : s) ^ ((quadrant & 2U) << 30U)),
          from_bits(bits_of(odd ? s : c) ^ (((quadrant + 1U) & 2U) << 30U))};
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
