#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/calibration.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization {
namespace {

/// Ten epochs a second, each off by `error_east` [m] with a sigma of 1 m an axis.
std::vector<Epoch> epochs_of(const std::vector<double>& errors_east) {
  std::vector<Epoch> epochs;
  for (std::size_t i = 0; i < errors_east.size(); ++i) {
    Epoch epoch;
    epoch.truth.stamp = 0.1 * static_cast<double>(i);
    epoch.truth.has_yaw = true;
    epoch.truth.shadow = false;
    epoch.truth.wheel_fault = false;
    epoch.valid = true;
    epoch.state = Trust::kGood;
    epoch.estimate = {errors_east[i], 0.0, 0.0};
    epoch.yaw_variance = 0.01;
    epochs.push_back(epoch);
  }
  return epochs;
}

TEST(Calibration, OfAnHonestEstimatorIsEven) {
  RandomStream random(1, 1, 1);
  std::vector<Epoch> epochs = epochs_of(std::vector<double>(20001, 0.0));
  for (Epoch& epoch : epochs) {
    epoch.estimate = {random.normal(), random.normal(), 0.1 * random.normal()};
  }
  const Calibration c = calibration(epochs, 0.0, {});
  EXPECT_NEAR(c.time, 2000.0, 1e-6);
  for (std::size_t k = 0; k < c.inside.size(); ++k) {
    EXPECT_NEAR(c.inside[k] / c.time, Calibration::kEllipses[k], 0.01);
  }
  for (const double bin : c.pit) EXPECT_NEAR(bin / c.time, 0.05, 0.008);
  EXPECT_NEAR(*c.position_open.value(), 2.0, 0.1);
  EXPECT_NEAR(*c.heading_open.value(), 1.0, 0.05);
  EXPECT_FALSE(c.position_shadow.value());
}

TEST(Calibration, CountsTheMinutesInWhichGoodWasWrongForLong) {
  std::vector<double> errors(1801, 0.0);              // three minutes
  for (int i = 700; i < 715; ++i) errors[i] = 5.0;    // 1.5 s in the second
  for (int i = 1300; i < 1325; ++i) errors[i] = 5.0;  // 2.5 s in the third
  std::vector<Epoch> epochs = epochs_of(errors);
  const Calibration c = calibration(epochs, 0.0, {});
  EXPECT_EQ(c.good_minutes, 3u);
  EXPECT_EQ(c.false_minutes, 1u);
  EXPECT_NEAR(c.beyond[static_cast<std::size_t>(Trust::kGood)], 4.0, 1e-6);
  for (Epoch& epoch : epochs) epoch.state = Trust::kMultipath;
  EXPECT_EQ(calibration(epochs, 0.0, {}).good_minutes, 0u);
}

TEST(Calibration, OfTheStateUnderOpenSkyAlone) {
  std::vector<Epoch> epochs = epochs_of(std::vector<double>(41, 0.0));
  for (std::size_t i = 0; i < 10; ++i) epochs[i].state = Trust::kLost;
  for (std::size_t i = 20; i < epochs.size(); ++i) epochs[i].truth.shadow = true;
  const Calibration c = calibration(epochs, 0.0, {});
  EXPECT_NEAR(c.open, 2.0, 1e-9);
  EXPECT_NEAR(c.open_good, 1.0, 1e-9);
}

TEST(Calibration, DiagramHasErrorAndThreeSigmaByTheirLogarithms) {
  const Calibration c = calibration(epochs_of({1.0, 1.0}), 0.0, {});
  ASSERT_EQ(c.stanford.size(), 1u);
  EXPECT_EQ(c.stanford.begin()->first, std::pair(8, 9));  // 1 m and 3 m, four bins a decade from 1 cm on
}

TEST(Calibration, TellsWhenAShadowWasToldOf) {
  std::vector<Epoch> epochs = epochs_of(std::vector<double>(300, 0.0));
  for (std::size_t i = 100; i < 200; ++i) epochs[i].truth.shadow = true;
  for (std::size_t i = 120; i < 230; ++i) epochs[i].shadow_probability = 1.0;
  for (std::size_t i = 250; i < 260; ++i) epochs[i].truth.shadow = true;
  const Detection d = calibration(epochs, 0.0, {}).shadow;
  ASSERT_EQ(d.told.size(), 1u);
  EXPECT_NEAR(d.told.front(), 2.0, 1e-9);
  EXPECT_NEAR(d.cleared.front(), 3.0, 1e-9);
  EXPECT_EQ(d.missed, 1u);
  EXPECT_NEAR(*d.brier.value(), 60.0 / 299.0, 1e-6);
}

TEST(Calibration, OfNisIsItsMeanAndHowOneForetellsTheNext) {
  const Calibration swinging =
      calibration({}, 0.0, {1.0, 3.0, 1.0, 3.0, 1.0, 3.0, 1.0, 3.0, 1.0, 3.0, 1.0, 3.0});
  EXPECT_DOUBLE_EQ(*swinging.nis.value(), 2.0);
  EXPECT_LT(*swinging.nis_next.value(), -0.8);
  EXPECT_FALSE(calibration({}, 0.0, {1.0, 2.0}).nis_next.value());
}

TEST(Calibration, OfTwoRunsIsThatOfBothTogether) {
  const std::vector<double> first(50, 0.5);
  const std::vector<double> second(30, 4.0);
  Calibration sum = calibration(epochs_of(first), 0.0, {1.0, 2.0});
  sum.add(calibration(epochs_of(second), 0.0, {6.0}));
  EXPECT_NEAR(sum.time, 7.8, 1e-9);
  EXPECT_NEAR(sum.inside[3], 4.9, 1e-9);
  EXPECT_NEAR(*sum.position_open.value(), (4.9 * 0.25 + 2.9 * 16.0) / 7.8, 1e-4);
  EXPECT_DOUBLE_EQ(*sum.nis.value(), 3.0);
  EXPECT_EQ(sum.good_minutes, 2u);
}

}  // namespace
}  // namespace multipath_localization
