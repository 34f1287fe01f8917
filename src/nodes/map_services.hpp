#pragma once

#include <multipath_localization/FromLL.h>
#include <multipath_localization/SetDatum.h>
#include <multipath_localization/ToLL.h>
#include <ros/node_handle.h>

#include <functional>

#include "nodes/datum.hpp"

namespace multipath_localization {

/// Between map and the Earth, by robot_localization's names: `datum` moves map's origin, `toLL` and `fromLL`
/// convert. A request that cannot be answered fails, with the reason in the log.
class MapServices {
 public:
  /// `moved` is called when map's origin has moved.
  MapServices(ros::NodeHandle node, Datum& datum, std::function<void()> moved);

 private:
  bool on_datum(SetDatum::Request& request, SetDatum::Response&);
  bool to_place(ToLL::Request& request, ToLL::Response& response);
  bool from_place(FromLL::Request& request, FromLL::Response& response);

  Datum& datum_;
  std::function<void()> moved_;
  ros::ServiceServer set_datum_, to_place_, from_place_;
};

}  // namespace multipath_localization
