#include "nodes/datum.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "nodes/datum_file.hpp"

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

std::string text_of(const LocalFrame& map) {
  const Geodetic& datum = map.datum();
  char text[100];
  std::snprintf(text, sizeof(text), "[%.9f, %.9f, %.3f]", datum.latitude_deg, datum.longitude_deg,
                datum.altitude);
  return text;
}

}  // namespace

Datum::Datum(const std::optional<Geodetic>& configured, double averaging, std::string file)
    : averaging_(averaging), file_(std::move(file)) {
  if (configured) {
    map_.emplace(*configured);
  } else if (const auto saved = file_.empty() ? std::nullopt : read_datum(file_)) {
    map_.emplace(*saved);
    ROS_INFO("datum of map: %s, from %s", text_of(*map_).c_str(), file_.c_str());
  }
}

void Datum::set(const Geodetic& place) {
  map_.emplace(place);
  places_.clear();
  ROS_INFO("datum of map: %s", text_of(*map_).c_str());
  if (file_.empty()) return;
  try {
    write_datum(file_, map_->datum());
  } catch (const std::runtime_error& error) {
    ROS_ERROR("the datum is not saved: %s", error.what());
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
  set({median(places_, [](const Geodetic& p) { return p.latitude_deg; }),
       median(places_, [](const Geodetic& p) { return p.longitude_deg; }),
       median(places_, [](const Geodetic& p) { return p.altitude; })});
}

}  // namespace multipath_localization
