#include <gtest/gtest.h>

#include <string>

#include "multipath_localization/core/constellation.hpp"

namespace multipath_localization {
namespace {

TEST(Constellation, IsFoundByItsNameWhateverTheCase) {
  for (int i = 0; i < kConstellations; ++i) {
    const auto constellation = static_cast<Constellation>(i);
    std::string name(to_string(constellation));
    EXPECT_EQ(constellation_of(name), constellation);
    for (char& letter : name) letter = static_cast<char>(std::tolower(letter));
    EXPECT_EQ(constellation_of(name), constellation);
  }
}

TEST(Constellation, OfAnyOtherTextIsNone) {
  for (const char* name : {"", "GP", "GPSS", "NAVIC", "1"}) EXPECT_EQ(constellation_of(name), std::nullopt);
}

}  // namespace
}  // namespace multipath_localization
