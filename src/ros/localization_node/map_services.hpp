#pragma once

#include <geometry_msgs/Point.h>
#include <multipath_localization/FromLL.h>
#include <multipath_localization/SetDatum.h>
#include <multipath_localization/ToLL.h>
#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>

#include "ros/map/datum.hpp"

namespace multipath_localization {

/// Between map and the Earth, by robot_localization's names: `datum` moves map's origin, `toLL` and `fromLL`
/// convert. A request that cannot be answered fails, with the reason in the log. The latched topic
/// `local_xy_origin` tells where the origin is, as mapviz reads it: x is the longitude [deg], y the latitude
/// [deg], z the altitude [m].
class MapServices {
 public:
  /// `moved` is called when map's origin has moved.
  MapServices(ros::NodeHandle node, Datum& datum, std::string map_frame, std::function<void()> moved);

  /// Publishes the origin when it is another than the last time. Of a datum that came with a measurement,
  /// `stamp` is that one's.
  void tell_origin(const ros::Time& stamp);

 private:
  bool on_datum(SetDatum::Request& request, SetDatum::Response&);
  bool to_place(ToLL::Request& request, ToLL::Response& response);
  bool from_place(FromLL::Request& request, FromLL::Response& response);

  Datum& datum_;
  std::string map_frame_;
  std::function<void()> moved_;
  std::optional<geometry_msgs::Point> told_;
  ros::Publisher origin_;
  ros::ServiceServer set_datum_, to_place_, from_place_;
};

}  // namespace multipath_localization
