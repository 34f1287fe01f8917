#include <cstdio>
#include <vector>

#include "../rinex/sky.hpp"
#include "orbits.hpp"
#include "receiver/ubx_receiver.hpp"
#include "recorded.hpp"
#include "rinex/navigation_writer.hpp"
#include "rinex/point_positioning.hpp"

namespace multipath_localization {
namespace {

const Geodetic kAntenna{35.1, 136.9, 100.0};

/// The observation file of some epochs, as RINEX prints it.
std::string observation_text(const std::vector<RawEpoch>& epochs) {
  std::string text = header_line("     3.03           OBSERVATION DATA    M: Mixed", "RINEX VERSION / TYPE");
  for (const char* types : {"G    3 C1C D1C S1C", "E    3 C1C D1C S1C", "C    3 C2I D2I S2I"}) {
    text += header_line(types, "SYS / # / OBS TYPES");
  }
  text += header_line("", "END OF HEADER");
  char line[200];
  for (const RawEpoch& epoch : epochs) {
    std::snprintf(line, sizeof(line), "> 2024 06 24 %02d %02d%11.7f  0%3zu\n",
                  static_cast<int>(epoch.time.second - 86400.0) / 3600,
                  static_cast<int>(epoch.time.second) / 60 % 60, std::fmod(epoch.time.second, 60.0),
                  epoch.observations.size());
    text += line;
    for (const RawObservation& raw : epoch.observations) {
      std::snprintf(line, sizeof(line), "%c%02d%14.3f  %14.3f  %14.3f\n",
                    letter_of(raw.satellite.constellation), raw.satellite.number, raw.pseudorange,
                    raw.doppler, raw.cn0);
      text += line;
    }
  }
  return text;
}

/// Two minutes of three systems, and what their satellites broadcast, as RINEX prints both.
class BothWays : public testing::Test {
 protected:
  BothWays() {
    std::vector<BroadcastOrbit> orbits;
    for (const Constellation constellation :
         {Constellation::kGps, Constellation::kGalileo, Constellation::kBeidou}) {
      for (BroadcastOrbit& orbit : circling_satellites(constellation, 6, 5)) {
        orbit.satellite.number += constellation == Constellation::kBeidou ? 5 : 0;
        orbits.push_back(orbit);
      }
    }
    for (BroadcastOrbit& orbit : orbits) as_sent(orbit);
    const TemporaryFolder folder;
    Navigation sky;
    for (const BroadcastOrbit& orbit : orbits) sky.ephemerides.add(orbit);
    sky.ionosphere = heard_ionosphere();
    recorded_.navigation = read_navigation({folder.write("brdc.nav", navigation_text(sky))});
    recorded_.navigation.ionosphere = sky.ionosphere;  // the header's five digits are not what is compared
    std::vector<RawEpoch> epochs;
    for (int i = 0; i < 12; ++i) {
      epochs.push_back(heard(orbits, kAntenna, on_24_june(8, 20, 10.0 * i), 0.3e-3, 1e-7, sky.ionosphere));
    }
    recorded_.epochs = read_observations(folder.write("rover.obs", observation_text(epochs))).epochs;
  }

  /// As the message holds it: whatever the field's last bit is.
  static void as_sent(BroadcastOrbit& orbit) {
    if (orbit.satellite.constellation == Constellation::kBeidou) {
      orbit.toe = 115200.0;
      orbit.reference = orbit.clock_reference = orbit.reference + 14.0;
    }
    BroadcastDecoder decoder;
    Navigation navigation;
    for (const ubx::Words& words : ubx::broadcast(orbit, reception().gps)) {
      decoder.add(subframe_of(orbit.satellite, words), reception(), navigation);
    }
    orbit = std::get<BroadcastOrbit>(navigation.ephemerides.all().at(0));
  }

  static KlobucharCoefficients heard_ionosphere() {
    KlobucharCoefficients all;
    all.alpha << 20 * std::ldexp(1.0, -30), 3 * std::ldexp(1.0, -27), -2 * std::ldexp(1.0, -24), 0.0;
    all.beta << 63 * 2048.0, 8 * 16384.0, -3 * 65536.0, -4 * 65536.0;
    return all;
  }

