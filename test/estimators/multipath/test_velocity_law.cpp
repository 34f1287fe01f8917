#include <gtest/gtest.h>

#include <algorithm>

#include "estimators/multipath/velocity_law.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(VelocityLaw, IsDrawnFromAllDelaysAndAboutWhatIsDeclared) {
  int declared_too_low = 0;
  std::array<int, kDelays> delays{};
  for (std::uint32_t i = 0; i < 2000; ++i) {
    RandomStream random(3, 0, i);
    VelocityLaw law;
    draw_velocity_errors(law, random);
    declared_too_low += law.white > 1.0 ? 1 : 0;
    ++delays.at(law.delay);
    EXPECT_GT(law.slow_time, 0.1);
  }
  EXPECT_NEAR(declared_too_low, 1000, 150);
  EXPECT_GT(*std::min_element(delays.begin(), delays.end()), 200);
}

TEST(VelocityLaw, ChangesWithinMinutes) {
  int changed = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    RandomStream random(3, 1, i);
    VelocityLaw law;
    law.believed = true;
    wander(law, 60.0, random);
    changed += law.white != 1.0 ? 1 : 0;
  }
  EXPECT_GT(changed, 100);
  EXPECT_LT(changed, 400);
}

}  // namespace
}  // namespace multipath_localization::multipath
