#include "ros/bags/bag_writer.hpp"

#include <rosbag/bag.h>

#include <algorithm>

#include "ros/messages/drive_messages.hpp"

namespace multipath_localization {

namespace {

/// Records messages one after the other: a reader may take those of one time in any order.
class BagWriter {
 public:
  explicit BagWriter(const std::string& file) : bag_(file, rosbag::bagmode::Write) {}

  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    last_ = std::max(time, last_ + ros::Duration(0, 1));
    bag_.write("/" + topic, last_, message);
  }

 private:
  rosbag::Bag bag_;
  ros::Time last_;
};

void write(const Drive& drive, BagWriter& writer) {
  const double shift = drive.start() < 1.0 ? 1.0 : 0.0;
  const auto stamp_of = [shift](double time) { return ros::Time(time + shift); };
  DriveMessages messages(drive.datum, RobotFrames(), stamp_of);
  writer.write("tf_static", stamp_of(drive.start()), messages.static_transforms(drive));
  for (const DriveEvent& event : events_of(drive)) {
    for (const TopicMessage& made : messages.of(event)) {
      std::visit([&](const auto& message) { writer.write(made.topic, stamp_of(event.time), message); },
                 made.message);
    }
  }
}

}  // namespace

void write_bag(const Drive& drive, const std::string& file) {
  try {
    BagWriter writer(file);
    write(drive, writer);
  } catch (const std::exception& error) {
    throw DriveError(file + ": " + error.what());
  }
}

}  // namespace multipath_localization
