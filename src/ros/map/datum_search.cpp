#include "ros/map/datum_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::size_t kEnough = 3;    ///< places that agree
constexpr std::size_t kMost = 20;     ///< that are wanted to move the origin
constexpr std::size_t kWaiting = 50;  ///< at most
constexpr double kScatter = 20.0;     ///< of places that agree [m]
constexpr double kJump = 200.0;       ///< more than reflections move a fix from those before [m]
constexpr double kDriven = 10.0;      ///< from the origin proves it [m]
constexpr double kSigmas = 3.0;
constexpr double kEpochSigma = 30.0;  ///< of the solution of an epoch [m]

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

std::optional<DatumSearch::Sighting> DatumSearch::sighting(const GnssMessage& message) const {
  const std::optional<Geodetic> place = place_of(message, gnss_);
  if (!place) return {};
  const double declared = declared_sigma(message);
  const double otherwise = message.index() == kEpochKind ? kEpochSigma : gnss_.fix.default_sigma;
  return Sighting{message, header_of(message).stamp.toSec(), *place,
                  LocalFrame({place->latitude_deg, place->longitude_deg, 0.0}).origin(),
                  std::isfinite(declared) ? declared : otherwise};
}

bool DatumSearch::near(const Sighting& a, const Sighting& b, double slack) const {
  const double reach = slack + kSigmas * (a.sigma + b.sigma) + max_speed_ * std::abs(a.stamp - b.stamp);
  return (a.in_earth - b.in_earth).norm() <= reach;
}

std::vector<DatumSearch::Decided> DatumSearch::add(const GnssMessage& message) {
  if (proven_) return {{message, Reason::kAccepted}};
  const std::optional<Sighting> seen = sighting(message);
  if (!seen) return {{message, place_ ? Reason::kAccepted : Reason::kNotStarted}};
  return latest_ && near(*latest_, *seen, kJump) ? follow(*seen) : compare(*seen);
}

std::vector<DatumSearch::Decided> DatumSearch::follow(const Sighting& seen) {
  std::vector<Decided> decided;
  for (const GnssMessage& message : take_waiting()) decided.push_back({message, Reason::kInvalidPosition});
  latest_ = seen;
  ++support_;
  if (!place_) average(seen);
  const bool away = (seen.in_earth - *origin_).norm() > kDriven + kSigmas * seen.sigma;
  driven_ = away ? driven_ + 1 : 0;
  proven_ = place_ && driven_ >= kEnough;
  decided.push_back({seen.message, place_ ? Reason::kAccepted : Reason::kNotStarted});
  return decided;
}

std::size_t DatumSearch::needed() const { return std::clamp(support_, kEnough, kMost); }

std::vector<DatumSearch::Decided> DatumSearch::compare(const Sighting& seen) {
  waiting_.push_back(seen);
  std::vector<const Sighting*> agreeing;
  for (const Sighting& other : waiting_) {
    if (near(other, seen, kScatter)) agreeing.push_back(&other);
  }
  std::vector<Decided> decided;
  if (agreeing.size() < needed()) {
    if (waiting_.size() <= kWaiting) return {};
    decided.push_back({waiting_.front().message, Reason::kInvalidPosition});
    waiting_.pop_front();
    return decided;
  }
  place_.reset();
  places_.clear();
  first_stamp_ = agreeing.front()->stamp;
  origin_ = agreeing.front()->in_earth;
  for (const Sighting* each : agreeing) average(*each);
  for (const Sighting& each : waiting_) {
    const Reason agrees = place_ ? Reason::kAccepted : Reason::kNotStarted;
    decided.push_back({each.message, near(each, seen, kScatter) ? agrees : Reason::kInvalidPosition});
  }
  latest_ = seen;
  support_ = agreeing.size();
  driven_ = 0;
  waiting_.clear();
  return decided;
}

void DatumSearch::average(const Sighting& seen) {
  if (place_) return;
  places_.push_back(seen.place);
  if (std::abs(seen.stamp - first_stamp_) < averaging_) return;
  place_ = {median(places_, [](const Geodetic& p) { return p.latitude_deg; }),
            median(places_, [](const Geodetic& p) { return p.longitude_deg; }),
            median(places_, [](const Geodetic& p) { return p.altitude; })};
}

std::vector<GnssMessage> DatumSearch::take_waiting() {
  std::vector<GnssMessage> messages;
  for (const Sighting& waiting : std::exchange(waiting_, {})) messages.push_back(waiting.message);
  return messages;
}

}  // namespace multipath_localization
