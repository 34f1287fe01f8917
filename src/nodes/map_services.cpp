#include "nodes/map_services.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <ros/console.h>

#include <cmath>
#include <utility>

namespace multipath_localization {

namespace {

constexpr double kLargestTurn = 1e-6;  ///< of map's axes, as a quaternion's vector part [1]
constexpr char kNoDatum[] = "map has no datum yet; set one or wait for the first fix";

bool refuse(const char* service, const char* why) {
  ROS_WARN("%s refused: %s", service, why);
  return false;
}

Geodetic to_geodetic(const GeoPoint& point) { return {point.latitude, point.longitude, point.altitude}; }

bool turned(const geometry_msgs::Quaternion& q) {
  return !(std::abs(q.x) + std::abs(q.y) + std::abs(q.z) < kLargestTurn) || !std::isfinite(q.w);
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
  const Geodetic place = to_geodetic(request.geo_pose.position);
  if (!valid(place)) return refuse("datum", "there is no such place on the Earth");
  if (turned(request.geo_pose.orientation)) {
    return refuse("datum", "map's axes are east, north, up; it cannot be turned");
  }
  datum_.set(place);
  tell_origin(ros::Time());
  moved_();
  return true;
}

bool MapServices::to_place(ToLL::Request& request, ToLL::Response& response) {
  const geometry_msgs::Point& point = request.map_point;
  if (datum_.map() == nullptr) return refuse("toLL", kNoDatum);
  if (!std::isfinite(point.x + point.y + point.z)) return refuse("toLL", "the point is not finite");
  const Geodetic place = datum_.map()->to_geodetic({point.x, point.y}, point.z);
  response.ll_point.latitude = place.latitude_deg;
  response.ll_point.longitude = place.longitude_deg;
  response.ll_point.altitude = place.altitude;
  return true;
}

bool MapServices::from_place(FromLL::Request& request, FromLL::Response& response) {
  Geodetic place = to_geodetic(request.ll_point);
  if (datum_.map() == nullptr) return refuse("fromLL", kNoDatum);
  if (!valid(place)) return refuse("fromLL", "there is no such place on the Earth");
  const LocalFrame& map = *datum_.map();
  if (!std::isfinite(place.altitude)) place.altitude = map.datum().altitude;
  const Eigen::Vector3d point = map.vector_to_map(LocalFrame(place).origin() - map.origin());
  response.map_point.x = point.x();
  response.map_point.y = point.y();
  response.map_point.z = point.z();
  return true;
}

}  // namespace multipath_localization
