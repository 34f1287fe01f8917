#pragma once

#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <string>

namespace multipath_localization {

/// A message as it was sent, of whatever type.
inline std::string bytes_of(const topic_tools::ShapeShifter& message) {
  std::string bytes(message.size(), '\0');
  ros::serialization::OStream out(reinterpret_cast<std::uint8_t*>(bytes.data()), message.size());
  message.write(out);
  return bytes;
}

}  // namespace multipath_localization
