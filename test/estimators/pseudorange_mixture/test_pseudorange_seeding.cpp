#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "estimators/pseudorange_mixture/pseudorange_seeding.hpp"
#include "satellite_drive.hpp"

namespace multipath_localization {
namespace {

const SatelliteMixtureParameters kMixture;
const PseudorangeSeedingParameters kSettings;
const Eigen::Vector3d kAntenna(320.0, -150.0, 12.0);

std::vector<SatelliteObservation> delayed_sky(const std::vector<std::size_t>& delayed) {
  auto sky = observed(open_sky(), kAntenna, -5000.0, -5008.0);
  for (const std::size_t i : delayed) {
    sky[i].pseudorange += 60.0;
    sky[i].cn0 = 38.0;
  }
  for (SatelliteObservation& satellite : sky) satellite.cn0 -= 48.0;  // against strong signals
  return sky;
}

std::vector<PseudorangeSeed> seeds(const std::vector<SatelliteObservation>& sky, std::uint64_t seed,
                                   const SeedPrior& prior = SeedPrior()) {
  RandomStream random(seed, 0, 0);
  return pseudorange_seeds(sky, prior, 40, kMixture, kSettings, random);
}

TEST(PseudorangeSeeds, MostStandAtTheTruthThoughFiveOfThirteenAreLate) {
  const auto all = seeds(delayed_sky({0, 1, 2, 8, 9}), 1);
  ASSERT_EQ(all.size(), 40U);
  const auto near = std::count_if(all.begin(), all.end(), [](const PseudorangeSeed& seed) {
    return (seed.position - kAntenna).norm() < 15.0;
  });
  EXPECT_GT(near, 25);
}

TEST(PseudorangeSeeds, TellClockAndOffset) {
  for (const PseudorangeSeed& seed : seeds(delayed_sky({}), 2)) {
    EXPECT_LT((seed.position - kAntenna).norm(), 5.0);
    EXPECT_NEAR(seed.clock, -5000.0, 3.0);
    EXPECT_NEAR(seed.offset[static_cast<std::size_t>(Constellation::kGlonass)], -8.0, 3.0);
    EXPECT_NEAR(seed.offset[static_cast<std::size_t>(Constellation::kGps)], 0.0, 1e-3);
  }
}

TEST(PseudorangeSeeds, FollowAPriorThatIsSure) {
  const AntennaPrior prior{{330.0, -150.0}, 1e-4 * Eigen::Matrix2d::Identity()};
  for (const PseudorangeSeed& seed : seeds(delayed_sky({}), 3, {prior, std::nullopt})) {
    EXPECT_LT((seed.position.head<2>() - prior.position).norm(), 0.1);
  }
}

TEST(PseudorangeSeeds, TakeAPriorKnownAlongALineAlone) {
  const AntennaPrior prior{kAntenna.head<2>(), Eigen::Matrix2d::Constant(4.0)};
  const auto all = seeds(delayed_sky({}), 3, {prior, std::nullopt});
  EXPECT_FALSE(all.empty());
  for (const PseudorangeSeed& seed : all) {
    const Eigen::Vector2d off = seed.position.head<2>() - prior.position;
    EXPECT_LT(std::abs(off.x() - off.y()), 0.1);
    EXPECT_LT(off.norm(), 5.0);
  }
}

TEST(PseudorangeSeeds, AreThoseOfTheirRandomNumbers) {
  const auto sky = delayed_sky({0, 1, 2});
  EXPECT_EQ(seeds(sky, 4).front().position, seeds(sky, 4).front().position);
  EXPECT_NE(seeds(sky, 4).front().position, seeds(sky, 5).front().position);
}

TEST(PseudorangeSeeds, NeedEnoughSatellites) {
  auto sky = delayed_sky({});
  sky.resize(3);
  EXPECT_TRUE(seeds(sky, 6).empty());
}

TEST(PseudorangeSeeds, TakeNoReflectionsForAnOffsetThatIsKnown) {
  const auto all = delayed_sky({});
  std::vector<SatelliteObservation> few = {all[0], all[2], all[3], all[5], all[8], all[10]};
  for (std::size_t i = 4; i < few.size(); ++i) few[i].pseudorange += 12.0;  // both of GLONASS
  ReceiverPrior known;
  known.up = kAntenna.z();
  known.up_variance = 1.0;
  known.offset[static_cast<std::size_t>(Constellation::kGlonass)] = -8.0;
  known.offset_variance.fill(1.0);
  const auto offset_error = [&few](const SeedPrior& prior) {
    double most = 0.0;
    for (const PseudorangeSeed& seed : seeds(few, 4, prior)) {
      most = std::max(most, std::abs(seed.offset[static_cast<std::size_t>(Constellation::kGlonass)] + 8.0));
    }
    return most;
  };
  EXPECT_GT(offset_error(SeedPrior()), 8.0);
  EXPECT_LT(offset_error({std::nullopt, known}), 3.0);
  for (const PseudorangeSeed& seed : seeds(few, 4, {std::nullopt, known})) {
    EXPECT_NEAR(seed.position.z(), kAntenna.z(), 3.0);
  }
}

}  // namespace
}  // namespace multipath_localization
