#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/heading_law.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(HeadingLaw, IsDrawnAboutWhatIsDeclaredAndAboutAMounting) {
  int declared_too_low = 0, near = 0, far = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    RandomStream random(3, 0, i);
    HeadingLaw law;
    draw_heading_errors(law, 1.5, random);
    declared_too_low += law.noise > 1.0 ? 1 : 0;
    near += std::abs(law.offset - 1.5) < 0.05 ? 1 : 0;
    far += std::abs(law.offset - 1.5) > 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(declared_too_low, 1000, 150);
  EXPECT_GT(near, 1200) << "most are mounted with a square";
  EXPECT_GT(far, 150) << "not all";
}

TEST(HeadingLaw, ChangesItsNoiseWithinMinutesAndKeepsItsOffset) {
  int changed = 0;
  double furthest = 0.0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    RandomStream random(3, 1, i);
    HeadingLaw law;
    law.offset = 0.2;
    wander(law, 60.0, random);
    changed += law.noise != 1.0 ? 1 : 0;
    furthest = std::max(furthest, std::abs(law.offset - 0.2));
  }
  EXPECT_NEAR(changed, 600, 100);
  EXPECT_LT(furthest, 0.02);
}

}  // namespace
}  // namespace multipath_localization::multipath
