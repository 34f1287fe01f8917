#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "good_epoch.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

CheckedEpoch read(const GnssEpoch& message) { return to_epoch(message, berlin(), EpochParameters{}); }

/// The satellite at index 2 after a change to it, if it is kept.
template <class Change>
std::optional<SatelliteObservation> third_after(Change change) {
  GnssEpoch message = good_epoch();
  change(message.pseudoranges[2]);
  const CheckedEpoch checked = read(message);
  EXPECT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(checked.epoch.observations.size() + checked.dropped, 13u);
  EXPECT_LE(checked.dropped, 1u) << "the rest is used";
  if (checked.dropped == 1) return std::nullopt;
  return checked.epoch.observations[2];
}

template <class Change>
bool dropped(Change change) {
  return !third_after(change);
}

TEST(ToEpoch, UndoesToMessage) {
  PseudorangeEpoch epoch = good_observations();
  epoch.observations[0].range_rate = -512.5;
  epoch.observations[1].velocity.setConstant(kNan);
  epoch.observations[2].cn0 = kNan;
  const CheckedEpoch checked =
      to_epoch(to_message(epoch, berlin(), good_epoch().header), berlin(), EpochParameters{}, {0.3, -0.1});
  ASSERT_EQ(checked.reason, Reason::kAccepted);
  EXPECT_EQ(checked.dropped, 0u);
  EXPECT_EQ(checked.epoch.stamp, 100.5);
  EXPECT_EQ(checked.epoch.antenna_in_base, Eigen::Vector2d(0.3, -0.1));
  ASSERT_EQ(checked.epoch.observations.size(), epoch.observations.size());
  for (std::size_t i = 0; i < epoch.observations.size(); ++i) {
    const SatelliteObservation& was = epoch.observations[i];
    const SatelliteObservation& is = checked.epoch.observations[i];
    EXPECT_EQ(is.constellation, was.constellation);
    EXPECT_EQ(is.satellite, was.satellite);
    EXPECT_EQ(is.pseudorange, was.pseudorange);
    EXPECT_EQ(is.elevation, was.elevation);
    EXPECT_EQ(is.sigma, was.sigma);
    EXPECT_LT((is.position - was.position).norm(), 1e-7);
    EXPECT_EQ(std::isnan(is.range_rate), i != 0);
    EXPECT_EQ(std::isnan(is.cn0), i == 2);
    EXPECT_EQ(is.velocity.hasNaN(), i == 1);
    EXPECT_TRUE(i == 1 || (is.velocity - was.velocity).norm() < 1e-6);
  }
  EXPECT_EQ(checked.epoch.observations[0].range_rate, -512.5);
}

TEST(ToEpoch, TellsSatellitesAsTheyStoodAtTransmission) {
  const PseudorangeEpoch epoch = good_observations();
  const Pseudorange message = good_epoch().pseudoranges[0];
  const Eigen::Vector3d ecef(message.position.x, message.position.y, message.position.z);
  const Eigen::Vector3d unturned =
      berlin().vector_to_ecef(epoch.observations[0].position) + berlin().origin();
  EXPECT_GT((ecef - unturned).norm(), 30.0) << "the Earth turned while the signal flew";
  EXPECT_LT((berlin().satellite_to_map(ecef) - epoch.observations[0].position).norm(), 1e-7);
}

TEST(ToEpoch, RefusesWholeEpochs) {
  GnssEpoch message = good_epoch();
  message.header.stamp = ros::Time();
  EXPECT_EQ(read(message).reason, Reason::kZeroStamp);
  message = good_epoch();
  message.pseudoranges.resize(257, message.pseudoranges[0]);
  EXPECT_EQ(read(message).reason, Reason::kTooManySatellites);
  message.pseudoranges.clear();
  EXPECT_EQ(read(message).reason, Reason::kTooFewSatellites);
  message = good_epoch();
  for (Pseudorange& pseudorange : message.pseudoranges) pseudorange.pseudorange = kNan;
  EXPECT_EQ(read(message).reason, Reason::kTooFewSatellites);
  EXPECT_EQ(check(message, EpochParameters{}), Reason::kTooFewSatellites);
}

TEST(ToEpoch, DropsASatelliteOfNoConstellationOrNamedBefore) {
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.constellation = 5; }));
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.satellite = 1; })) << "GPS 1 is there";
  EXPECT_FALSE(dropped([](Pseudorange& p) { p.satellite = 99; }));
}

TEST(ToEpoch, DropsImpossiblePseudorangesButNotThoseOfABadClock) {
  for (const double range : {kNan, kInfinity, -kInfinity, 0.0, -2e7, 9e5, 1.1e8, 1e308}) {
    EXPECT_TRUE(dropped([&](Pseudorange& p) { p.pseudorange = range; })) << range;
  }
  for (const double clock : {-136902.0, -1.7e7, 5e7}) {
    EXPECT_FALSE(dropped([&](Pseudorange& p) { p.pseudorange = 2.2e7 + clock; })) << clock;
  }
}

TEST(ToEpoch, DropsSatellitesOutOfOrbit) {
  for (const double x : {kNan, kInfinity, 1e308, 9e8}) {
    EXPECT_TRUE(dropped([&](Pseudorange& p) { p.position.x = x; })) << x;
  }
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.position = geometry_msgs::Point(); }));
  EXPECT_FALSE(dropped([](Pseudorange& p) { p.position.x = 4.2e7; })) << "geostationary";
}

TEST(ToEpoch, DropsWhatNoReceiverMeasures) {
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.range_rate = kInfinity; }));
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.velocity.z = -kInfinity; }));
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.velocity.z = 2e5; }));
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.cn0 = kInfinity; }));
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.cn0 = -1.0; }));
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.elevation = 45.0; })) << "degrees";
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.sigma = kInfinity; }));
  EXPECT_TRUE(dropped([](Pseudorange& p) { p.sigma = 1001.0; }));
}

TEST(ToEpoch, FillsInWhatIsNotTold) {
  for (const double none : {0.0, -3.0, kNan}) {
    const auto observation = third_after([&](Pseudorange& p) { p.sigma = none; });
    ASSERT_TRUE(observation);
    EXPECT_EQ(observation->sigma, EpochParameters{}.default_sigma);
  }
  const auto observation = third_after([](Pseudorange& p) { p.elevation = kNan; });
  ASSERT_TRUE(observation);
  EXPECT_NEAR(observation->elevation, 70.0 * kPi / 180.0, 1e-6);
  EXPECT_FALSE(third_after([](Pseudorange& p) { p.velocity.y = kNan; })->has_doppler());
}

TEST(SolveGeodetic, TellsWhereAMessageWasMeasured) {
  const auto place = solve_geodetic(good_epoch(), EpochParameters{});
  ASSERT_TRUE(place);
  EXPECT_LT((berlin().to_map(*place) - Eigen::Vector2d(320.0, -150.0)).norm(), 0.01);
  GnssEpoch few = good_epoch();
  few.pseudoranges.resize(3);
  EXPECT_FALSE(solve_geodetic(few, EpochParameters{}));
}

TEST(SolveGeodetic, TellsNothingInSpace) {
  GnssEpoch message = good_epoch();
  for (std::size_t i = 0; i < message.pseudoranges.size(); ++i) {
    message.pseudoranges[i].pseudorange += i % 2 == 0 ? 3e7 : 0.0;
  }
  EXPECT_FALSE(solve_geodetic(message, EpochParameters{}));
}

}  // namespace
}  // namespace multipath_localization
