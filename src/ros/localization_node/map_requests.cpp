#include "ros/localization_node/map_requests.hpp"

#include <cmath>

namespace multipath_localization {

namespace {

constexpr double kLargestTurn = 1e-6;  ///< of map's axes, as a quaternion's vector part [1]
constexpr char kNoDatum[] = "map has no datum yet; set one or wait for the first fix";
constexpr char kNoPlace[] = "there is no such place on the Earth";

Geodetic to_geodetic(const GeoPoint& point) { return {point.latitude, point.longitude, point.altitude}; }

bool turned(const geometry_msgs::Quaternion& q) {
  return !(std::abs(q.x) + std::abs(q.y) + std::abs(q.z) < kLargestTurn) || !std::isfinite(q.w);
}

}  // namespace

std::string answer(const SetDatum::Request& request, Geodetic& place) {
  const Geodetic asked = to_geodetic(request.geo_pose.position);
  if (!valid(asked)) return kNoPlace;
  if (turned(request.geo_pose.orientation)) return "map's axes are east, north, up; it cannot be turned";
  place = asked;
  return "";
}

std::string answer(const ToLL::Request& request, const LocalFrame* map, ToLL::Response& response) {
  const Eigen::Vector3d point(request.map_point.x, request.map_point.y, request.map_point.z);
  if (map == nullptr) return kNoDatum;
  if (!point.allFinite() || point.lpNorm<Eigen::Infinity>() > kFurthestPoint) {
    return "the point is not finite or beyond 10 000 km";
  }
  const Geodetic place = map->to_geodetic(point.head<2>(), point.z());
  response.ll_point.latitude = place.latitude_deg;
  response.ll_point.longitude = place.longitude_deg;
  response.ll_point.altitude = place.altitude;
  return "";
}

std::string answer(const FromLL::Request& request, const LocalFrame* map, FromLL::Response& response) {
  Geodetic place = to_geodetic(request.ll_point);
  if (map == nullptr) return kNoDatum;
  if (!valid(place)) return kNoPlace;
  if (!std::isfinite(place.altitude)) place.altitude = map->datum().altitude;
  const Eigen::Vector3d point = map->vector_to_map(LocalFrame(place).origin() - map->origin());
  response.map_point.x = point.x();
  response.map_point.y = point.y();
  response.map_point.z = point.z();
  return "";
}

}  // namespace multipath_localization
