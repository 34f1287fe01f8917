#include "evaluation/metrics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>

namespace multipath_localization {

namespace {

/// 95 % quantile of the chi-square distribution with 2 degrees of freedom, -2 ln 0.05.
constexpr double kChiSquare95 = 5.991464547107979;

/// One square millimetre: keeps the NEES of a particle set that has collapsed to a point finite.
constexpr double kResolution = 1e-6;

struct PositionError {
  double distance = 0.0;  ///< [m]
  std::optional<bool> shadow;
};

class MeanSquare {
 public:
  void add(double value) {
    sum_ += value * value;
    ++count_;
  }
  [[nodiscard]] std::optional<double> root() const {
    if (count_ == 0) return std::nullopt;
    return std::sqrt(sum_ / static_cast<double>(count_));
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

std::optional<double> mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// The longest time on end [s] that `holds`, from the first valid epoch on; a stretch ends with the first
/// epoch that is out of it.
std::optional<double> longest(const std::vector<Epoch>& epochs, double from,
                              const std::function<bool(const Epoch&)>& holds) {
  std::optional<double> longest;
  std::optional<double> since;
  for (const Epoch& epoch : epochs) {
    const bool counts = epoch.truth.stamp >= from && (epoch.valid || longest);
    if (!counts) continue;
    if (!since) since = epoch.truth.stamp;
    longest = std::max(longest.value_or(0.0), epoch.truth.stamp - *since);
    if (!holds(epoch)) since.reset();
  }
  return longest;
}

void summarise(const std::vector<PositionError>& errors, Score& score) {
  std::vector<double> distances;
  MeanSquare all;
  MeanSquare shadow;
  MeanSquare open;
  for (const PositionError& error : errors) {
    distances.push_back(error.distance);
    all.add(error.distance);
    if (error.shadow) (*error.shadow ? shadow : open).add(error.distance);
  }
  score.epochs = errors.size();
  score.rmse = all.root();
  score.rmse_shadow = shadow.root();
  score.rmse_open = open.root();
  if (distances.empty()) return;
  score.mean = mean(distances);
  score.median = quantile(distances, 0.5);
  score.p95 = quantile(distances, 0.95);
  score.max = *std::max_element(distances.begin(), distances.end());
}

}  // namespace

Eigen::Vector2d error_of(const Epoch& epoch) {
  return epoch.estimate.position() - epoch.truth.base_in_map.position();
}

double nees_of(const Epoch& epoch) {
  const Eigen::Vector2d error = error_of(epoch);
  const Eigen::Matrix2d P = epoch.position_covariance + kResolution * Eigen::Matrix2d::Identity();
  return error.dot(P.ldlt().solve(error));
}

double quantile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

Score score(const std::vector<Epoch>& epochs, double from) {
  Score score;
  std::vector<PositionError> errors;
  std::vector<double> nees;
  MeanSquare heading;
  double inside = 0.0;
  for (const Epoch& epoch : epochs) {
    if (epoch.truth.stamp < from) continue;
    if (!epoch.valid) {
      ++score.unscored;
      continue;
    }
    errors.push_back({error_of(epoch).norm(), epoch.truth.shadow});
    nees.push_back(nees_of(epoch));
    inside += nees.back() <= kChiSquare95 ? 1.0 : 0.0;
    if (epoch.truth.has_yaw) heading.add(angle_difference(epoch.estimate.yaw, epoch.truth.base_in_map.yaw));
  }
  summarise(errors, score);
  score.heading_rmse = heading.root();
  score.nees_mean = mean(nees);
  if (!nees.empty()) score.in_ellipse = inside / static_cast<double>(nees.size());
  return score;
}

std::optional<double> longest_off(const std::vector<Epoch>& epochs, double from, double distance) {
  return longest(epochs, from,
                 [&](const Epoch& epoch) { return !epoch.valid || error_of(epoch).norm() >= distance; });
}

std::optional<double> longest_beyond_3_sigma(const std::vector<Epoch>& epochs, double from) {
  return longest(epochs, from, [](const Epoch& epoch) { return epoch.valid && nees_of(epoch) > 9.0; });
}

std::optional<double> way_to_alignment(const std::vector<Epoch>& epochs) {
  double way = 0.0;
  for (std::size_t i = 0; i < epochs.size(); ++i) {
    if (i > 0) {
      way += (epochs[i].truth.base_in_map.position() - epochs[i - 1].truth.base_in_map.position()).norm();
    }
    if (epochs[i].valid && epochs[i].aligned) return way;
  }
  return std::nullopt;
}

Score score_fixes(const Drive& drive, double from) {
  std::vector<PositionError> errors;
  for (const GnssFix& fix : drive.fixes()) {
    if (fix.stamp < from) continue;
    const std::optional<TruthSample> truth = truth_at(drive.truth, fix.stamp);
    if (!truth) continue;
    const Eigen::Vector2d antenna = antenna_in_map(*truth, fix.antenna_in_base);
    errors.push_back({(fix.position - antenna).norm(), truth->shadow});
  }
  Score score;
  summarise(errors, score);
  return score;
}

}  // namespace multipath_localization
