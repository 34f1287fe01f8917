#include <gtest/gtest.h>

#include <cmath>

#include "multipath_localization/localization/last_accepted.hpp"

namespace multipath_localization {
namespace {

Measurement fix_at(double stamp) {
  GnssFix fix;
  fix.stamp = stamp;
  return fix;
}

Measurement epoch_at(double stamp) {
  PseudorangeEpoch epoch;
  epoch.stamp = stamp;
  return epoch;
}

TEST(LastAccepted, KeepsTheLatestStampOfAll) {
  LastAccepted accepted;
  EXPECT_TRUE(std::isinf(accepted.stamp()));
  accepted.note(fix_at(5.0));
  accepted.note(fix_at(4.0));
  EXPECT_EQ(accepted.stamp(), 5.0);
  EXPECT_EQ(accepted.kind(), "fixes");
  accepted.note(epoch_at(6.0));
  EXPECT_EQ(accepted.stamp(), 6.0);
  EXPECT_EQ(accepted.kind(), "pseudoranges");
}

TEST(LastAccepted, VelocitiesAndHeadingsTellNoPosition) {
  LastAccepted accepted;
  accepted.note(fix_at(5.0));
  GnssVelocity velocity;
  velocity.stamp = 9.0;
  accepted.note(velocity);
  accepted.note(Heading{9.0, 0.0, 0.01});
  EXPECT_EQ(accepted.stamp(), 5.0);
}

TEST(LastAccepted, MissesWhatSaysMoreThanTheLatest) {
  LastAccepted accepted;
  accepted.note(fix_at(5.0));
  EXPECT_EQ(accepted.missed(100.0, 3.0), "") << "there never were pseudoranges";
  accepted.note(epoch_at(6.0));
  EXPECT_EQ(accepted.missed(100.0, 3.0), "") << "they are the latest";
  accepted.note(fix_at(7.0));
  EXPECT_EQ(accepted.missed(8.0, 3.0), "");
  EXPECT_EQ(accepted.missed(18.0, 3.0), ", no pseudoranges for 12 s");
}

}  // namespace
}  // namespace multipath_localization
