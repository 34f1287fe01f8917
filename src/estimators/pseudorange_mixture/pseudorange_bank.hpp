#pragma once

#include <vector>

#include "estimators/pseudorange_mixture/dominant_cluster.hpp"
#include "estimators/pseudorange_mixture/pseudorange_hypothesis.hpp"
#include "estimators/pseudorange_mixture/satellite_slots.hpp"

namespace multipath_localization {

/// The hypotheses of the pseudorange mixture filter, the odometry on its way to them, and which of them
/// agree.
class PseudorangeBank {
 public:
  PseudorangeBank(const OdometryNoise& odometry, const ReceiverStateNoise& receiver)
      : odometry_noise_(odometry), receiver_(receiver), odometry_(odometry) {}

  [[nodiscard]] bool empty() const { return hypotheses_.empty(); }
  [[nodiscard]] const std::vector<PseudorangeHypothesis>& hypotheses() const { return hypotheses_; }
  /// The one of most weight.
  [[nodiscard]] const PseudorangeHypothesis& heaviest() const;
  void clear();
  void add(const std::vector<PseudorangeHypothesis>& newcomers);

  /// Sums up an increment of odometry; returns the duration of all that are summed up [s].
  double add(const OdometryIncrement& u);
  /// Moves the hypotheses by the odometry summed up; `refresh` has to follow.
  void move(const MotionLaws& laws, const SatelliteSlots& slots);
  /// Makes the changes of the slots in every hypothesis.
  void follow(const std::vector<SatelliteSlots::Change>& changes);
  /// Of the state of this owner while nothing is known of it [m^2].
  [[nodiscard]] double unknown_variance(const SlotOwner& owner) const;

  /// Weighs an epoch, and drops and merges hypotheses as `thin_out` with `least` does.
  void update(const SlottedEpoch& epoch, const MotionLaws& laws, const RangeErrorParameters& errors,
              double least);
  /// Share of the last epoch's satellites in line of sight, over all hypotheses.
  [[nodiscard]] double line_of_sight_share() const;

  /// Finds the dominant cluster anew, and begins a new sum of odometry; `aligned`: the heading is known.
  void refresh(bool aligned);
  /// Of the hypotheses as they were refreshed last.
  [[nodiscard]] const DominantCluster& cluster() const { return cluster_; }
  /// The dominant cluster whatever the heading.
  [[nodiscard]] const DominantCluster& place() const { return place_; }
  /// The belief as the odometry summed up moves it on.
  [[nodiscard]] Belief current(const Belief& belief) const;

 private:
  OdometryNoise odometry_noise_;
  ReceiverStateNoise receiver_;
  std::vector<PseudorangeHypothesis> hypotheses_;
  DominantCluster cluster_;
  DominantCluster place_;
  PreintegratedOdometry odometry_;  ///< since the hypotheses were last moved
};

}  // namespace multipath_localization
