#include <gtest/gtest.h>

#include <cmath>

#include "estimators/pseudorange_mixture/motion_law.hpp"

namespace multipath_localization {
namespace {

TEST(MotionLaws, TransitionsAreProbabilities) {
  for (const MotionLaws* laws : {&laws_of_wheels(), &laws_without_wheels()}) {
    for (const double dt : {0.0, 0.1, 1.0, 1000.0}) {
      for (const auto& row : laws->transitions(dt)) {
        double sum = 0.0;
        for (const double probability : row) {
          EXPECT_GE(probability, 0.0);
          sum += probability;
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);
      }
    }
  }
}

TEST(MotionLaws, ALawEndsAtItsRateAndIsFollowedInProportion) {
  MotionLaws laws{};
  laws.leaving = {0.1, 0.0, 0.0, 0.0};
  laws.entering = {5.0, 1.0, 2.0, 1.0};
  const MotionLaws::Matrix transitions = laws.transitions(2.0);
  EXPECT_NEAR(transitions[0][0], std::exp(-0.2), 1e-12);
  EXPECT_NEAR(transitions[0][2], 0.5 * (1.0 - std::exp(-0.2)), 1e-12);
  EXPECT_EQ(transitions[1][1], 1.0);
}

}  // namespace
}  // namespace multipath_localization
