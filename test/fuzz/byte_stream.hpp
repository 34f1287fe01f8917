#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <string>
#include <vector>

namespace multipath_localization::fuzz {

/// Bytes as numbers and messages, the way ROS writes them.
class ByteStream {
 public:
  explicit ByteStream(std::string bytes)
      : bytes_(std::move(bytes)),
        in_(reinterpret_cast<std::uint8_t*>(bytes_.data()), static_cast<std::uint32_t>(bytes_.size())) {}

  [[nodiscard]] bool empty() { return in_.getLength() == 0; }

  /// The next one. Throws ros::serialization::StreamOverrunException where it is cut off.
  template <class Message>
  Message take() {
    Message message;
    ros::serialization::deserialize(in_, message);
    return message;
  }

  /// As many as the next byte says, at most 255: ROS's own lists make room for any length that they claim
  /// before they look for the bytes.
  template <class Element>
  std::vector<Element> take_list() {
    std::vector<Element> list(take<std::uint8_t>());
    for (Element& element : list) element = take<Element>();
    return list;
  }

 private:
  std::string bytes_;
  ros::serialization::IStream in_;
};

/// Runs it to where the bytes break off.
template <class Reader>
void unless_cut(Reader&& reader) {
  try {
    reader.run();
  } catch (const ros::serialization::StreamOverrunException&) {
    // A message that is cut off is ROS's to refuse: no node ever sees it.
  }
}

}  // namespace multipath_localization::fuzz
