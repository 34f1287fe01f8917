#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "evaluation/drive.hpp"
#include "evaluation/metrics.hpp"
#include "multipath_localization/localization/localizer.hpp"

namespace multipath_localization {

/// Makes the estimator of one run. Called in the thread that runs it.
using EstimatorFactory = std::function<std::unique_ptr<Estimator>()>;

/// Told the fraction of a run that is done, 0..1, now and then.
using ProgressReport = std::function<void(double)>;

/// Told what became of each measurement.
using FateReport = std::function<void(const MeasurementReport&)>;

/// Tells what became of the measurements that were weighed since the last call, where anybody listens.
void hand_on_reports(Localizer& localizer, const FateReport& fate);

/// How an estimator is put on a stream.
struct RunSettings {
  LocalizerParameters localizer;
  bool known_start =
      false;  ///< the true pose at the start is the prior; otherwise position and heading are unknown
};

/// A run cannot go on: the estimate is not finite, or the start that shall be known is not.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs an estimator over a drive in the order of arrival: odometry at its stamp, a measurement at its
/// arrival, and at equal times yaw rate, odometry, measurement, truth. There is one epoch per truth sample
/// or, without any truth, every tenth of a second of odometry: the estimate after everything that had arrived
/// by then, carried from the last odometry stamp to the sample's by the speed and yaw rate of the last
/// increment. Samples more than a second past the last odometry count as without estimate. At the drive's
/// restarts the localizer starts afresh, position and heading unknown. Throws RunError.
std::vector<Epoch> run_drive(const Drive& drive, const EstimatorFactory& make, const RunSettings& settings,
                             const ProgressReport& progress = nullptr, const FateReport& fate = nullptr);

/// The prior of a known start: the pose, with 0.1 m and 0.02 rad of standard deviation.
PosePrior known_start(double stamp, const Pose2& base_in_map);

/// What is scored of an estimate, carried on to the truth sample by `last`, the increment of odometry it
/// stands at the end of: invalid where that is missing or over a second before. Throws RunError when a valid
/// estimate is not finite.
Epoch epoch_of(const PoseEstimate& estimate, const TruthSample& truth,
               const std::optional<OdometryIncrement>& last);

}  // namespace multipath_localization
