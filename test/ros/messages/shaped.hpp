#pragma once

#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace multipath_localization {

/// A message of a type whose package is not here, of these bytes.
inline topic_tools::ShapeShifter shaped(const std::string& type, std::string bytes) {
  topic_tools::ShapeShifter message;
  message.morph("*", type, "", "0");
  ros::serialization::IStream in(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                 static_cast<std::uint32_t>(bytes.size()));
  message.read(in);
  return message;
}

/// Appends a number as it is sent.
template <class Number>
void append(std::string& bytes, Number number) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

}  // namespace multipath_localization
