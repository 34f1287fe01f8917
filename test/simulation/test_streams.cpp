#include <gtest/gtest.h>

#include <set>

#include "multipath_localization/core/random.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {
namespace {

TEST(SimulationStream, GivesEachPartOfTheWorldItsOwnNumbersAndNoneOfAFilters) {
  std::set<std::uint32_t> words;
  const std::set<std::uint32_t> streams = {0U,
                                           1U,
                                           kRobotStream,
                                           kOdometerStream,
                                           kOdometerNoiseStream,
                                           kReceiverStream,
                                           kReceiverNoiseStream,
                                           kDualReceiverStream,
                                           kZoneStream,
                                           kZoneStream + 1U,
                                           kFaultZoneStream,
                                           kFaultZoneStream + 1U,
                                           kConstellationStream,
                                           kReceiverClockStream,
                                           kReceiverLatencyStream,
                                           kInterSystemStream,
                                           kSatelliteStream,
                                           kSatelliteStream + 1U,
                                           kWallStream,
                                           kWallStream + 1U,
                                           kFixLossStream,
                                           kFixDuplicateStream,
                                           kFixSwapStream,
                                           kFixSpikeStream,
                                           kFixDelayStream,
                                           kOdometryLossStream,
                                           kFixColouredNoiseStream,
                                           kFixWhiteNoiseStream};
  for (const std::uint32_t stream : streams) words.insert(RandomStream(1, 7, stream).word());
  EXPECT_EQ(streams.size(), 28U);
  EXPECT_EQ(words.size(), streams.size());
}

}  // namespace
}  // namespace multipath_localization
