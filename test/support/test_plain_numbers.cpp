#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "../core/german_locale.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {
namespace {

TEST(GermanLocale, IsOneForStreamsAndForTheCLibrary) {
  {
    const GermanLocale german;
    std::ostringstream stream;
    stream << 1234.5;
    EXPECT_EQ(stream.str(), "1.234,5");
    EXPECT_EQ(std::to_string(0.5), "0,500000");
    EXPECT_EQ(std::strtod("0.5", nullptr), 0.0);
  }
  EXPECT_EQ(std::to_string(0.5), "0.500000");
}

TEST(PlainNumbers, AreWrittenWithAPointInAnyLocale) {
  const GermanLocale german;
  PlainStream stream;
  stream << 1234.5 << " " << 1234567;
  EXPECT_EQ(stream.str(), "1234.5 1234567");
  EXPECT_EQ(plain_text("of ", 0.25, " m"), "of 0.25 m");
  EXPECT_EQ(fixed_text(-1234.5678, 2), "-1234.57");
}

TEST(PlainNumbers, AreReadWithAPointInAnyLocale) {
  const GermanLocale german;
  EXPECT_EQ(parse_number("-1234.5"), -1234.5);
  EXPECT_EQ(parse_number("0,5"), std::nullopt);
  EXPECT_EQ(parse_number("1.5e3"), 1500.0);
}

TEST(PlainNumbers, AreAllOfTheirText) {
  EXPECT_EQ(parse_number(""), std::nullopt);
  EXPECT_EQ(parse_number("1.5 m"), std::nullopt);
  EXPECT_EQ(parse_number(std::string("1.5\0", 4)), std::nullopt);
}

}  // namespace
}  // namespace multipath_localization
