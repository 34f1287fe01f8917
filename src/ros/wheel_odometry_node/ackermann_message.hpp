#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <boost/shared_ptr.hpp>

namespace multipath_localization {

/// What ackermann_msgs/AckermannDriveStamped holds, read without its package: to roscpp it is that type, by
/// its md5.
struct AckermannDriveStamped {
  using ConstPtr = boost::shared_ptr<const AckermannDriveStamped>;

  std_msgs::Header header;
  float steering_angle = 0.0F;           ///< to the left [rad]
  float steering_angle_velocity = 0.0F;  ///< [rad/s]
  float speed = 0.0F;                    ///< [m/s]
  float acceleration = 0.0F;             ///< [m/s^2]
  float jerk = 0.0F;                     ///< [m/s^3]
};

}  // namespace multipath_localization

namespace ros {

namespace message_traits {

template <>
struct IsMessage<multipath_localization::AckermannDriveStamped> : TrueType {};

template <>
struct HasHeader<multipath_localization::AckermannDriveStamped> : TrueType {};

template <>
struct MD5Sum<multipath_localization::AckermannDriveStamped> {
  static const char* value() { return "1fd5d7f58889cefd44d29f6653240d0c"; }
  static const char* value(const multipath_localization::AckermannDriveStamped&) { return value(); }
};

template <>
struct DataType<multipath_localization::AckermannDriveStamped> {
  static const char* value() { return "ackermann_msgs/AckermannDriveStamped"; }
  static const char* value(const multipath_localization::AckermannDriveStamped&) { return value(); }
};

template <>
struct Definition<multipath_localization::AckermannDriveStamped> {
  static const char* value() {
    return "Header header\n"
           "AckermannDrive drive\n"
           "================================================================================\n"
           "MSG: std_msgs/Header\n"
           "uint32 seq\n"
           "time stamp\n"
           "string frame_id\n"
           "================================================================================\n"
           "MSG: ackermann_msgs/AckermannDrive\n"
           "float32 steering_angle\n"
           "float32 steering_angle_velocity\n"
           "float32 speed\n"
           "float32 acceleration\n"
           "float32 jerk\n";
  }
  static const char* value(const multipath_localization::AckermannDriveStamped&) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<multipath_localization::AckermannDriveStamped> {
  template <class Stream, class Message>
  static void allInOne(Stream& stream, Message message) {  // NOLINT(readability-identifier-naming): roscpp's
    stream.next(message.header);
    stream.next(message.steering_angle);
    stream.next(message.steering_angle_velocity);
    stream.next(message.speed);
    stream.next(message.acceleration);
    stream.next(message.jerk);
  }

  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace serialization

}  // namespace ros
