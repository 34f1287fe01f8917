#include "evaluation/calibration.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kLongestEpoch = 1.0;   ///< [s]
constexpr double kMinute = 60.0;        ///< [s]
constexpr double kFalseFor = 2.0;       ///< a GOOD pose may be outside 3 sigma for a moment [s]
constexpr double kThreeSigma = 9.0;     ///< squared
constexpr double kLeastHeading = 1e-8;  ///< variance that is added, of a set that has collapsed [rad^2]

/// An epoch with an estimate, and for how long it stands.
struct Moment {
  const Epoch* epoch;
  double duration;  ///< [s]
};

std::vector<Moment> moments_of(const std::vector<Epoch>& epochs, double from) {
  std::vector<Moment> moments;
  for (std::size_t i = 0; i + 1 < epochs.size(); ++i) {
    if (epochs[i].truth.stamp < from || !epochs[i].valid) continue;
    const double duration = epochs[i + 1].truth.stamp - epochs[i].truth.stamp;
    moments.push_back({&epochs[i], std::min(kLongestEpoch, duration)});
  }
  return moments;
}

bool in_shadow(const Epoch& epoch) { return epoch.truth.shadow.value_or(false); }

bool good(const Epoch& epoch) { return epoch.state == Trust::kGood; }

int bin_of(double distance) {
  const double decades = std::log10(std::max(distance, Calibration::kLeast) / Calibration::kLeast);
  return static_cast<int>(decades * Calibration::kBinsPerDecade);
}

void count_position(const Epoch& epoch, double duration, Calibration& c) {
  const double nees = nees_of(epoch);
  const double smaller = -std::expm1(-0.5 * nees);  // chi-square of two degrees of freedom
  for (std::size_t k = 0; k < Calibration::kEllipses.size(); ++k) {
    if (smaller <= Calibration::kEllipses[k]) c.inside[k] += duration;
  }
  const auto bin = static_cast<std::size_t>(smaller * static_cast<double>(Calibration::kBins));
  c.pit[std::min(bin, Calibration::kBins - 1)] += duration;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(epoch.position_covariance);
  const double longest = 3.0 * std::sqrt(std::max(0.0, axes.eigenvalues()(1)));
  c.stanford[{bin_of(error_of(epoch).norm()), bin_of(longest)}] += duration;
  (in_shadow(epoch) ? c.position_shadow : c.position_open).add(nees, duration);
}

void count_heading(const Epoch& epoch, double duration, Calibration& c) {
  if (!epoch.truth.has_yaw || epoch.yaw_variance <= 0.0) return;
  const double error = angle_difference(epoch.estimate.yaw, epoch.truth.base_in_map.yaw);
  (in_shadow(epoch) ? c.heading_shadow : c.heading_open)
      .add(square(error) / (epoch.yaw_variance + kLeastHeading), duration);
}

/// Of an estimator that a localizer runs; others have no state.
void count_state(const Epoch& epoch, double duration, Calibration& c) {
  if (epoch.state == Trust::kNotReady) return;
  const auto state = static_cast<std::size_t>(epoch.state);
  c.in_state[state] += duration;
  if (nees_of(epoch) > kThreeSigma) c.beyond[state] += duration;
  if (in_shadow(epoch)) return;
  c.open += duration;
  if (good(epoch)) c.open_good += duration;
}

/// Counts the minutes in which the state was GOOD, and those in which it was so wrongly.
void count_minutes(const std::vector<Moment>& moments, Calibration& c) {
  std::map<long, bool> minutes;
  double wrong = 0.0;
  for (const auto& [epoch, duration] : moments) {
    const bool is_wrong = good(*epoch) && nees_of(*epoch) > kThreeSigma;
    wrong = is_wrong ? wrong + duration : 0.0;
    if (good(*epoch)) minutes[std::lround(std::floor(epoch->truth.stamp / kMinute))] |= wrong > kFalseFor;
  }
  c.good_minutes = minutes.size();
  c.false_minutes = static_cast<std::size_t>(
      std::count_if(minutes.begin(), minutes.end(), [](const auto& minute) { return minute.second; }));
}

/// Whether something holds by truth, and what probability it was given.
using Told = std::function<std::pair<std::optional<bool>, double>(const Epoch&)>;

