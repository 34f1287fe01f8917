#include <gtest/gtest.h>

#include "tools/doctor/odometry_track.hpp"

namespace multipath_localization {
namespace {

/// Ten seconds at 2 m/s: forwards, then in reverse.
std::vector<OdometryIncrement> there_and_back() {
  std::vector<OdometryIncrement> all;
  for (int i = 1; i <= 100; ++i) all.push_back({100.0 + 0.1 * i, 0.1, i <= 50 ? 2.0 : -2.0, 0.0});
  return all;
}

TEST(OdometryTrack, KnowsThePoseWithinIncrements) {
  const OdometryTrack track(there_and_back());
  EXPECT_NEAR(track.pose(101.03)->x, 2.06, 1e-9);
  EXPECT_NEAR(track.pose(110.0)->x, 0.0, 1e-9);
  EXPECT_FALSE(track.pose(99.9));
  EXPECT_FALSE(track.pose(110.1));
  EXPECT_FALSE(OdometryTrack({}).pose(0.0));
}

TEST(OdometryTrack, WayGrowsInReverseToo) {
  const OdometryTrack track(there_and_back());
  EXPECT_NEAR(*track.distance(105.0), 10.0, 1e-9);
  EXPECT_NEAR(*track.distance(110.0), 20.0, 1e-9);
  EXPECT_FALSE(track.distance(110.1));
}

TEST(Chords, AreAsLongAsAskedForAndFollowEachOther) {
  std::vector<GnssFix> fixes;
  for (int i = 0; i <= 10; ++i) {
    GnssFix fix;
    fix.stamp = 100.05 + 0.5 * i;
    fix.position = {5.0, -0.9 * i};
    fixes.push_back(fix);
  }
  const std::vector<Chord> all = chords(fixes, OdometryTrack(there_and_back()), 3.0);
  ASSERT_GE(all.size(), 2U);
  EXPECT_NEAR(all[0].by_odometry.x(), 3.0, 1.1);
  EXPECT_NEAR(all[0].by_fixes.norm() / all[0].by_odometry.norm(), 0.9, 1e-9);
  EXPECT_EQ(all[1].start, all[0].end);
}

}  // namespace
}  // namespace multipath_localization
