#include "ros/bags/bag_drive.hpp"

#include <rosbag/view.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "evaluation/metrics.hpp"
#include "ros/bags/bag_collector.hpp"
#include "ros/bags/bag_file.hpp"
#include "ros/inputs/told_levels.hpp"
#include "ros/map/datum.hpp"

namespace multipath_localization {

namespace {

/// Finds antennas, and notes once of each frame that it is unknown.
class NotedAntennas {
 public:
  NotedAntennas(BagCollector& bag, std::vector<std::string>& notices) : bag_(bag), notices_(notices) {}

  std::optional<Eigen::Vector2d> operator()(const std::string& frame) {
    const std::optional<Eigen::Vector2d> antenna = bag_.antennas().in_base(frame);
    if (!antenna && unknown_.insert(frame).second) {
      notices_.push_back("no transform to " + bag_.antennas().described(frame) +
                         GnssParameters().otherwise_at());
    }
    return antenna;
  }

 private:
  BagCollector& bag_;
  std::vector<std::string>& notices_;
  std::set<std::string> unknown_;
};

/// Where a measurement puts an antenna.
struct Sighting {
  double stamp = 0.0;
  Geodetic place;
  Eigen::Vector2d antenna_in_base = Eigen::Vector2d::Zero();
};

/// Those of the fixes, without fixes those of the pairs, without pairs those of the epochs that tell.
std::vector<Sighting> sightings(BagCollector& bag) {
  std::vector<Sighting> all;
  std::size_t best = kMeasurementNames.size();
  for (const ReceivedMessage& received : bag.measurements().received())
    best = std::min(best, received.message.index());
  for (const ReceivedMessage& received : bag.measurements().received()) {
    const auto* fix = std::get_if<ReceiverFix>(&received.message);
    if (received.message.index() != best || (fix != nullptr && fix->receiver > 0)) continue;
    const std::optional<Geodetic> place = place_of(received.message, {});
    const std_msgs::Header& header = header_of(received.message);
    const Eigen::Vector2d antenna =
        bag.antennas().in_base(header.frame_id).value_or(Eigen::Vector2d(0.0, 0.0));
    if (place) all.push_back({header.stamp.toSec(), *place, antenna});
  }
  return all;
}

/// Why fixes and truth do not meet, by their times.
std::string no_fix_with_truth(const std::vector<Sighting>& sightings, const std::vector<TruthSample>& truth) {
  const double ahead = sightings.front().stamp - truth.front().stamp;
  char text[300];
  std::snprintf(
      text, sizeof(text),
      "no fix while there is truth: stamps of fixes are from %.2f to %.2f, of truth from %.2f to %.2f: they "
      "begin %.1f s %s it; two clocks?",
      sightings.front().stamp, sightings.back().stamp, truth.front().stamp, truth.back().stamp,
      std::abs(ahead), ahead > 0.0 ? "after" : "before");
  return text;
}

/// The datum on which the sightings lie on truth, see `read_bag`.
Geodetic fitted_datum(const std::vector<Sighting>& sightings, const std::vector<TruthSample>& truth,
                      std::vector<std::string>& notices) {
  const LocalFrame frame(sightings.front().place);
  std::map<bool, std::array<std::vector<double>, 2>> offsets;  // east and north, by whether the sky is open
  for (const Sighting& sighting : sightings) {
    const std::optional<TruthSample> sample = truth_at(truth, sighting.stamp);
    if (!sample) continue;
    const Eigen::Vector2d offset =
        frame.to_map(sighting.place) - antenna_in_map(*sample, sighting.antenna_in_base);
    const bool open = sample->shadow.has_value() && !*sample->shadow;
    offsets[open][0].push_back(offset.x());
    offsets[open][1].push_back(offset.y());
  }
  if (offsets.empty()) throw DriveError(no_fix_with_truth(sightings, truth));
  const auto& [open, best] = *offsets.rbegin();
  const Geodetic datum = frame.to_geodetic({quantile(best[0], 0.5), quantile(best[1], 0.5)});
  char text[300];
  std::snprintf(
      text, sizeof(text), "truth's datum is not in the bag: %.7f, %.7f by the median of %zu %s",
      datum.latitude_deg, datum.longitude_deg, best[0].size(),
      open ? "fixes in open sky"
           : "fixes, in open sky or not, which hides what is constant in their error; --datum tells it");
  notices.emplace_back(text);
  return datum;
}

/// Throws DriveError, naming `file`, where there is none.
Geodetic choose_datum(BagCollector& bag, const std::optional<Geodetic>& given, const std::string& file,
                      Drive& drive) {
  if (given) return *given;
  if (const auto told = bag.datum(); told && !drive.truth.empty()) return *told;
  const std::optional<Geodetic> found = bag.measurements().find_datum();
  if (!found) {
    throw DriveError(file + ": no three measurements agree on a place for a datum" +
                     bag.refusals().in_brackets());
  }
  return drive.truth.empty() ? *found : fitted_datum(sightings(bag), drive.truth, drive.notices);
}

/// Names a datum that no measurement is near.
void note_far_datum(const std::vector<ReceivedMessage>& measurements, Drive& drive) {
  for (const ReceivedMessage& received : measurements) {
    const std::optional<Geodetic> place = place_of(received.message, {});
    if (!drive.measurements.empty() || !place) continue;
    char told[200];
    std::snprintf(told, sizeof(told),
                  " is %.0f km from the measurements: is it of this bag? evaluate --datum "
                  "%.8f,%.8f tells another",
                  distance(drive.datum, *place) / 1000.0, place->latitude_deg, place->longitude_deg);
    drive.notices.push_back("the datum " + to_text(drive.datum) + told);
    return;
  }
}

/// The levels that the driver of the first receiver tells beside its fixes.
ToldLevels read_levels(const rosbag::Bag& bag, const std::string& topic) {
  ToldLevels levels(std::numeric_limits<std::size_t>::max());
  if (topic.empty()) return levels;
  for (const rosbag::MessageInstance& message : rosbag::View(bag, rosbag::TopicQuery(topic))) {
    const auto any = message.instantiate<topic_tools::ShapeShifter>();
    const std::optional<ToldLevel> told = any ? level_of(*any) : std::nullopt;
    if (told) levels.add(*told);
  }
  return levels;
}

void read_measurements(BagCollector& bag, const ToldLevels& levels, Drive& drive) {
  const LocalFrame map(drive.datum);
  NotedAntennas antennas(bag, drive.notices);
  const AntennaFinder find = [&](const std::string& frame) { return antennas(frame); };
  const RotationFinder turned = [&](const std::string& frame) {
    return bag.antennas().rotation_in_base(frame);
  };
  for (const ReceivedMessage& received : bag.measurements().received()) {
    const CheckedMeasurement checked = to_measurement(received.message, map, {}, find, turned);
    if (checked.reason != Reason::kAccepted) {
      bag.measurements().refuse(received.message.index(), checked.reason);
      continue;
    }
    RecordedMeasurement& recorded = drive.measurements.emplace_back();
    recorded.measurement = checked.measurement;
    recorded.arrival = received.arrival;
    auto* fix = std::get_if<GnssFix>(&recorded.measurement);
    if (fix != nullptr && fix->receiver == 0) fix->level = levels.at(fix->stamp);
  }
}

void note_silences(const std::vector<Silence>& silences, Drive& drive) {
  constexpr std::size_t kNamed = 5;
  for (const Silence& silence : silences) {
    drive.restarts.push_back(silence.end);
    if (drive.restarts.size() > kNamed) continue;
    char text[200];
    std::snprintf(
        text, sizeof(text),
        "no odometry for %.1f s from %.2f on (%.1f s from the start): the localization starts afresh "
        "after it, as the node's does",
        silence.end - silence.begin, silence.begin, silence.begin - drive.odometry.front().stamp);
    drive.notices.emplace_back(text);
  }
  if (silences.size() > kNamed)
    drive.notices.push_back(std::to_string(silences.size() - kNamed) + " more such silences of odometry");
}

}  // namespace

Drive read_bag(const std::string& file, const BagTopics& topics, const std::optional<Geodetic>& datum) {
  Drive drive;
  with_bag(file, [&](const rosbag::Bag& bag) {
    const BagTopics found = find_topics(bag, file, topics);
    BagCollector collector(file, found);
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) collector.take(message);
    collector.measurements().finish();
    const BagOdometry& odometry = collector.odometry();
    if (odometry.increments().empty())
      throw DriveError(file + ": no usable odometry" + collector.refusals().in_brackets());
    if (collector.measurements().received().empty())
      throw DriveError(file + ": no usable fix or epoch" + collector.refusals().in_brackets());

    drive.name = std::filesystem::path(file).stem().string();
    drive.odometry = odometry.increments();
    drive.yaw_rates = collector.yaw_rates();
    if (!collector.knows_imu()) {
      drive.notices.emplace_back("no transform to the IMU's frame: it is taken to be level, with z upwards");
    }
    note_silences(odometry.silences(), drive);
    drive.truth = collector.truth().samples();
    if (drive.truth.empty()) drive.notices.emplace_back("no truth: nothing is scored");
    drive.datum = choose_datum(collector, datum, file, drive);
    read_measurements(collector, read_levels(bag, found.level), drive);
    if (odometry.in_map()) {
      drive.notices.emplace_back(
          "odometry is in frame map, as the output of a localisation is: the localization node refuses such");
    }
    const std::vector<std::string> refusals = collector.refusals().lines();
    drive.notices.insert(drive.notices.end(), refusals.begin(), refusals.end());
    drive.left_out = collector.measurements().left_out();
    note_far_datum(collector.measurements().received(), drive);
  });
  return drive;
}

}  // namespace multipath_localization
