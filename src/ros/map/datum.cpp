#include "ros/map/datum.hpp"

#include <ros/console.h>

#include <cstdio>
#include <stdexcept>
#include <utility>

#include "ros/map/datum_file.hpp"

namespace multipath_localization {

namespace {

std::string text_of(const LocalFrame& map) {
  const Geodetic& datum = map.datum();
  char text[100];
  std::snprintf(text, sizeof(text), "[%.9f, %.9f, %.3f]", datum.latitude_deg, datum.longitude_deg,
                datum.altitude);
  return text;
}

}  // namespace

Datum::Datum(const std::optional<Geodetic>& configured, DatumSearch search, std::string file)
    : search_(std::move(search)), file_(std::move(file)) {
  if (configured) {
    map_.emplace(*configured);
  } else if (const auto saved = file_.empty() ? std::nullopt : read_datum(file_)) {
    map_.emplace(*saved);
    from_file_ = true;
    ROS_INFO("datum of map: %s, from %s", text_of(*map_).c_str(), file_.c_str());
  }
  told_ = map_.has_value();
}

void Datum::set(const Geodetic& place) {
  map_.emplace(place);
  told_ = true;
  from_file_ = false;
  drop_waiting();
  ROS_INFO("datum of map: %s", text_of(*map_).c_str());
  save();
}

void Datum::save() const {
  if (file_.empty()) return;
  try {
    write_datum(file_, map_->datum());
  } catch (const std::runtime_error& error) {
    ROS_ERROR("the datum is not saved: %s", error.what());
  }
}

Datum::Admission Datum::admit(const GnssMessage& message) {
  if (settled()) return {{{message, Reason::kAccepted}}};
  Admission admission{search_.add(message)};
  const std::optional<Geodetic>& found = search_.place();
  if (found && (!map_ || distance(map_->datum(), *found) > 0.0)) {
    admission.moved = map_.has_value();
    map_.emplace(*found);
    ROS_INFO("datum of map: %s", text_of(*map_).c_str());
  }
  if (search_.proven()) save();
  return admission;
}

std::string Datum::distance_to(const Geodetic& place) const {
  if (!map_) return "";
  char far[60];
  std::snprintf(far, sizeof(far), " is %.0f km from ", distance(map_->datum(), place) / 1000.0);
  const std::string what =
      "the datum " + to_text(map_->datum()) + (from_file_ ? ", from " + file_ + "," : "");
  const std::string remedy =
      from_file_ ? "if the fixes are right, stop the node, remove " + file_ + " and start it again"
                 : "if the fixes are right: datum: " + to_text(place);
  return what + far + to_text(place) + "; " + remedy;
}

std::string to_text(const Geodetic& place) {
  char text[80];
  std::snprintf(text, sizeof(text), "[%.8f, %.8f]", place.latitude_deg, place.longitude_deg);
  return text;
}

double distance(const Geodetic& datum, const Geodetic& place) {
  const auto on_ground = [](const Geodetic& p) {
    return LocalFrame({p.latitude_deg, p.longitude_deg, 0.0}).origin();
  };
  return (on_ground(datum) - on_ground(place)).norm();
}

}  // namespace multipath_localization
