#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "estimators/multipath/multipath_particle_filter.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/estimator.hpp"

namespace multipath_localization {

struct FallbackParameters {
  bool enabled = true;
  double after = 2.0;
  double handover_sigma = 3.0;
  MultipathParticleFilterParameters fixes;

  void fields(ParameterVisitor& field);
};

/// An estimator of raw epochs, and one of fixes that stands in for it while no epochs come.
///
/// The first one sees all odometry and speaks as long as epochs are accepted; fixes are `not needed` then.
/// With the first fix after `after` seconds without an epoch the second one starts where the first is by now,
/// from nothing where the first is not aligned. From then on the one that knows the position better speaks:
/// fixes among buildings may know it worse than a minute's odometry. With the first epoch after that the
/// first one speaks again, from where the second is if that spoke. What is handed over is a pose and its
/// covariance, over all hypotheses, and `handover_sigma` beside it: the two err differently.
class FallbackEstimator : public Estimator {
 public:
  FallbackEstimator(std::unique_ptr<Estimator> of_epochs, std::unique_ptr<Estimator> of_fixes,
                    const FallbackParameters& parameters);

  void start(const std::optional<PosePrior>& prior) override;
  void predict(const OdometryIncrement& u) override;
  [[nodiscard]] bool uses(std::size_t kind) const override { return kind == kFixKind || kind == kEpochKind; }
  Innovation update(const Measurement& z) override;
  [[nodiscard]] PoseEstimate estimate() const override;
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const override;

 private:
  Innovation use(const GnssFix& fix);
  Innovation use(const PseudorangeEpoch& epoch);
  /// Starts an estimator at the estimate of the other one.
  void hand_over(const PoseEstimate& estimate, Estimator& to) const;
  [[nodiscard]] const Estimator& speaker() const { return fixes_speak_ ? *of_fixes_ : *of_epochs_; }

  std::unique_ptr<Estimator> of_epochs_;
  std::unique_ptr<Estimator> of_fixes_;
  FallbackParameters parameters_;
  std::optional<OdometryIncrement> last_;  ///< none before the first
  double last_epoch_ = 0.0;                ///< accepted, or the start [s]
  bool fallen_back_ = false;               ///< fixes are used
  bool fixes_speak_ = false;               ///< and know more than odometry has kept of the epochs
};

}  // namespace multipath_localization
