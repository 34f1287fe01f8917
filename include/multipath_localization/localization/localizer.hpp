#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/trust.hpp"
#include "multipath_localization/estimators/estimator.hpp"
#include "multipath_localization/localization/gyro_turn.hpp"
#include "multipath_localization/localization/last_accepted.hpp"
#include "multipath_localization/localization/receiver_record.hpp"
#include "multipath_localization/localization/standstill.hpp"
#include "multipath_localization/models/motion/odometry_history.hpp"

namespace multipath_localization {

struct LocalizerParameters {
  double history_length = 5.0;
  double future_tolerance = 0.5;
  double dead_reckoning_after = 3.0;
  double lost_sigma = 10.0;
  double frozen_distance = 2.0;
  ReceiverCovarianceParameters fix_covariance;

  void fields(ParameterVisitor& field);
  /// Those of them that may change at any time.
  void tunable(ParameterVisitor& field);
};

/// What became of one measurement.
struct MeasurementReport {
  double stamp = 0.0;
  Measurement measurement;
  Innovation innovation;
  std::optional<double> observed_sigma;  ///< how far fixes lie from the pose by now, an axis [m]
  std::optional<double> used_sigma;      ///< how far the estimator reckoned with, bias included [m]
};

/// Puts an estimator on a stream: measurements count at their own stamps, whatever the order of arrival.
///
/// A measurement ahead of the odometry waits until the odometry has passed it, and the increment is split at
/// its stamp. A late one is weighed now, with its lever arm carried back over the odometry history. A fix
/// that the estimator refuses for repeating the one before is `frozen` once the robot has driven
/// `frozen_distance` since, and `repeated` before that: a receiver may do so whose robot stands.
class Localizer {
 public:
  Localizer(std::unique_ptr<Estimator> estimator, const LocalizerParameters& parameters);

  /// Forgets the past and starts the estimator afresh.
  void start(const std::optional<PosePrior>& prior);

  /// Takes an increment (finite, duration > 0, stamps increasing; the caller checks) and whatever
  /// measurements it was waited for.
  void add(const OdometryIncrement& reported);

  /// Takes a yaw rate: turns are its from then on, see GyroTurn.
  void add(const YawRate& yaw_rate) { gyro_.add(yaw_rate); }

  /// Takes a measurement.
  void add(const Measurement& measurement);

  /// What became of the measurements since the last call, in order of their use.
  std::vector<MeasurementReport> take_reports();

  /// Shows its own parameters, or those of the estimator, to a visitor that may change them; what is known
  /// stays.
  void tune(ParameterVisitor& field);
  void tune_estimator(ParameterVisitor& field) { estimator_->tune(field); }

  [[nodiscard]] PoseEstimate estimate() const { return estimator_->estimate(); }
  [[nodiscard]] std::vector<Hypothesis> hypotheses() const { return estimator_->hypotheses(); }
  /// What the last fix of a receiver told of its being frozen, nothing where it is not.
  [[nodiscard]] std::optional<FrozenReceiver> frozen(std::size_t receiver = 0) const;
  /// What becomes of the yaw rates.
  [[nodiscard]] const GyroTurn& gyro() const { return gyro_; }
  /// Whether odometry turns the other way round than the fixes of a receiver: its pose counts as not
  /// confirmed then.
  [[nodiscard]] bool mirrored() const;
  [[nodiscard]] Trust state() const;
  /// One sentence that says why the state is what it is.
  [[nodiscard]] std::string state_reason() const;

 private:
  void apply(const Measurement& measurement);
  /// Hands a fix to the estimator with the covariance it is to have; what was observed goes into the report.
  Innovation weigh(GnssFix& fix, MeasurementReport& report);

  std::unique_ptr<Estimator> estimator_;
  LocalizerParameters parameters_;
  OdometryHistory history_;
  std::map<std::size_t, ReceiverRecord> receivers_;  ///< by GnssFix::receiver
  Standstill standstill_;
  GyroTurn gyro_;
  std::deque<Measurement> waiting_;  ///< ahead of the odometry, by stamp
  std::vector<MeasurementReport> reports_;
  std::optional<double> start_;  ///< of odometry [s]
  double now_ = 0.0;
  double driven_ = 0.0;   ///< way since the start [m]
  bool settled_ = false;  ///< heading and position have been known
  LastAccepted accepted_;
};

}  // namespace multipath_localization
