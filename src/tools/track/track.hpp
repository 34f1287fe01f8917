#pragma once

#include <ros/time.h>

#include <string>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// Where a robot was, and when.
struct TrackPoint {
  ros::Time stamp;
  Geodetic place;
};

/// The track that the NavSatFix messages of a topic tell: a point at its beginning, at its end and each time
/// the robot is a step further; places without a fix or that are none are left out. Throws DriveError, naming
/// the file and the topics that there are, where the bag has no such topic, and where it tells no place.
std::vector<TrackPoint> read_track(const std::string& bag, const std::string& topic);

/// GPX 1.1: a track of one segment, with altitudes where they are known, and times in UTC.
std::string gpx_of(const std::vector<TrackPoint>& track);

/// GeoJSON (RFC 7946): a feature with one LineString, and the times as its property `times`. A place alone is
/// a Point.
std::string geojson_of(const std::vector<TrackPoint>& track);

}  // namespace multipath_localization
