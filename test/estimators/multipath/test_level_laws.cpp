#include <gtest/gtest.h>

#include "estimators/multipath/level_laws.hpp"

namespace multipath_localization::multipath {
namespace {

TEST(LevelLaws, GiveBackTheLawThatHeldAtALevel) {
  LevelLaws laws;
  RandomStream random(3, 0, 0);
  const FixLaw fixed{0.1, 0.2, 0.3};
  FixLaw floating = laws.change(FixLevel::kFixed, FixLevel::kFloat, fixed, random);
  floating.log_white = 2.0;
  const FixLaw again = laws.change(FixLevel::kFloat, FixLevel::kFixed, floating, random);
  EXPECT_EQ(again.log_white, 0.1);
  EXPECT_EQ(again.log_slow, 0.2);
  EXPECT_EQ(laws.change(FixLevel::kFixed, FixLevel::kFloat, again, random).log_white, 2.0);
}

TEST(LevelLaws, ArePartlyTheSameAndPartlyAnyTheFirstTime) {
  int same = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    RandomStream random(3, 1, i);
    LevelLaws laws;
    const FixLaw held{0.1, 0.2, 0.3};
    same += laws.change(FixLevel::kFixed, FixLevel::kFloat, held, random).log_white == 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(same, 500, 80);
}

}  // namespace
}  // namespace multipath_localization::multipath
