#include "tools/track/track.hpp"

#include <rosbag/view.h>
#include <sensor_msgs/NavSatFix.h>

#include <boost/date_time/posix_time/posix_time.hpp>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "ros/bags/bag_file.hpp"
#include "support/csv.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kStep = 0.2;  // finer than any map shows [m]

bool tells_a_place(const sensor_msgs::NavSatFix& fix) {
  const Geodetic place{fix.latitude, fix.longitude, fix.altitude};
  return fix.status.status >= sensor_msgs::NavSatStatus::STATUS_FIX && valid(place);
}

/// Keeps the points that lie a step apart, and the last.
class Thinner {
 public:
  void add(const TrackPoint& point) {
    if (!map_) map_.emplace(point.place);
    const Eigen::Vector2d position = map_->to_map(point.place);
    last_.reset();
    if (kept_.empty() || (position - last_kept_).norm() >= kStep) {
      kept_.push_back(point);
      last_kept_ = position;
    } else {
      last_ = point;
    }
  }

  [[nodiscard]] std::vector<TrackPoint> track() const {
    std::vector<TrackPoint> track = kept_;
    if (last_) track.push_back(*last_);
    return track;
  }

 private:
  std::optional<LocalFrame> map_;
  std::vector<TrackPoint> kept_;
  Eigen::Vector2d last_kept_ = Eigen::Vector2d::Zero();
  std::optional<TrackPoint> last_;  ///< where it was not kept
};

std::string topics_of(const rosbag::Bag& bag) {
  rosbag::View all(bag);
  std::set<std::string> topics;
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    if (connection->datatype == "sensor_msgs/NavSatFix") topics.insert(connection->topic);
  }
  std::string text;
  for (const std::string& topic : topics) text += (text.empty() ? "" : ", ") + topic;
  return text.empty() ? "none" : text;
}

std::string utc(const ros::Time& stamp) {
  return boost::posix_time::to_iso_extended_string(stamp.toBoost()) + "Z";
}

}  // namespace

std::vector<TrackPoint> read_track(const std::string& file, const std::string& topic) {
  Thinner thinner;
  with_bag(file, [&](const rosbag::Bag& bag) {
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    if (view.size() == 0) {
      throw DriveError(file + ": no topic " + topic +
                       "; of sensor_msgs/NavSatFix there are: " + topics_of(bag));
    }
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
      if (of_another_version(*connection)) throw DriveError(file + ": " + topic + " is of another version");
    }
    for (const rosbag::MessageInstance& message : view) {
      const auto fix = message.instantiate<sensor_msgs::NavSatFix>();
      if (!fix)
        throw DriveError(file + ": " + topic + " is no sensor_msgs/NavSatFix but " + message.getDataType());
      if (tells_a_place(*fix))
        thinner.add({fix->header.stamp, {fix->latitude, fix->longitude, fix->altitude}});
    }
  });
  std::vector<TrackPoint> track = thinner.track();
  if (track.empty()) throw DriveError(file + ": " + topic + " tells no place");
  return track;
}

std::string gpx_of(const std::vector<TrackPoint>& track) {
  PlainStream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<gpx xmlns=\"http://www.topografix.com/GPX/1/1\" version=\"1.1\" "
         "creator=\"multipath_localization\">\n"
         "<trk><trkseg>\n"
      << std::fixed;
  for (const TrackPoint& point : track) {
    out << std::setprecision(9) << "<trkpt lat=\"" << point.place.latitude_deg << "\" lon=\""
        << point.place.longitude_deg << "\">";
    if (std::isfinite(point.place.altitude)) {
      out << std::setprecision(3) << "<ele>" << point.place.altitude << "</ele>";
    }
    out << "<time>" << utc(point.stamp) << "</time></trkpt>\n";
  }
  out << "</trkseg></trk>\n</gpx>\n";
  return out.str();
}

std::string geojson_of(const std::vector<TrackPoint>& track) {
  using nlohmann::json;
  json places = json::array();
  json times = json::array();
  for (const TrackPoint& point : track) {
    places.push_back({point.place.longitude_deg, point.place.latitude_deg});
    times.push_back(utc(point.stamp));
  }
  const bool line = track.size() > 1;
  const json geometry = {{"type", line ? "LineString" : "Point"},
                         {"coordinates", line ? places : places.at(0)}};
  return json{{"type", "Feature"}, {"properties", {{"times", times}}}, {"geometry", geometry}}.dump() + "\n";
}

}  // namespace multipath_localization
