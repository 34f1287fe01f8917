#pragma once

#include "estimators/multipath/hypothesis.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization::multipath {

/// A fix, and what led up to it.
struct Sighting {
  GnssFix fix;                     ///< covariance positive definite
  double duration = 0.0;           ///< since the last one of this receiver, > 0 [s]
  double between = 0.0;            ///< of that, until the last one of another receiver [s]
  bool after_gap = false;          ///< the first fix after a gap of all receivers
  bool refixed = false;            ///< the first for which the receiver has fixed its ambiguities
  bool reacquired = false;         ///< soon after one or the other, with which a receiver begins anew
  bool standing = false;           ///< the wheels stood for most of that
  bool turns_by_gyro = false;      ///< turns since the last one are a gyro's
  double level = 0.0;              ///< declared sigma that holds from now on [m]
  double usual_speed = 0.0;        ///< of the robot [m/s]
  double fault_probability = 0.0;  ///< that the wheels begin to fail now
  double largest_bias = 40.0;      ///< of a shadow [m]
  double shadow_entry_rate = 0.0;  ///< [1/s]

  /// For which the odometry has gone on alone [s].
  [[nodiscard]] double unseen() const { return duration - between; }
};

/// What a fix says of a hypothesis.
struct Evidence {
  double log_likelihood = 0.0;  ///< over all explanations
  double log_stay = 0.0;        ///< log probability of what the hypothesis was before going on
  bool event = false;           ///< whether something else than that was chosen
};

/// Explains a fix by one of what may have happened, drawn by prior times likelihood, equations (9)..(11):
/// what was goes on; an outlier; a shadow begins, changes at once or ends; the wheels fail; the hypothesis
/// was wrong and is lost. The hypothesis becomes what was drawn and is corrected by the fix.
Evidence explain(Hypothesis& hypothesis, const Sighting& sighting, RandomStream& random);

}  // namespace multipath_localization::multipath
