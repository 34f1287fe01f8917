#include <gtest/gtest.h>

#include "../good_fix.hpp"
#include "ros/localization_node/antenna_placement.hpp"
#include "ros/messages/conversions.hpp"

namespace multipath_localization {
namespace {

class Placement : public testing::Test {
 protected:
  void place(double x, double y) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "base_link";
    transform.child_frame_id = "gps";
    transform.transform = to_transform({x, y, 0.0});
    frames_.add(transform, true);
  }

  AntennaFrames frames_{{}};
  AntennaPlacement placement_{frames_, GnssParameters()};
  const GnssMessage fix_ = good_fix();  // of the frame gps
};

TEST_F(Placement, AMessageWaitsAMomentForAFrameThatNobodyHasToldOf) {
  EXPECT_TRUE(placement_.waits(fix_, 10.0, 100.0));
  EXPECT_TRUE(placement_.waits(fix_, 10.0 + 0.9 * FramePatience::kPatience, 100.1));
  EXPECT_FALSE(placement_.waits(fix_, 10.0 + 1.1 * FramePatience::kPatience, 100.2));
}

TEST_F(Placement, NoMessageWaitsForAFrameThatIsPlaced) {
  place(0.5, 0.0);
  EXPECT_FALSE(placement_.waits(fix_, 10.0, 100.0));
}

TEST_F(Placement, AnAntennaAppearsOnceWhereItWasNotTakenToBe) {
  placement_.assume(fix_);
  EXPECT_FALSE(placement_.appeared(fix_)) << "nobody has placed it";
  place(0.5, 0.0);
  EXPECT_TRUE(placement_.appeared(fix_));
  EXPECT_FALSE(placement_.appeared(fix_));
}

TEST_F(Placement, AnAntennaThatIsWhereItWasTakenToBeChangesNothing) {
  placement_.assume(fix_);
  place(0.01, 0.0);
  EXPECT_FALSE(placement_.appeared(fix_));
}

TEST_F(Placement, NothingIsAssumedOfAnAntennaThatIsPlaced) {
  place(0.5, 0.0);
  placement_.assume(fix_);
  EXPECT_FALSE(placement_.appeared(fix_));
}

}  // namespace
}  // namespace multipath_localization
