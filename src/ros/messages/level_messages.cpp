#include "ros/messages/level_messages.hpp"

#include <cstdint>
#include <ctime>
#include <stdexcept>
#include <string>

#include "receiver/byte_reader.hpp"
#include "ros/messages/message_bytes.hpp"

namespace multipath_localization {

namespace {

// Of gps_common/GPSStatus.
constexpr int kNoFix = -1, kFix = 0, kSbas = 1, kDgps = 18, kRtkFix = 19, kRtkFloat = 20, kWaas = 33;
// Of UBX-NAV-PVT.
constexpr unsigned kValidDateAndTime = 3U, kFixOk = 1U, kDifferential = 2U;
constexpr unsigned kCarrierShift = 6U, kCarrierFloat = 1U, kCarrierFixed = 2U;

FixLevel level_of_status(int status) {
  switch (status) {
    case kFix: return FixLevel::kSingle;
    case kSbas:
    case kWaas:
    case kDgps: return FixLevel::kDifferential;
    case kRtkFix: return FixLevel::kFixed;
    case kRtkFloat: return FixLevel::kFloat;
    default: return FixLevel::kUntold;
  }
}

/// Its stamp [s].
double take_header(ByteReader& in) {
  in.skip(sizeof(std::uint32_t));
  const auto seconds = in.take<std::uint32_t>();
  const auto nanoseconds = in.take<std::uint32_t>();
  in.skip(in.take<std::uint32_t>());
  return static_cast<double>(seconds) + 1e-9 * static_cast<double>(nanoseconds);
}

void skip_numbers(ByteReader& in) { in.skip(sizeof(std::int32_t) * in.take<std::uint32_t>()); }

std::optional<ToldLevel> gps_fix_level(ByteReader& in) {
  ToldLevel told;
  told.stamp = take_header(in);
  take_header(in);                 // of the status
  in.skip(sizeof(std::uint16_t));  // satellites that are used, and which
  skip_numbers(in);
  in.skip(sizeof(std::uint16_t));  // those that are visible, and which, their elevation, azimuth, strength
  for (int i = 0; i < 4; ++i) skip_numbers(in);
  const int status = in.take<std::int16_t>();
  if (status == kNoFix || told.stamp <= 0.0) return std::nullopt;
  told.level = level_of_status(status);
  return told;
}

std::optional<ToldLevel> nav_pvt_level(ByteReader& in) {
  in.skip(sizeof(std::uint32_t));
  std::tm utc{};
  utc.tm_year = in.take<std::uint16_t>() - 1900;
  utc.tm_mon = in.take<std::uint8_t>() - 1;
  for (int* part : {&utc.tm_mday, &utc.tm_hour, &utc.tm_min, &utc.tm_sec}) *part = in.take<std::uint8_t>();
  const unsigned valid = in.take<std::uint8_t>();
  in.skip(sizeof(std::uint32_t));  // accuracy of the time
  const auto nanoseconds = in.take<std::int32_t>();
  in.skip(sizeof(std::uint8_t));  // type of the fix
  const unsigned flags = in.take<std::uint8_t>();
  if ((valid & kValidDateAndTime) != kValidDateAndTime || (flags & kFixOk) == 0U) return std::nullopt;
  ToldLevel told;
  told.stamp = static_cast<double>(timegm(&utc)) + 1e-9 * nanoseconds;
  const unsigned carrier = flags >> kCarrierShift;
  told.level = (flags & kDifferential) != 0U ? FixLevel::kDifferential : FixLevel::kSingle;
  if (carrier == kCarrierFloat) told.level = FixLevel::kFloat;
  if (carrier == kCarrierFixed) told.level = FixLevel::kFixed;
  return told;
}

}  // namespace

std::optional<ToldLevel> level_of(const topic_tools::ShapeShifter& message) {
  const std::string& type = message.getDataType();
  const bool gps_fix = type == "gps_common/GPSFix";
  if (!gps_fix && type != "ublox_msgs/NavPVT" && type != "ublox_msgs/NavPVT7") return std::nullopt;
  const std::string bytes = bytes_of(message);
  ByteReader in(bytes);
  try {
    return gps_fix ? gps_fix_level(in) : nav_pvt_level(in);
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

}  // namespace multipath_localization
