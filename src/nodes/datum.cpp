#include "nodes/datum.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>

namespace multipath_localization {

namespace {

/// The median of one coordinate, 0 when it is finite nowhere.
template <class Coordinate>
double median(const std::vector<Geodetic>& points, Coordinate coordinate) {
  std::vector<double> values;
  for (const Geodetic& point : points) {
    if (std::isfinite(coordinate(point))) values.push_back(coordinate(point));
  }
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Datum::Datum(const std::vector<double>& configured, double averaging) : averaging_(averaging) {
  if (configured.size() >= 2) {
    map_.emplace(Geodetic{configured[0], configured[1], configured.size() > 2 ? configured[2] : 0.0});
  }
}

void Datum::add(double stamp, const Geodetic& place) {
  if (map_) return;
  if (places_.empty() || stamp < first_stamp_) {
    places_.clear();
    first_stamp_ = stamp;
  }
  places_.push_back(place);
  if (stamp - first_stamp_ < averaging_) return;
  map_.emplace(Geodetic{median(places_, [](const Geodetic& p) { return p.latitude_deg; }),
                        median(places_, [](const Geodetic& p) { return p.longitude_deg; }),
                        median(places_, [](const Geodetic& p) { return p.altitude; })});
  const Geodetic& datum = map_->datum();
  ROS_INFO("datum of map: [%.9f, %.9f, %.3f], from %zu measurements", datum.latitude_deg, datum.longitude_deg,
           datum.altitude, places_.size());
}

}  // namespace multipath_localization
