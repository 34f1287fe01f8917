#include <gtest/gtest.h>

#include "ros/messages/level_messages.hpp"
#include "shaped.hpp"

namespace multipath_localization {
namespace {

void append_header(std::string& bytes, std::uint32_t seconds) {
  append<std::uint32_t>(bytes, 7);
  append<std::uint32_t>(bytes, seconds);
  append<std::uint32_t>(bytes, 500000000);
  append<std::uint32_t>(bytes, 3);
  bytes += "gps";
}

/// A gps_common/GPSFix up to the status, as it is laid out, and some of what follows.
std::string gps_fix(int status, std::uint32_t seconds = 1000) {
  std::string bytes;
  append_header(bytes, seconds);
  append_header(bytes, 0);
  append<std::uint16_t>(bytes, 2);
  append<std::uint32_t>(bytes, 2);
  for (const int satellite : {5, 9}) append<std::int32_t>(bytes, satellite);
  append<std::uint16_t>(bytes, 1);
  for (int i = 0; i < 4; ++i) {
    append<std::uint32_t>(bytes, 1);
    append<std::int32_t>(bytes, 30);
  }
  append<std::int16_t>(bytes, static_cast<std::int16_t>(status));
  return bytes + std::string(100, '\0');
}

/// UBX-NAV-PVT of 2024-06-24 08:20:00.25.
std::string nav_pvt(unsigned flags, unsigned valid = 7) {
  std::string bytes;
  append<std::uint32_t>(bytes, 116400250);
  append<std::uint16_t>(bytes, 2024);
  for (const int part : {6, 24, 8, 20, 0}) append<std::uint8_t>(bytes, static_cast<std::uint8_t>(part));
  append<std::uint8_t>(bytes, static_cast<std::uint8_t>(valid));
  append<std::uint32_t>(bytes, 20);
  append<std::int32_t>(bytes, 250000000);
  append<std::uint8_t>(bytes, 3);
  append<std::uint8_t>(bytes, static_cast<std::uint8_t>(flags));
  return bytes + std::string(70, '\0');
}

FixLevel level_of_status(int status) {
  const auto told = level_of(shaped("gps_common/GPSFix", gps_fix(status)));
  return told ? told->level : FixLevel::kUntold;
}

FixLevel level_of_flags(unsigned flags) {
  const auto told = level_of(shaped("ublox_msgs/NavPVT", nav_pvt(flags)));
  return told ? told->level : FixLevel::kUntold;
}

TEST(LevelMessages, TellTheLevelsOfGpsFix) {
  EXPECT_EQ(level_of_status(0), FixLevel::kSingle);
  EXPECT_EQ(level_of_status(1), FixLevel::kDifferential);
  EXPECT_EQ(level_of_status(18), FixLevel::kDifferential);
  EXPECT_EQ(level_of_status(33), FixLevel::kDifferential);
  EXPECT_EQ(level_of_status(19), FixLevel::kFixed);
  EXPECT_EQ(level_of_status(20), FixLevel::kFloat);
  EXPECT_EQ(level_of_status(2), FixLevel::kUntold) << "corrected from the ground by code or carrier";
  EXPECT_EQ(level_of(shaped("gps_common/GPSFix", gps_fix(19)))->stamp, 1000.5);
}

TEST(LevelMessages, TellTheLevelsOfNavPvt) {
  EXPECT_EQ(level_of_flags(0x01), FixLevel::kSingle);
  EXPECT_EQ(level_of_flags(0x03), FixLevel::kDifferential);
  EXPECT_EQ(level_of_flags(0x43), FixLevel::kFloat);
  EXPECT_EQ(level_of_flags(0x83), FixLevel::kFixed);
  EXPECT_EQ(level_of(shaped("ublox_msgs/NavPVT7", nav_pvt(0x83)))->stamp, 1719217200.25);
}

TEST(LevelMessages, TellNothingWithoutAFixOrAStamp) {
  EXPECT_FALSE(level_of(shaped("gps_common/GPSFix", gps_fix(-1))));
  EXPECT_FALSE(level_of(shaped("gps_common/GPSFix", gps_fix(0, 0).replace(8, 4, 4, '\0'))));
  EXPECT_FALSE(level_of(shaped("gps_common/GPSFix", gps_fix(0).substr(0, 40))));
  EXPECT_FALSE(level_of(shaped("ublox_msgs/NavPVT", nav_pvt(0x82))));
  EXPECT_FALSE(level_of(shaped("ublox_msgs/NavPVT", nav_pvt(0x83, 1))));
  EXPECT_FALSE(level_of(shaped("ublox_msgs/NavPVT", nav_pvt(0x83).substr(0, 10))));
  EXPECT_FALSE(level_of(shaped("sensor_msgs/NavSatFix", gps_fix(19))));
}

}  // namespace
}  // namespace multipath_localization
