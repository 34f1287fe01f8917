#include <cstdlib>
#include <fstream>
#include <map>

#include "orbits.hpp"
#include "recorded.hpp"

namespace multipath_localization {
namespace {

/// What rtklib's convbin reads in a stream.
Recording by_convbin(const std::string& stream) {
  const TemporaryFolder folder;
  const std::string file = folder.write("rover.ubx", stream);
  const std::string made = file + ".obs", navigation = file + ".nav";
  const std::string command = "convbin -r ubx -v 3.04 -od -os -o '" + made + "' -n '" + navigation + "' '" +
                              file + "' >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return {read_navigation({navigation}), read_observations(made).epochs};
}

void expect_same(const RawEpoch& epoch, const RawEpoch& expected) {
  EXPECT_NEAR(epoch.time - expected.time, 0.0, 1e-6);
  std::map<SatelliteId, RawObservation> read;
  for (const RawObservation& raw : epoch.observations) read[raw.satellite] = raw;
  EXPECT_EQ(read.size(), expected.observations.size());
  for (const RawObservation& raw : expected.observations) {
    const RawObservation& same = read[raw.satellite];
    EXPECT_NEAR(same.pseudorange, raw.pseudorange, 1.1e-3);
    if (!std::isnan(raw.doppler)) {
      EXPECT_NEAR(same.doppler, raw.doppler, 1.1e-3);
    }
    if (!std::isnan(raw.cn0)) {
      EXPECT_NEAR(same.cn0, raw.cn0, 1.0);
    }
  }
}

/// That it has all ephemerides, with the same satellites in the same places. (Convbin leaves out one whose
/// issue it has, and of GLONASS all but the last before each epoch.)
void expect_same(const Ephemerides& read, const Recording& recording) {
  const GnssTime time = recording.epochs.front().time;
  std::size_t compared = 0;
  for (const SatelliteId& satellite : recording.navigation.ephemerides.usable(time)) {
    const Ephemeris* expected = recording.navigation.ephemerides.find(satellite, time);
    const Ephemeris* its = read.find(satellite, time);
    ASSERT_NE(its, nullptr) << letter_of(satellite.constellation) << satellite.number;
    const SatelliteState is = satellite_state(*its, time), was = satellite_state(*expected, time);
    EXPECT_LT((is.position - was.position).norm(), 1e-3)
        << letter_of(satellite.constellation) << satellite.number;
    EXPECT_NEAR(is.clock, was.clock, 1e-13) << letter_of(satellite.constellation) << satellite.number;
    EXPECT_NEAR(group_delay(*its), group_delay(*expected), 1e-13);
    EXPECT_EQ(carrier_frequency(*its), carrier_frequency(*expected));
    ++compared;
  }
  EXPECT_GT(compared, 3U);
}

void expect_read_alike(const Recording& recording) {
  if (std::system("convbin -h >/dev/null 2>&1; test $? != 127") != 0)
    GTEST_SKIP() << "needs rtklib's convbin";
  const Recording read = by_convbin(stream_of(recording));
  expect_same(read.navigation.ephemerides, recording);
  const std::size_t first = read.epochs.size() - recording.epochs.size();
  ASSERT_LE(first, 1U);
  for (std::size_t i = 0; i < recording.epochs.size(); ++i) {
    expect_same(read.epochs[first + i], recording.epochs[i]);
  }
}

TEST(Convbin, ReadsTheSameInWhatTheseTestsEncode) {
  Recording recording;
  recording.navigation = navigation_of(navigation_header() + kGps5 + kGalileo12At830 + kBeidou1 +
                                       kGlonass1At845 + replaced(kBeidou1, "C01", "C30"));
  RawObservation raw;
  raw.pseudorange = 2.2e7;
  raw.doppler = -1234.5;
  raw.cn0 = 41.0;
  RawEpoch epoch{reception().gps, {}};
  for (const SatelliteId& satellite : recording.navigation.ephemerides.usable(epoch.time)) {
    raw.satellite = satellite;
    raw.pseudorange += 1e6;
    epoch.observations.push_back(raw);
  }
  recording.epochs = {epoch, {epoch.time + 1.0, epoch.observations}};
  expect_read_alike(recording);
}

TEST(Convbin, ReadsTheSameInDrives) {
  if (recorded_drives().empty()) GTEST_SKIP() << "needs drives in MULTIPATH_LOCALIZATION_DATA";
  for (const auto& drive : recorded_drives()) expect_read_alike(read_recording(drive));
}

}  // namespace
}  // namespace multipath_localization
