#include <gtest/gtest.h>

#include "estimators/pseudorange_mixture/mixture_alignment.hpp"

namespace multipath_localization {
namespace {

constexpr double kSure = 0.001;    // variance of a yaw that is known [rad^2]
constexpr double kUnsure = 0.2;    // of one that is not
constexpr double kExpected = 8.0;  // satellites

TEST(MixtureAlignment, TakesAWayWithOneCluster) {
  MixtureAlignment monitor;
  monitor.restart(std::nullopt);
  for (int i = 0; i < 19; ++i) monitor.update(0.99, kSure, 1.0);
  EXPECT_FALSE(monitor.aligned());
  monitor.update(0.99, kSure, 1.0);
  EXPECT_TRUE(monitor.aligned());
}

TEST(MixtureAlignment, TheWayBeginsAnewWithASecondCluster) {
  MixtureAlignment monitor;
  for (int i = 0; i < 19; ++i) monitor.update(0.99, kSure, 1.0);
  monitor.update(0.9, kSure, 1.0);
  monitor.update(0.99, kSure, 1.0);
  EXPECT_FALSE(monitor.aligned());
}

TEST(MixtureAlignment, IsNoneWithoutAHeading) {
  MixtureAlignment monitor;
  for (int i = 0; i < 100; ++i) monitor.update(0.99, kUnsure, 1.0);
  EXPECT_FALSE(monitor.aligned());
}

TEST(MixtureAlignment, EndsWithTheClusterAndNotBefore) {
  MixtureAlignment monitor;
  monitor.restart(kSure);
  EXPECT_TRUE(monitor.aligned()) << "the prior knew the heading";
  monitor.update(0.85, kSure, 1.0);
  EXPECT_TRUE(monitor.aligned());
  monitor.update(0.7, kSure, 1.0);
  EXPECT_FALSE(monitor.aligned());
}

TEST(MixtureAlignment, EndsWhereSatellitesAreMissedForSeconds) {
  MixtureAlignment monitor;
  monitor.restart(kSure);
  monitor.compare(1.0, kExpected, 1.0);
  EXPECT_FALSE(monitor.in_doubt()) << "one epoch";
  for (int i = 0; i < 10; ++i) monitor.compare(1.0, kExpected, 1.0);
  EXPECT_TRUE(monitor.in_doubt());
  monitor.update(0.99, kSure, 1.0);
  EXPECT_FALSE(monitor.aligned());
  for (int i = 0; i < 10; ++i) monitor.compare(kExpected, kExpected, 1.0);
  EXPECT_FALSE(monitor.in_doubt()) << "there is a way back";
}

TEST(MixtureAlignment, APriorWithoutAHeadingAlignsNothing) {
  MixtureAlignment monitor;
  monitor.restart(kUnsure);
  EXPECT_FALSE(monitor.aligned());
}

}  // namespace
}  // namespace multipath_localization
