#include <gtest/gtest.h>

#include "evaluation/spoilt_drive.hpp"

namespace multipath_localization {
namespace {

constexpr double kStart = 1e9;

/// Ten seconds of odometry at 10 Hz and fixes at 2 Hz that arrive at once, with an epoch beside each.
Drive drive() {
  Drive drive;
  for (int i = 0; i <= 100; ++i) {
    const double stamp = kStart + 0.1 * i;
    drive.odometry.push_back({stamp, 0.1, 1.0, 0.0});
    if (i % 5 != 0) continue;
    GnssFix fix;
    fix.stamp = stamp;
    fix.position = {0.1 * i, 0.0};
    PseudorangeEpoch epoch;
    epoch.stamp = stamp;
    drive.measurements.push_back({fix, stamp});
    drive.measurements.push_back({epoch, stamp});
  }
  return drive;
}

TEST(SpoiltDrive, WithoutFaultsIsTheDrive) {
  const Drive clean = drive();
  const Drive same = spoilt(clean, {}, 1);
  ASSERT_EQ(same.odometry.size(), clean.odometry.size());
  ASSERT_EQ(same.measurements.size(), clean.measurements.size());
  for (std::size_t i = 0; i < clean.measurements.size(); ++i) {
    EXPECT_EQ(same.measurements[i].measurement.index(), clean.measurements[i].measurement.index());
    EXPECT_EQ(same.measurements[i].arrival, clean.measurements[i].arrival);
  }
}

TEST(SpoiltDrive, FaultsCountFromTheStartOfTheDrive) {
  FaultParameters faults;
  faults.fix.outages.push_back({2.0, 3.0});
  faults.odometry.slips = {{2.0, 3.0, 1.0}};
  const Drive out = spoilt(drive(), faults, 1);
  for (const GnssFix& fix : out.fixes()) {
    EXPECT_TRUE(fix.stamp < kStart + 1.99 || fix.stamp > kStart + 4.99);
  }
  EXPECT_EQ(out.fixes().size(), 21U - 6U);
  EXPECT_EQ(out.odometry[18].speed, 1.0) << "1.9 s after the start of the first increment";
  EXPECT_EQ(out.odometry[30].speed, 2.0);
}

TEST(SpoiltDrive, SpoilsHeadingsAlone) {
  Drive clean = drive();
  const std::size_t others = clean.measurements.size();
  for (int i = 0; i < 10; ++i) clean.measurements.push_back({Heading{kStart + i, 3.0, 0.01}, kStart + i});
  FaultParameters faults;
  faults.heading.resize(1);
  faults.heading.front().kind = "offset";
  faults.heading.front().size = 0.5;
  const Drive out = spoilt(clean, faults, 1);
  ASSERT_EQ(out.measurements.size(), others + 10U);
  int turned = 0;
  for (const RecordedMeasurement& recorded : out.measurements) {
    const auto* heading = std::get_if<Heading>(&recorded.measurement);
    if (heading == nullptr) continue;
    EXPECT_NEAR(heading->yaw, wrap_angle(3.5), 1e-12);
    ++turned;
  }
  EXPECT_EQ(turned, 10);
}

TEST(SpoiltDrive, SpoilsYawRatesAndVelocities) {
  Drive clean = drive();
  GnssVelocity velocity;
  velocity.velocity = {1.0, 2.0};
  for (int i = 0; i < 10; ++i) {
    velocity.stamp = kStart + i;
    clean.measurements.push_back({velocity, velocity.stamp});
    clean.yaw_rates.push_back({{velocity.stamp, 0.5}, velocity.stamp});
  }
  FaultParameters faults;
  faults.gyro.resize(1);
  faults.gyro.front().kind = "reversed";
  faults.velocity.resize(1);
  faults.velocity.front().kind = "late";
  faults.velocity.front().size = 0.5;
  const Drive out = spoilt(clean, faults, 1);
  ASSERT_EQ(out.yaw_rates.size(), 10U);
  EXPECT_EQ(out.yaw_rates.back().yaw_rate.rate, -0.5);
  int late = 0;
  for (const RecordedMeasurement& recorded : out.measurements) {
    if (!std::holds_alternative<GnssVelocity>(recorded.measurement)) continue;
    EXPECT_EQ(recorded.arrival, stamp_of(recorded.measurement) + 0.5);
    ++late;
  }
  EXPECT_EQ(late, 10);
}

TEST(SpoiltDrive, LateFixesArriveLateAmongTheRest) {
  FaultParameters faults;
  faults.fix.delays.emplace_back();
  faults.fix.delays.back().delay = 0.7;
  const Drive out = spoilt(drive(), faults, 1);
  ASSERT_EQ(out.measurements.size(), drive().measurements.size());
  double before = 0.0;
  for (const RecordedMeasurement& recorded : out.measurements) {
    const bool fix = std::holds_alternative<GnssFix>(recorded.measurement);
    EXPECT_NEAR(recorded.arrival - stamp_of(recorded.measurement), fix ? 0.7 : 0.0, 1e-6);
    EXPECT_GE(recorded.arrival, before);
    before = recorded.arrival;
  }
}

TEST(SpoiltDrive, NoReaderTakesAFixThatSaysItIsNone) {
  FaultParameters faults;
  faults.fix.statuses.emplace_back();
  EXPECT_TRUE(spoilt(drive(), faults, 1).fixes().empty());
  faults.fix.statuses.back().status = 2;
  EXPECT_EQ(spoilt(drive(), faults, 1).fixes().size(), 21U);
}

}  // namespace
}  // namespace multipath_localization