/// Something that is waited for since a time.
struct Wait {
  bool on = false;
  double since = 0.0;  ///< [s]

  /// Ends the wait, if there is one, and notes how long it was.
  void end(double now, std::vector<double>& waits) {
    if (on) waits.push_back(now - since);
    on = false;
  }
};

/// Follows what is told of something that begins and ends.
class Follower {
 public:
  void see(bool truth, double probability, double now) {
    if (truth && !was_) beginning_ = {true, now}, ending_ = {};
    if (!truth && was_) end(now);
    was_ = truth;
    probability > 0.5 ? beginning_.end(now, detection.told) : ending_.end(now, detection.cleared);
  }

  Detection detection;

 private:
  void end(double now) {
    detection.missed += beginning_.on ? 1 : 0;
    beginning_ = {}, ending_ = {true, now};
  }

  bool was_ = false;
  Wait beginning_;  // not told of yet
  Wait ending_;     // still told of
};

Detection detection(const std::vector<Moment>& moments, const Told& told_of) {
  Follower follower;
  for (const auto& [epoch, duration] : moments) {
    const auto& [truth, probability] = told_of(*epoch);
    if (!truth) continue;
    follower.detection.brier.add(square(probability - (*truth ? 1.0 : 0.0)), duration);
    follower.see(*truth, probability, epoch->truth.stamp);
  }
  return follower.detection;
}

/// Correlation of each value with the next; nothing of fewer than ten.
std::optional<double> correlation_with_next(const std::vector<double>& values) {
  if (values.size() < 10) return std::nullopt;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    squares += square(values[i] - mean);
    products += (values[i] - mean) * (values[i + 1] - mean);
  }
  if (squares <= 0.0) return std::nullopt;
  return products / squares;
}

void append(const std::vector<double>& from, std::vector<double>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

void add(const Detection& from, Detection& to) {
  append(from.told, to.told);
  append(from.cleared, to.cleared);
  to.missed += from.missed;
  to.brier.add(from.brier);
}

template <std::size_t size>
void add(const std::array<double, size>& from, std::array<double, size>& to) {
  std::transform(from.begin(), from.end(), to.begin(), to.begin(), std::plus<>());
}

}  // namespace

std::optional<double> RunningMean::value() const {
  return weight > 0.0 ? std::optional(sum / weight) : std::nullopt;
}

void Calibration::add(const Calibration& other) {
  time += other.time;
  multipath_localization::add(other.inside, inside);
  multipath_localization::add(other.pit, pit);
  for (const auto& [bins, duration] : other.stanford) stanford[bins] += duration;
  multipath_localization::add(other.in_state, in_state);
  multipath_localization::add(other.beyond, beyond);
  good_minutes += other.good_minutes;
  false_minutes += other.false_minutes;
  open += other.open;
  open_good += other.open_good;
  position_open.add(other.position_open);
  position_shadow.add(other.position_shadow);
  heading_open.add(other.heading_open);
  heading_shadow.add(other.heading_shadow);
  multipath_localization::add(other.shadow, shadow);
  multipath_localization::add(other.wheel_fault, wheel_fault);
  nis.add(other.nis);
  nis_next.add(other.nis_next);
}

Calibration calibration(const std::vector<Epoch>& epochs, double from, const std::vector<double>& nis) {
  Calibration c;
  const std::vector<Moment> moments = moments_of(epochs, from);
  for (const auto& [epoch, duration] : moments) {
    c.time += duration;
    count_position(*epoch, duration, c);
    count_heading(*epoch, duration, c);
    count_state(*epoch, duration, c);
  }
  count_minutes(moments, c);
  c.shadow = detection(
      moments, [](const Epoch& epoch) { return std::pair(epoch.truth.shadow, epoch.shadow_probability); });
  c.wheel_fault = detection(moments, [](const Epoch& epoch) {
    return std::pair(epoch.truth.wheel_fault, epoch.wheel_fault_probability);
  });
  for (const double value : nis) c.nis.add(value, 1.0);
  if (const auto correlation = correlation_with_next(nis)) c.nis_next.add(*correlation, 1.0);
  return c;
}

}  // namespace multipath_localization
