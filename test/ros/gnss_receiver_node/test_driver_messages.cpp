#include <gtest/gtest.h>

#include "../../receiver/orbits.hpp"
#include "receiver/ubx_messages.hpp"
#include "ros/gnss_receiver_node/driver_messages.hpp"

namespace multipath_localization {
namespace {

constexpr const char* kMeasurements = "0eafeb530a3e6637722c4e296734c119";
constexpr const char* kOrbit = "b4346f99e431c870e392a438684c0fe8";
constexpr const char* kGlonassOrbit = "6893dee0d8b1c9325a6693f3488e0144";

/// A message of that type that holds these bytes.
topic_tools::ShapeShifter message(std::string bytes, const std::string& md5sum = "*") {
  topic_tools::ShapeShifter shifter;
  shifter.morph(md5sum, "some/Message", "", "");
  ros::serialization::IStream in(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                 static_cast<std::uint32_t>(bytes.size()));
  shifter.read(in);
  return shifter;
}

/// With a list's length at that place, as ROS writes it.
std::string counted(const std::string& payload, std::size_t place, std::uint32_t count) {
  std::string length;
  ubx::put(length, count);
  return payload.substr(0, place) + length + payload.substr(place);
}

TEST(UbloxMessages, HoldThePayloadOfTheProtocol) {
  RawObservation raw;
  raw.satellite = {Constellation::kGps, 7};
  raw.pseudorange = 2.2e7;
  const std::string rawx =
      ubx::rawx_payload(reception().gps, ubx::measurement(raw, 0) + ubx::measurement(raw, 3));
  EXPECT_EQ(rawx_payload(message(counted(rawx, 16, 2))), rawx);
  const std::string sfrbx = ubx::sfrbx_payload(raw.satellite, ubx::Words(10, 5U));
  EXPECT_EQ(sfrbx_payload(message(counted(sfrbx, 8, 10))), sfrbx);
}

TEST(UbloxMessages, OfAnotherLayoutAreRefused) {
  const std::string rawx = ubx::rawx_payload(reception().gps, std::string(64, '\0'));
  EXPECT_FALSE(rawx_payload(message(counted(rawx, 16, 1)))) << "another length than told";
  EXPECT_FALSE(rawx_payload(message(counted(rawx, 16, 2) + "x")));
  EXPECT_FALSE(rawx_payload(message(std::string(16, '\0') + counted(rawx, 16, 2)))) << "a header before";
  EXPECT_FALSE(rawx_payload(message("")));
  EXPECT_FALSE(sfrbx_payload(message("short")));
  EXPECT_FALSE(
      sfrbx_payload(message(counted(ubx::sfrbx_payload({Constellation::kGps, 7}, {1U}), 8, 0xFFFFFFFF))));
}

void put_time(std::string& bytes, const GnssTime& time) {
  ubx::put(bytes, static_cast<std::uint32_t>(time.week));
  ubx::put(bytes, time.second);
}

template <class Number>
void put_list(std::string& bytes, const std::vector<Number>& values) {
  ubx::put(bytes, static_cast<std::uint32_t>(values.size()));
  for (const Number value : values) ubx::put(bytes, value);
}

struct Signals {
  std::uint32_t satellite;
  std::vector<double> frequencies, pseudoranges;
};

std::string measurements(const std::vector<Signals>& all) {
  std::string bytes;
  ubx::put(bytes, static_cast<std::uint32_t>(all.size()));
  for (const Signals& signals : all) {
    const std::vector<double> cn0(signals.frequencies.size(), 40.0),
        doppler(signals.frequencies.size(), -500.0);
    const std::vector<std::uint8_t> small(signals.frequencies.size(), 1);
    put_time(bytes, reception().gps);
    ubx::put(bytes, signals.satellite);
    put_list(bytes, signals.frequencies);
    put_list(bytes, cn0);
    put_list(bytes, small);
    put_list(bytes, small);
    put_list(bytes, signals.pseudoranges);
    for (int i = 0; i < 3; ++i) put_list(bytes, cn0);
    put_list(bytes, doppler);
    put_list(bytes, cn0);
    put_list(bytes, small);
  }
  return bytes;
}

TEST(GnssComm, MeasurementsAreThoseOfTheFirstFrequency) {
  const auto epoch =
      gnss_comm_epoch(message(measurements({{7, {1227.6e6, 1575.42e6}, {1e7, 2e7}},
                                            {32 + 3, {1602e6 + 562.5e3 * 5}, {2.1e7}},
                                            {32 + 27 + 4, {1575.42e6}, {2.2e7}},
                                            {32 + 27 + 38 + 30, {1575.42e6, 1561.098e6}, {1e7, 2.3e7}},
                                            {32 + 27 + 38 + 31, {1575.42e6}, {2.4e7}},
                                            {8, {1227.6e6}, {1e7}},
                                            {9, {1575.42e6}, {0.0}},
                                            {161, {1575.42e6}, {2e7}}}),
                              kMeasurements));
  ASSERT_TRUE(epoch);
  EXPECT_EQ(epoch->time - reception().gps, 0.0);
  ASSERT_EQ(epoch->observations.size(), 5U);
  const std::vector<SatelliteId> satellites = {{Constellation::kGps, 7},
                                               {Constellation::kGlonass, 3},
                                               {Constellation::kGalileo, 4},
                                               {Constellation::kBeidou, 30},
                                               {Constellation::kBeidou, 31}};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(epoch->observations[i].satellite == satellites[i]) << i;
    EXPECT_EQ(epoch->observations[i].pseudorange, 2e7 + 1e6 * static_cast<double>(i));
    EXPECT_EQ(epoch->observations[i].doppler, -500.0);
    EXPECT_EQ(epoch->observations[i].cn0, 40.0);
    EXPECT_EQ(epoch->observations[i].b1c, i == 4);
  }
}

TEST(GnssComm, MessagesOfOthersAndBrokenOnesAreRefused) {
  const std::string bytes = measurements({{7, {1575.42e6}, {2e7}}});
  EXPECT_TRUE(gnss_comm_epoch(message(bytes, kMeasurements)));
  EXPECT_FALSE(gnss_comm_epoch(message(bytes, kOrbit)));
  EXPECT_FALSE(gnss_comm_epoch(message(measurements({}), kMeasurements)));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(gnss_comm_epoch(message(bytes.substr(0, size), kMeasurements))) << size;
    EXPECT_FALSE(gnss_comm_ephemeris(message(bytes.substr(0, size), kOrbit))) << size;
    EXPECT_FALSE(gnss_comm_ephemeris(message(bytes.substr(0, size), kGlonassOrbit))) << size;
  }
}

