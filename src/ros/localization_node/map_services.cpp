#include "ros/localization_node/map_services.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <ros/console.h>

#include <utility>

#include "ros/localization_node/map_requests.hpp"

namespace multipath_localization {

namespace {

/// Whether the request was answered; otherwise the log says why not.
bool answered(const char* service, const std::string& refusal) {
  if (!refusal.empty()) ROS_WARN("%s refused: %s", service, refusal.c_str());
  return refusal.empty();
}

}  // namespace

MapServices::MapServices(ros::NodeHandle node, Datum& datum, std::string map_frame,
                         std::function<void()> moved)
    : datum_(datum),
      map_frame_(std::move(map_frame)),
      moved_(std::move(moved)),
      origin_(node.advertise<geometry_msgs::PoseStamped>("local_xy_origin", 1, true)),
      set_datum_(node.advertiseService("datum", &MapServices::on_datum, this)),
      to_place_(node.advertiseService("toLL", &MapServices::to_place, this)),
      from_place_(node.advertiseService("fromLL", &MapServices::from_place, this)) {
  tell_origin(ros::Time());
}

void MapServices::tell_origin(const ros::Time& stamp) {
  if (datum_.map() == nullptr) return;
  const Geodetic& datum = datum_.map()->datum();
  geometry_msgs::PoseStamped origin;
  origin.header.stamp = stamp;
  origin.header.frame_id = map_frame_;
  origin.pose.position.x = datum.longitude_deg;
  origin.pose.position.y = datum.latitude_deg;
  origin.pose.position.z = datum.altitude;
  origin.pose.orientation.w = 1.0;
  if (told_ == origin.pose.position) return;
  told_ = origin.pose.position;
  origin_.publish(origin);
}

bool MapServices::on_datum(SetDatum::Request& request, SetDatum::Response&) {
  Geodetic place;
  if (!answered("datum", answer(request, place))) return false;
  datum_.set(place);
  tell_origin(ros::Time());
  moved_();
  return true;
}

bool MapServices::to_place(ToLL::Request& request, ToLL::Response& response) {
  return answered("toLL", answer(request, datum_.map(), response));
}

bool MapServices::from_place(FromLL::Request& request, FromLL::Response& response) {
  return answered("fromLL", answer(request, datum_.map(), response));
}

}  // namespace multipath_localization
