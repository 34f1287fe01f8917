#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "receiver/bits.hpp"

namespace multipath_localization {
namespace {

BitString bits_of(const std::string& text) {
  BitString bits;
  for (const char bit : text) bits.append(bit == '1' ? 1 : 0, 1);
  return bits;
}

TEST(BitReader, ReadsFieldAfterField) {
  const BitString bits = bits_of(
      "1011"
      "0"
      "1100"
      "0100");
  BitReader in(bits);
  EXPECT_EQ(in.whole(4), 11U);
  EXPECT_FALSE(in.flag());
  EXPECT_EQ(in.scaled_signed(4, -1), -2.0);
  EXPECT_EQ(in.place(), 9U);
  EXPECT_EQ(in.scaled(4, 3), 32.0);
  EXPECT_THROW(in.flag(), std::out_of_range);
  BitReader magnitude(bits, 5);
  EXPECT_EQ(magnitude.scaled_sign_magnitude(4, 0), -4.0);
  EXPECT_EQ(magnitude.scaled_sign_magnitude(4, 0), 4.0);
}

TEST(BitReader, SkipsAndReadsWideNumbers) {
  BitString bits;
  bits.append(0x123456789ABCDEFULL, 60);
  bits.append(0xFFFFFFFFULL, 32);
  BitReader in(bits);
  EXPECT_EQ(in.whole(60), 0x123456789ABCDEFULL);
  EXPECT_EQ(in.scaled_signed(32, -31), -std::ldexp(1.0, -31));
  BitReader skipping(bits);
  skipping.skip(56);
  EXPECT_EQ(skipping.whole(4), 0xFU);
  skipping.skip(1000);
  EXPECT_THROW(skipping.whole(1), std::out_of_range);
}

TEST(BitString, TakesPartsOfOthers) {
  const BitString other = bits_of("0110");
  BitString bits;
  bits.append(0x5, 3);
  bits.append(other, 1, 2);
  EXPECT_EQ(bits.size(), 5U);
  EXPECT_EQ(BitReader(bits).whole(5), 0x17U);
  EXPECT_THROW(bits.append(other, 3, 2), std::out_of_range);
}

TEST(Crc24q, IsThatOfRtcm) {
  // The message of RTCM 10403's example, a station's coordinates (type 1005), without its CRC.
  BitString bits;
  for (const int byte : {0xD3, 0x00, 0x13, 0x3E, 0xD7, 0xD3, 0x02, 0x02, 0x98, 0x0E, 0xDE,
                         0xEF, 0x34, 0xB4, 0xBD, 0x62, 0xAC, 0x09, 0x41, 0x98, 0x6F, 0x33}) {
    bits.append(static_cast<std::uint64_t>(byte), 8);
  }
  EXPECT_EQ(crc24q(bits, 0, bits.size()), 0x360B98U);
}

}  // namespace
}  // namespace multipath_localization
