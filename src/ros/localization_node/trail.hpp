#pragma once

#include <nav_msgs/Path.h>

namespace multipath_localization {

/// The poses behind the robot, some way apart.
class Trail {
 public:
  /// Keeps `length` poses at least `spacing` apart [m].
  Trail(std::size_t length, double spacing) : length_(length), spacing_(spacing) {}

  /// Takes the pose of now.
  void add(const std_msgs::Header& header, const geometry_msgs::Pose& pose);

  /// In the frame and with the stamp of the last pose taken, the oldest first.
  [[nodiscard]] const nav_msgs::Path& path() const { return path_; }

  void clear() { path_.poses.clear(); }

 private:
  std::size_t length_;
  double spacing_;
  nav_msgs::Path path_;
};

}  // namespace multipath_localization
