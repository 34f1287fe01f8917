#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "receiver/ubx_messages.hpp"
#include "ubx_encoder.hpp"

namespace multipath_localization {
namespace {

constexpr GnssTime kTime{2158, 95593.005};

RawObservation heard(Constellation constellation, int number, double pseudorange, double doppler = -1234.5,
                     double cn0 = 41.0) {
  RawObservation raw;
  raw.satellite = {constellation, number};
  raw.pseudorange = pseudorange;
  raw.doppler = doppler;
  raw.cn0 = cn0;
  return raw;
}

std::optional<ReceiverEpoch> read(const std::string& measurements, int status = 1) {
  return read_rawx(ubx::rawx_payload(kTime, measurements, status));
}

TEST(ReadRawx, ReadsTimeAndMeasurements) {
  const auto epoch = read(ubx::measurement(heard(Constellation::kGps, 21, 22049460.634), 0) +
                              ubx::measurement(heard(Constellation::kGlonass, 19, 20833884.423), 0, -3),
                          3);
  ASSERT_TRUE(epoch);
  EXPECT_EQ(epoch->raw.time.week, kTime.week);
  EXPECT_EQ(epoch->raw.time.second, kTime.second);
  EXPECT_EQ(epoch->leap_seconds, 18);
  EXPECT_TRUE(epoch->clock_reset);
  ASSERT_EQ(epoch->raw.observations.size(), 2U);
  const RawObservation& gps = epoch->raw.observations[0];
  EXPECT_TRUE(gps.satellite == (SatelliteId{Constellation::kGps, 21}));
  EXPECT_EQ(gps.pseudorange, 22049460.634);
  EXPECT_EQ(gps.doppler, -1234.5);
  EXPECT_EQ(gps.cn0, 41.0);
  EXPECT_FALSE(gps.b1c);
  EXPECT_TRUE(epoch->raw.observations[1].satellite == (SatelliteId{Constellation::kGlonass, 19}));
}

TEST(ReadRawx, LeapSecondsCountWhereTheReceiverKnowsThem) {
  EXPECT_EQ(read("", 0)->leap_seconds, std::nullopt);
  EXPECT_FALSE(read("", 1)->clock_reset);
}

TEST(ReadRawx, OfEachSatelliteTheBestSignalCounts) {
  const auto epoch = read(ubx::measurement(heard(Constellation::kBeidou, 30, 3e7), 5) +
                          ubx::measurement(heard(Constellation::kGalileo, 4, 4e7), 1) +
                          ubx::measurement(heard(Constellation::kBeidou, 30, 1e7), 0) +
                          ubx::measurement(heard(Constellation::kGalileo, 4, 2e7), 0) +
                          ubx::measurement(heard(Constellation::kBeidou, 31, 5e7), 5) +
                          ubx::measurement(heard(Constellation::kGps, 4, 6e7), 3));
  ASSERT_TRUE(epoch);
  ASSERT_EQ(epoch->raw.observations.size(), 3U) << "GPS L2C alone is of no use";
  EXPECT_EQ(epoch->raw.observations[0].pseudorange, 1e7) << "B1I";
  EXPECT_FALSE(epoch->raw.observations[0].b1c);
  EXPECT_EQ(epoch->raw.observations[1].pseudorange, 2e7) << "E1 C";
  EXPECT_EQ(epoch->raw.observations[2].pseudorange, 5e7);
  EXPECT_TRUE(epoch->raw.observations[2].b1c);
}

TEST(ReadRawx, PassesOverWhatIsOfNoUse) {
  std::string sbas = ubx::measurement(heard(Constellation::kGps, 123, 3e7), 0);
  sbas[20] = 1;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto epoch = read(sbas + ubx::measurement(heard(Constellation::kGps, 1, 2e7), 0, 0, false) +
                          ubx::measurement(heard(Constellation::kGlonass, 255, 2e7), 0) +
                          ubx::measurement(heard(Constellation::kGps, 2, nan), 0) +
                          ubx::measurement(heard(Constellation::kGps, 3, -1.0), 0) +
                          ubx::measurement(heard(Constellation::kGps, 4, 2e7, nan, nan), 0) +
                          ubx::measurement(heard(Constellation::kGps, 5, 2e7, 1e30, 0.0), 0));
  ASSERT_TRUE(epoch);
  ASSERT_EQ(epoch->raw.observations.size(), 2U);
  for (const RawObservation& raw : epoch->raw.observations) {
    EXPECT_TRUE(std::isnan(raw.doppler)) << raw.satellite.number;
    EXPECT_TRUE(std::isnan(raw.cn0)) << raw.satellite.number;
  }
}

TEST(ReadRawx, RefusesWhatIsNoneAndEpochsBeforeTheTimeIsKnown) {
  const std::string payload =
      ubx::rawx_payload(kTime, ubx::measurement(heard(Constellation::kGps, 1, 2e7), 0));
  EXPECT_TRUE(read_rawx(payload));
  for (std::size_t size = 0; size < payload.size(); ++size) EXPECT_FALSE(read_rawx(payload.substr(0, size)));
  EXPECT_FALSE(read_rawx(payload + "x"));
  EXPECT_FALSE(read_rawx(ubx::rawx_payload({0, 100.0}, "")));
  EXPECT_FALSE(read_rawx(ubx::rawx_payload({2158, 604800.0}, "")));
  EXPECT_FALSE(read_rawx(ubx::rawx_payload({2158, std::nan("")}, "")));
}

TEST(ReadSfrbx, ReadsSatelliteChannelAndWords) {
  const ubx::Words words = {1, 0xFFFFFFFF, 0x12345678, 4};
  const auto subframe = read_sfrbx(ubx::sfrbx_payload({Constellation::kGlonass, 7}, words, -4));
  ASSERT_TRUE(subframe);
  EXPECT_TRUE(subframe->satellite == (SatelliteId{Constellation::kGlonass, 7}));
  EXPECT_EQ(subframe->channel, -4);
  EXPECT_EQ(subframe->words, words);
}

TEST(ReadSfrbx, RefusesOtherSignalsAndWhatIsNone) {
  const ubx::Words words(10, 7U);
  const SatelliteId gps{Constellation::kGps, 7};
  const std::string payload = ubx::sfrbx_payload(gps, words);
  EXPECT_TRUE(read_sfrbx(payload));
  EXPECT_FALSE(read_sfrbx(ubx::sfrbx_payload(gps, words, 0, 4))) << "L2C's message is another";
  EXPECT_FALSE(read_sfrbx(ubx::sfrbx_payload({Constellation::kGlonass, 255}, words)));
  EXPECT_FALSE(read_sfrbx(ubx::sfrbx_payload({Constellation::kBeidou, 30}, words, 0, 6))) << "B1C's too";
  for (std::size_t size = 0; size < payload.size(); ++size) EXPECT_FALSE(read_sfrbx(payload.substr(0, size)));
}

}  // namespace
}  // namespace multipath_localization
