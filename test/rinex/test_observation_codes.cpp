#include <gtest/gtest.h>

#include <algorithm>

#include "rinex/observation_codes.hpp"

namespace multipath_localization {
namespace {

/// Tables 12 to 18 of RINEX 3.05: the pseudoranges on L1, G1, E1, B1C, B1A and B1I.
TEST(ObservationCodes, AreAllThatTheFormatHas) {
  const auto expect = [](Constellation of, const std::string& band, const std::string& attributes) {
    const auto codes = pseudorange_codes(of, 3.05);
    for (const char attribute : attributes) {
      const std::string code = "C" + band + attribute;
      EXPECT_EQ(std::count(codes.begin(), codes.end(), code), 1) << to_string(of) << " " << code;
    }
  };
  expect(Constellation::kGps, "1", "CSLXPWYM");
  expect(Constellation::kGlonass, "1", "CP");
  expect(Constellation::kGalileo, "1", "ABCXZ");
  expect(Constellation::kQzss, "1", "CESLXZB");
  expect(Constellation::kBeidou, "2", "IQX");
  expect(Constellation::kBeidou, "1", "DPXSLZ");
}

TEST(ObservationCodes, CivilianOnesComeFirst) {
  EXPECT_EQ(pseudorange_codes(Constellation::kGps, 3.04).front(), "C1C");
  EXPECT_EQ(pseudorange_codes(Constellation::kBeidou, 3.04).front(), "C2I") << "whose group delay is known";
  EXPECT_EQ(pseudorange_codes(Constellation::kGps, 2.11).front(), "C1");
  EXPECT_EQ(pseudorange_codes(Constellation::kBeidou, 2.12), std::vector<std::string>{"C2"});
}

TEST(ObservationCodes, TellB1cFromB1i) {
  for (const char* code : {"C1P", "C1X", "C1D", "C1S"}) EXPECT_TRUE(on_b1c(code, 3.04)) << code;
  for (const char* code : {"C2I", "C2X", "C1I", "C1Q"}) EXPECT_FALSE(on_b1c(code, 3.04)) << code;
  EXPECT_FALSE(on_b1c("C1X", 3.02)) << "which numbers B1I's band 1";
  EXPECT_FALSE(on_b1c("C2", 2.12));
}

}  // namespace
}  // namespace multipath_localization