/// A gnss_comm/GnssEphemMsg, by the order of its fields.
std::string orbit_bytes(const BroadcastOrbit& orbit, std::uint32_t satellite, std::uint32_t health = 0) {
  std::string bytes;
  ubx::put(bytes, satellite);
  put_time(bytes, reception().gps);
  put_time(bytes, orbit.reference);
  put_time(bytes, orbit.clock_reference);
  ubx::put(bytes, orbit.toe);
  for (const std::uint32_t whole : {2320U, 77U, 77U, health, 1U}) ubx::put(bytes, whole);
  const bool galileo = orbit.satellite.constellation == Constellation::kGalileo;
  for (const double value : {2.0,
                             orbit.root_axis * orbit.root_axis,
                             orbit.eccentricity,
                             orbit.inclination,
                             orbit.perigee,
                             orbit.node,
                             orbit.mean_anomaly,
                             orbit.mean_motion_difference,
                             orbit.node_rate,
                             orbit.inclination_rate,
                             orbit.latitude_correction.y(),
                             orbit.latitude_correction.x(),
                             orbit.radius_correction.y(),
                             orbit.radius_correction.x(),
                             orbit.inclination_correction.y(),
                             orbit.inclination_correction.x(),
                             orbit.clock_polynomial(0),
                             orbit.clock_polynomial(1),
                             orbit.clock_polynomial(2),
                             galileo ? 1e-3 : orbit.group_delay,
                             galileo ? orbit.group_delay : 1e-3,
                             0.0,
                             0.0}) {
    ubx::put(bytes, value);
  }
  return bytes;
}

TEST(GnssComm, OrbitsAreWhatRinexPrintsOfThem) {
  struct Case {
    const char* printed;
    SatelliteId satellite;
    std::uint32_t number;
  };
  for (const Case& each : {Case{kGps5, {Constellation::kGps, 5}, 5},
                           Case{kGalileo12At8, {Constellation::kGalileo, 12}, 32 + 27 + 12},
                           Case{kBeidou1, {Constellation::kBeidou, 1}, 32 + 27 + 38 + 1}}) {
    const auto printed = orbit_of<BroadcastOrbit>(each.printed, each.satellite, on_24_june(8, 30));
    const auto ephemeris = gnss_comm_ephemeris(message(orbit_bytes(printed, each.number), kOrbit));
    ASSERT_TRUE(ephemeris);
    expect_same(std::get<BroadcastOrbit>(*ephemeris), printed);
    const auto sick = gnss_comm_ephemeris(message(orbit_bytes(printed, each.number, 1), kOrbit));
    EXPECT_FALSE(std::get<BroadcastOrbit>(*sick).healthy);
  }
}

TEST(GnssComm, OrbitsOfGlonassAreWhatRinexPrintsOfThem) {
  const auto printed =
      orbit_of<GlonassOrbit>(kGlonass1At845, {Constellation::kGlonass, 1}, on_24_june(8, 45));
  std::string bytes;
  ubx::put(bytes, std::uint32_t{33});
  put_time(bytes, reception().gps);
  put_time(bytes, printed.reference);
  ubx::put(bytes, static_cast<std::int32_t>(printed.channel));
  for (const std::uint32_t whole : {35U, 0U, 0U}) ubx::put(bytes, whole);
  ubx::put(bytes, 2.0);
  for (const Eigen::Vector3d& vector : {printed.position, printed.velocity, printed.acceleration}) {
    for (Eigen::Index i = 0; i < vector.size(); ++i) ubx::put(bytes, vector[i]);
  }
  for (const double value : {-printed.clock, printed.clock_drift, 0.0}) ubx::put(bytes, value);
  const auto ephemeris = gnss_comm_ephemeris(message(bytes, kGlonassOrbit));
  ASSERT_TRUE(ephemeris);
  expect_same(std::get<GlonassOrbit>(*ephemeris), printed);
}

TEST(GnssComm, ImpossibleOrbitsAreRefused) {
  auto orbit = any_orbit({Constellation::kGps, 5}, 1);
  orbit.eccentricity = 0.9;
  EXPECT_FALSE(gnss_comm_ephemeris(message(orbit_bytes(orbit, 5), kOrbit)));
  EXPECT_FALSE(gnss_comm_ephemeris(message(orbit_bytes(any_orbit({Constellation::kGps, 5}, 1), 0), kOrbit)));
}

}  // namespace
}  // namespace multipath_localization
