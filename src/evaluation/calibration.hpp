#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "evaluation/metrics.hpp"

namespace multipath_localization {

/// Sum and weight of a mean that goes on over runs.
struct RunningMean {
  double sum = 0.0;
  double weight = 0.0;

  void add(double value, double weight_of_it) { sum += weight_of_it * value, weight += weight_of_it; }
  void add(const RunningMean& other) { sum += other.sum, weight += other.weight; }
  /// Nothing without any weight.
  [[nodiscard]] std::optional<double> value() const;
};

/// How soon a probability told of something that lasts for a while: it tells while it is over one half.
struct Detection {
  std::vector<double> told;     ///< after the beginning [s], of each time that was told of before its end
  std::vector<double> cleared;  ///< after the end [s], of each time that was told of no more before the next
  std::size_t missed = 0;       ///< times over before they were told of
  RunningMean brier;            ///< (probability - truth)^2: 0 is best, always saying one half gives 0.25
};

/// What an estimator claimed of its errors, against what they were: sums, to be added up over runs. Times in
/// [s]; an epoch counts for the time to the next one, for one second at most.
struct Calibration {
  static constexpr std::size_t kStates = 6;  ///< of Trust
  static constexpr std::array<double, 4> kEllipses = {0.5, 0.9, 0.95, 0.997};
  static constexpr std::size_t kBins = 20;
  static constexpr int kBinsPerDecade = 4;  ///< of the Stanford diagram, from kLeast on
  static constexpr double kLeast = 0.01;    ///< [m]

  double time = 0.0;  ///< with an estimate
  std::array<double, kEllipses.size()>
      inside{};  ///< time with the error inside the ellipse of that probability
  std::array<double, kBins>
      pit{};  ///< time by the probability that was given to a smaller error: even is best
  /// Time by bins of the error and of 3 sigma along the longest axis, both logarithmic.
  std::map<std::pair<int, int>, double> stanford;
  std::array<double, kStates> in_state{};  ///< time
  std::array<double, kStates> beyond{};    ///< of that outside the 3 sigma ellipse
  std::size_t good_minutes = 0;            ///< minutes of the clock in which the state was GOOD at times
  std::size_t false_minutes = 0;           ///< of these, with over 2 s on end outside 3 sigma while GOOD
  double open = 0.0;                       ///< time under open sky, by truth
  double open_good = 0.0;                  ///< of that in state GOOD
  RunningMean position_open;               ///< normalised error squared of position: 2 is ideal
  RunningMean position_shadow;             ///< by the truth's flag; without one all counts as open
  RunningMean heading_open;                ///< of heading: 1 is ideal
  RunningMean heading_shadow;
  Detection shadow;
  Detection wheel_fault;
  RunningMean nis;       ///< normalised innovation squared of the fixes that were compared: 2 is ideal
  RunningMean nis_next;  ///< correlation of one with the next, run by run: 0 is ideal

  void add(const Calibration& other);
};

/// That of a run, by its epochs from `from` on and by the NIS of its fixes in their order.
Calibration calibration(const std::vector<Epoch>& epochs, double from, const std::vector<double>& nis);

}  // namespace multipath_localization
