#include <gtest/gtest.h>

#include "../rinex/sky.hpp"
#include "receiver/live_positioning.hpp"

namespace multipath_localization {
namespace {

const Geodetic kAntenna{35.1, 136.9, 100.0};
const GnssTime kTime = on_24_june(8, 20);

TEST(LivePositioning, SaysWhatIsMissingUntilThereIsAPosition) {
  const auto satellites = circling_satellites(Constellation::kGps, 6, 5);
  const RawEpoch raw = heard(satellites, kAntenna, kTime, 0.3e-3, 0.0, std::nullopt);
  LivePositioning positioning({0.1, {Constellation::kGps}});
  EXPECT_FALSE(positioning.correct({kTime, {}}));
  EXPECT_EQ(positioning.standing().shortage, "no satellite heard");
  std::size_t known = 0;
  for (const RawObservation& observation : raw.observations) {
    EXPECT_FALSE(positioning.correct(raw) && known < 4) << known;
    if (known < 4) {
      EXPECT_EQ(positioning.standing().with_ephemeris, known);
      EXPECT_NE(positioning.standing().shortage.find(std::to_string(known) + " of "), std::string::npos);
    }
    for (const BroadcastOrbit& orbit : satellites) {
      if (orbit.satellite == observation.satellite) positioning.navigation().ephemerides.update(orbit);
    }
    ++known;
  }
  const auto corrected = positioning.correct(raw);
  ASSERT_TRUE(corrected && corrected->robust);
  EXPECT_TRUE(positioning.standing().shortage.empty());
  EXPECT_EQ(positioning.standing().heard, raw.observations.size());
  EXPECT_EQ(positioning.standing().used, corrected->observations.size());
}

TEST(LivePositioning, SaysWhenRangesLeadToNoPlaceOnEarth) {
  const auto satellites = circling_satellites(Constellation::kGps, 6, 5);
  RawEpoch raw = heard(satellites, kAntenna, kTime, 0.3e-3, 0.0, std::nullopt);
  for (RawObservation& observation : raw.observations) observation.pseudorange = 1.0;
  LivePositioning positioning({0.1, {Constellation::kGps}});
  for (const BroadcastOrbit& orbit : satellites) positioning.navigation().ephemerides.update(orbit);
  EXPECT_FALSE(positioning.correct(raw));
  EXPECT_EQ(positioning.standing().shortage, "no position by the satellites heard so far");
}

}  // namespace
}  // namespace multipath_localization
