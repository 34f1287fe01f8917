#include <gtest/gtest.h>

#include "multipath_localization/localization/receiver_record.hpp"

namespace multipath_localization {
namespace {

TEST(ReceiverRecord, CallsARepeatedFixFrozenOnceTheRobotHasDrivenOn) {
  ReceiverRecord record{ReceiverCovarianceParameters{}};
  GnssFix fix;
  fix.stamp = 1.0;
  Reason reason = Reason::kAccepted;
  record.tell_frozen(fix, 10.0, 2.0, reason);
  EXPECT_EQ(reason, Reason::kAccepted);
  fix.stamp = 2.0;
  reason = Reason::kFrozen;
  record.tell_frozen(fix, 11.0, 2.0, reason);
  EXPECT_EQ(reason, Reason::kRepeated);
  EXPECT_FALSE(record.frozen);
  fix.stamp = 4.0;
  reason = Reason::kFrozen;
  record.tell_frozen(fix, 13.0, 2.0, reason);
  EXPECT_EQ(reason, Reason::kFrozen);
  ASSERT_TRUE(record.frozen);
  EXPECT_EQ(record.frozen->duration, 3.0);
  EXPECT_EQ(record.frozen->driven, 3.0);
}

}  // namespace
}  // namespace multipath_localization
