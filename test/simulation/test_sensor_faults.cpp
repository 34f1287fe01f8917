#include <gtest/gtest.h>

#include <cmath>

#include "simulation/sensor_faults.hpp"

namespace multipath_localization {
namespace {

const Eigen::Vector3d kTold(0.5, -1.0, 0.25);

SensorFault fault(const std::string& kind, double size = 0.0) {
  SensorFault made;
  made.start = 10.0;
  made.duration = 5.0;
  made.kind = kind;
  made.size = size;
  return made;
}

SensorFaults faults(const std::string& kind, double size = 0.0) {
  return {{fault(kind, size)}, "gyro", 1, 7, 100.0};
}

TEST(SensorFaults, LeaveAloneWhatIsOutsideTheirTime) {
  for (const char* kind : {"silent", "frozen", "reversed", "offset", "noisy", "late", "not_finite"}) {
    SensorFaults spoiling = faults(kind, 1.0);
    for (const double stamp : {105.0, 116.0}) {
      const auto spoilt = spoiling.spoil(stamp, kTold);
      ASSERT_TRUE(spoilt) << kind;
      EXPECT_EQ(spoilt->value, kTold) << kind;
      EXPECT_EQ(spoilt->delay, 0.0) << kind;
    }
  }
}

TEST(SensorFaults, SpoilByTheirKind) {
  EXPECT_FALSE(faults("silent").spoil(112.0, kTold));
  EXPECT_EQ(faults("reversed").spoil(112.0, kTold)->value, -kTold);
  EXPECT_EQ(faults("late", 0.5).spoil(112.0, kTold)->delay, 0.5);
  EXPECT_EQ(faults("offset", 0.5).spoil(112.0, kTold)->value, kTold + Eigen::Vector3d::Constant(0.5));
  EXPECT_TRUE(std::isnan(faults("not_finite").spoil(112.0, kTold)->value.z()));
  SensorFaults frozen = faults("frozen");
  frozen.spoil(112.0, kTold);
  EXPECT_EQ(frozen.spoil(112.1, 2.0 * kTold)->value, kTold);
}

TEST(SensorFaults, AddNoiseOfTheirSize) {
  SensorFaults noisy = faults("noisy", 0.2);
  double squares = 0.0;
  for (int i = 0; i < 1000; ++i)
    squares += (noisy.spoil(110.0 + 0.001 * i, kTold)->value - kTold).squaredNorm();
  EXPECT_NEAR(std::sqrt(squares / 3000.0), 0.2, 0.01);
}

TEST(SensorFaults, NameWhatIsWrongNow) {
  EXPECT_EQ(faults("frozen").active(112.0), std::vector<std::string>{"gyro: frozen"});
  EXPECT_TRUE(faults("frozen").active(120.0).empty());
}

}  // namespace
}  // namespace multipath_localization