  Recording recorded_;
};

void expect_same(const CorrectedEpoch& epoch, const CorrectedEpoch& expected) {
  EXPECT_EQ(epoch.time - expected.time, 0.0);
  ASSERT_EQ(epoch.satellites.size(), expected.satellites.size());
  for (std::size_t i = 0; i < epoch.satellites.size(); ++i) {
    const TrackedSatellite &its = epoch.satellites[i], &other = expected.satellites[i];
    const SatelliteObservation &seen = epoch.observations[i], &other_seen = expected.observations[i];
    EXPECT_TRUE(its.satellite == other.satellite);
    EXPECT_NEAR(seen.pseudorange, other_seen.pseudorange, 1e-3);
    if (other_seen.has_doppler()) {
      EXPECT_NEAR(seen.range_rate, other_seen.range_rate, 1e-3);
    }
    EXPECT_EQ(seen.has_doppler(), other_seen.has_doppler());
    EXPECT_LT((its.at_transmission.position - other.at_transmission.position).norm(), 1e-3);
    EXPECT_LT((its.at_transmission.velocity - other.at_transmission.velocity).norm(), 1e-6);
    EXPECT_NEAR(seen.elevation, other_seen.elevation, 1e-9);
    if (!std::isnan(other_seen.cn0)) {
      EXPECT_EQ(seen.cn0, other_seen.cn0);
    }
    EXPECT_NEAR(seen.sigma, other_seen.sigma, 1e-6);
  }
}

/// That its stream gives the epochs that the RINEX files give, to the millimetre; how many.
std::size_t expect_both_ways_alike(const Recording& recorded) {
  const PositioningSettings settings{0.1,
                                     {Constellation::kGps, Constellation::kGlonass, Constellation::kGalileo,
                                      Constellation::kBeidou, Constellation::kQzss}};
  PointPositioning by_rinex(recorded.navigation, settings);
  Navigation received;
  PointPositioning by_stream(received, settings);
  std::vector<std::optional<CorrectedEpoch>> epochs;
  UbxReceiver receiver(received,
                       [&](const ReceiverEpoch& epoch) { epochs.push_back(by_stream.correct(epoch.raw)); });
  receiver.take(stream_of(recorded));
  EXPECT_EQ(receiver.counts().malformed, 0U);
  EXPECT_EQ(receiver.framing().checksum_errors(), 0U);
  EXPECT_EQ(receiver.broadcast().ephemerides(), recorded.navigation.ephemerides.all().size());
  EXPECT_EQ(epochs.size(), recorded.epochs.size() + 1) << "one before all others tells the time";
  std::size_t compared = 0;
  for (std::size_t i = 0; i < recorded.epochs.size() && i + 1 < epochs.size(); ++i) {
    const auto expected = by_rinex.correct(recorded.epochs[i]);
    const auto& corrected = epochs[i + 1];
    EXPECT_EQ(corrected.has_value(), expected.has_value()) << i;
    if (!corrected || !expected) continue;
    expect_same(*corrected, *expected);
    ++compared;
  }
  return compared;
}

TEST_F(BothWays, TheStreamGivesTheEpochsOfTheRinexFilesToTheMillimetre) {
  EXPECT_EQ(expect_both_ways_alike(recorded_), recorded_.epochs.size());
}

TEST(RecordedDrives, AreTheSameBothWaysToTheMillimetre) {
  if (recorded_drives().empty()) GTEST_SKIP() << "needs drives in MULTIPATH_LOCALIZATION_DATA";
  for (const auto& drive : recorded_drives())
    EXPECT_GT(expect_both_ways_alike(read_recording(drive)), 600U) << drive;
}

TEST_F(BothWays, SubframesBeforeTheTimeIsKnownDoNotCount) {
  Navigation received;
  UbxReceiver receiver(received, [](const ReceiverEpoch&) {});
  const Ephemeris any = recorded_.navigation.ephemerides.all().front();
  receiver.take(ubx::sfrbx(any, recorded_.epochs.front().time));
  EXPECT_FALSE(receiver.time());
  EXPECT_EQ(receiver.counts().malformed, 3U);
  EXPECT_TRUE(received.ephemerides.all().empty());
  receiver.take(ubx::rawx(recorded_.epochs.front()) + ubx::sfrbx(any, recorded_.epochs.front().time));
  EXPECT_EQ(received.ephemerides.all().size(), 1U);
  EXPECT_EQ(receiver.time()->leap_seconds, 18);
}

TEST(UbxReceiver, CountsClockResetsAndWhatIsMalformed) {
  Navigation navigation;
  std::size_t resets = 0;
  UbxReceiver receiver(navigation, [&](const ReceiverEpoch& epoch) { resets += epoch.clock_reset ? 1 : 0; });
  for (const int status : {1, 3, 1, 2}) {
    receiver.take(ubx::frame(2, 0x15, ubx::rawx_payload({2320, 100.0}, "", status)));
  }
  receiver.take(ubx::frame(2, 0x15, "short") + ubx::frame(2, 0x13, "short") + ubx::frame(1, 7, "else"));
  EXPECT_EQ(resets, 2U);
  EXPECT_EQ(receiver.counts().clock_resets, 2U);
  EXPECT_EQ(receiver.counts().malformed, 2U);
}

}  // namespace
}  // namespace multipath_localization
