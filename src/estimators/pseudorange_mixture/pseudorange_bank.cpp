#include "estimators/pseudorange_mixture/pseudorange_bank.hpp"

#include <algorithm>

#include "estimators/pseudorange_mixture/hypothesis_bank.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

const PseudorangeHypothesis& PseudorangeBank::heaviest() const {
  return *std::max_element(hypotheses_.begin(), hypotheses_.end(),
                           [](const auto& a, const auto& b) { return a.log_weight < b.log_weight; });
}

void PseudorangeBank::clear() {
  hypotheses_.clear();
  cluster_ = place_ = DominantCluster();
  odometry_.restart(0.0, 0.0);
}

void PseudorangeBank::add(const std::vector<PseudorangeHypothesis>& newcomers) {
  hypotheses_.insert(hypotheses_.end(), newcomers.begin(), newcomers.end());
}

double PseudorangeBank::add(const OdometryIncrement& u) {
  odometry_.add(u);
  return odometry_.duration();
}

void PseudorangeBank::move(const MotionLaws& laws, const SatelliteSlots& slots) {
  for (PseudorangeHypothesis& hypothesis : hypotheses_) {
    hypothesis.propagate(odometry_, laws, odometry_noise_, receiver_, slots);
  }
}

void PseudorangeBank::follow(const std::vector<SatelliteSlots::Change>& changes) {
  for (const SatelliteSlots::Change& change : changes) {
    for (PseudorangeHypothesis& hypothesis : hypotheses_) {
      if (change.removed) {
        hypothesis.remove(*change.removed);
      } else {
        hypothesis.append(unknown_variance(change.appended));
      }
    }
  }
}

double PseudorangeBank::unknown_variance(const SlotOwner& owner) const {
  return square(owner.satellite ? receiver_.bias_sigma : receiver_.offset_sigma);
}

void PseudorangeBank::update(const SlottedEpoch& epoch, const MotionLaws& laws,
                             const RangeErrorParameters& errors, double least) {
  for (PseudorangeHypothesis& hypothesis : hypotheses_) hypothesis.update(epoch, laws, errors);
  thin_out(hypotheses_, least);
}

double PseudorangeBank::line_of_sight_share() const {
  const std::vector<double> weights = weights_of(hypotheses_);
  double share = 0.0;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    share += weights[i] * hypotheses_[i].line_of_sight_share();
  }
  return share;
}

void PseudorangeBank::refresh(bool aligned) {
  const std::vector<WeightedBelief> particles = planar(hypotheses_);
  cluster_ = dominant_cluster(particles);
  place_ = aligned ? cluster_ : dominant_cluster(particles, kPi);
  odometry_.restart(cluster_.belief.mean(kScale), cluster_.belief.mean(kGyroBias));
}

Belief PseudorangeBank::current(const Belief& belief) const {
  Belief moved = belief;
  moved.propagate(odometry_, odometry_noise_);
  return moved;
}

}  // namespace multipath_localization
