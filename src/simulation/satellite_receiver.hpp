#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/raw_receiver.hpp"
#include "simulation/receiver.hpp"
#include "simulation/receiver_schedule.hpp"
#include "simulation/robot.hpp"

namespace multipath_localization {

/// A GNSS receiver that computes its fixes from the satellites it tracks and hands out both.
class SatelliteReceiver {
 public:
  SatelliteReceiver(const ReceiverParameters& parameters, const std::vector<OutageParameters>& outages,
                    RawReceiver raw, std::uint64_t seed);

  /// Watches one step that ended at `time` [s]. Returns what is delivered by now: of each instant all
  /// pseudoranges and, if they determine one, the fix by weighted least squares over all of them, with the
  /// covariance that follows from the declared standard deviations alone.
  std::vector<Measurement> step(const Robot& robot, double time);

  /// At the last instant measured: the error of its fix (the last one, where there was none), and whether
  /// the satellites in line of sight were not the majority of those received.
  [[nodiscard]] const Reception& reception() const { return reception_; }

 private:
  [[nodiscard]] AntennaState antenna(const Robot& robot) const;

  ReceiverParameters parameters_;
  ReceiverSchedule schedule_;
  RawReceiver raw_;
  Reception reception_;
  Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();  ///< as computed [m]
};

}  // namespace multipath_localization
