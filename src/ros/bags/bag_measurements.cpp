#include "ros/bags/bag_measurements.hpp"

#include <utility>

#include "ros/map/datum.hpp"
#include "ros/map/datum_search.hpp"

namespace multipath_localization {

void BagMeasurements::add(const GnssMessage& message) {
  const Reason defect = check(message, {});
  if (defect != Reason::kAccepted) return refuse(message.index(), defect);
  const double stamp = header_of(message).stamp.toSec();
  for (const std::string& frame : frames_of(message))
    antennas_.in_base(frame);  // which sees whether it moves
  received_.push_back({message, odometry_.arrival(stamp)});
}

void BagMeasurements::add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix) {
  const FixPairing::Outcome outcome = pairing_.add(side, fix);
  for (const sensor_msgs::NavSatFix& unpaired : outcome.unpaired) give_up(unpaired);
  if (outcome.pair) add(GnssMessage(*outcome.pair));
}

void BagMeasurements::finish() {
  for (const sensor_msgs::NavSatFix& fix : pairing_.clear()) give_up(fix);
}

void BagMeasurements::give_up(const sensor_msgs::NavSatFix& fix) {
  const Reason defect = check(fix, FixParameters{});
  refuse(kDualKind, defect == Reason::kAccepted ? Reason::kUnpaired : defect);
}

void BagMeasurements::refuse(std::size_t kind, Reason reason) {
  refusals_.passes(topic_of(kind), reason);
  left_out_[kind].count(reason);
}

std::optional<Geodetic> BagMeasurements::find_datum() {
  DatumSearch search({}, OdometryParameters{}.max_speed, 0.0);
  std::vector<ReceivedMessage> kept;
  std::size_t next = 0;  // to be decided on
  std::optional<Geodetic> found;
  for (const ReceivedMessage& received : received_) {
    const std::vector<DatumSearch::Decided> decided = search.add(received.message);
    if (found && distance(*found, *search.place()) > 0.0) {
      for (const ReceivedMessage& nonsense : std::exchange(kept, {})) {
        refuse(nonsense.message.index(), Reason::kInvalidPosition);
      }
    }
    found = search.place();
    for (const auto& [message, reason] : decided) {
      const double arrival = received_[next++].arrival;
      if (reason == Reason::kAccepted)
        kept.push_back({message, arrival});
      else
        refuse(message.index(), reason);
    }
  }
  for (const GnssMessage& message : search.take_waiting()) refuse(message.index(), Reason::kInvalidPosition);
  if (!found) return std::nullopt;
  received_ = kept;
  return found;
}

std::string BagMeasurements::topic_of(std::size_t kind) const {
  if (kind == kFixKind) return topics_.fix;
  if (kind == kVelocityKind) return topics_.velocity;
  if (kind == kHeadingKind) return topics_.heading;
  return kind == kEpochKind ? topics_.epoch : topics_.left + " and " + topics_.right;
}

}  // namespace multipath_localization
