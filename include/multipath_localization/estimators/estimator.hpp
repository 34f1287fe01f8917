#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// The seam: one published method. Deterministic: the same seed and the same calls give the same bytes.
///
/// Time runs by `predict` alone. A measurement is taken to have been made with the base where it is now; what
/// was measured earlier arrives with its lever arm carried back over the odometry (see Localizer).
/// Nothing throws on bad input: it is refused with a reason and changes nothing.
class Estimator {
 public:
  Estimator() = default;
  Estimator(const Estimator&) = delete;
  Estimator& operator=(const Estimator&) = delete;
  virtual ~Estimator() = default;

  /// Forgets everything and starts at the prior, or, without one, with position and heading unknown.
  virtual void start(const std::optional<PosePrior>& prior) = 0;

  /// Moves on by one odometry increment. A parked robot's has no yaw rate: see Standstill.
  virtual void predict(const OdometryIncrement& u) = 0;

  /// Whether there is a model for measurements of that kind, an index of Measurement: by default for fixes.
  [[nodiscard]] virtual bool uses(std::size_t kind) const { return kind == kFixKind; }

  /// Weighs one measurement; kinds that it does not use are refused as `unused`.
  virtual Innovation update(const Measurement& z) = 0;

  /// Shows parameters to a visitor that may change them between two calls. What is known stays; what counts
  /// at a start counts from the next one on.
  virtual void tune(ParameterVisitor& /*field*/) {}

  /// The pose at the end of the last increment.
  [[nodiscard]] virtual PoseEstimate estimate() const = 0;

  /// What the estimate was made of; a single hypothesis for a Kalman filter, none before the first
  /// measurement.
  [[nodiscard]] virtual std::vector<Hypothesis> hypotheses() const = 0;
};

}  // namespace multipath_localization
