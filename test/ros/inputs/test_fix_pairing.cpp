#include <gtest/gtest.h>

#include "good_fix.hpp"
#include "ros/inputs/fix_pairing.hpp"

namespace multipath_localization {
namespace {

using Side = FixPairing::Side;

sensor_msgs::NavSatFix at(double stamp) {
  sensor_msgs::NavSatFix fix = good_fix();
  fix.header.stamp.fromSec(stamp);
  return fix;
}

std::vector<double> stamps(const std::vector<sensor_msgs::NavSatFix>& fixes) {
  std::vector<double> all;
  for (const auto& fix : fixes) all.push_back(fix.header.stamp.toSec());
  return all;
}

TEST(FixPairing, PairsWhicheverSideComesFirst) {
  FixPairing pairing(0.05);
  EXPECT_FALSE(pairing.add(Side::kLeft, at(10.0)).pair);
  const auto first = pairing.add(Side::kRight, at(10.01)).pair;
  ASSERT_TRUE(first);
  EXPECT_EQ(first->left.header.stamp.toSec(), 10.0);
  EXPECT_EQ(first->right.header.stamp.toSec(), 10.01);
  EXPECT_FALSE(pairing.add(Side::kRight, at(10.2)).pair);
  const auto second = pairing.add(Side::kLeft, at(10.19)).pair;
  ASSERT_TRUE(second);
  EXPECT_EQ(second->left.header.stamp.toSec(), 10.19);
  EXPECT_TRUE(pairing.clear().empty());
}

TEST(FixPairing, TakesTheNearestWithinTheTolerance) {
  FixPairing pairing(0.05);
  for (const double stamp : {10.0, 10.04, 10.2}) pairing.add(Side::kLeft, at(stamp));
  const auto pair = pairing.add(Side::kRight, at(10.05)).pair;
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->left.header.stamp.toSec(), 10.04);
  EXPECT_FALSE(pairing.add(Side::kRight, at(10.13)).pair) << "0.07 s off";
}

TEST(FixPairing, PairsOneSideThatComesEpochsLate) {
  FixPairing pairing(0.05);
  for (const double stamp : {10.0, 10.2, 10.4}) EXPECT_FALSE(pairing.add(Side::kLeft, at(stamp)).pair);
  for (const double stamp : {10.0, 10.2, 10.4}) {
    const auto pair = pairing.add(Side::kRight, at(stamp)).pair;
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->left.header.stamp.toSec(), stamp);
  }
}

TEST(FixPairing, GivesUpWhatIsASecondAway) {
  FixPairing pairing(0.05);
  pairing.add(Side::kLeft, at(10.0));
  pairing.add(Side::kLeft, at(10.5));
  EXPECT_EQ(stamps(pairing.add(Side::kLeft, at(11.2)).unpaired), std::vector<double>{10.0});
  EXPECT_EQ(stamps(pairing.add(Side::kRight, at(3.0)).unpaired), (std::vector<double>{10.5, 11.2}))
      << "time went back";
}

TEST(FixPairing, GivesUpTheOldestOfAHundredAndAllAtTheEnd) {
  FixPairing pairing(0.0);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(pairing.add(Side::kLeft, at(10.0 + 0.001 * i)).unpaired.empty());
  EXPECT_EQ(stamps(pairing.add(Side::kLeft, at(10.1)).unpaired), std::vector<double>{10.0});
  EXPECT_EQ(pairing.clear().size(), 100u);
  EXPECT_TRUE(pairing.clear().empty());
}

}  // namespace
}  // namespace multipath_localization
