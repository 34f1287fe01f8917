#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "simulation/delivery_queue.hpp"
#include "simulation/gauss_markov.hpp"
#include "simulation/sensor_faults.hpp"

namespace multipath_localization {

struct VelocityReceiverParameters {
  double rate = 0.0;
  double white_sigma = 0.03;
  double slow_sigma = 0.03;
  double slow_time = 2.0;
  double lag = 0.1;
  double latency = 0.0;
  double declared_sigma = 0.05;
  double outlier_share = 0.01;
  double outlier_share_shadow = 0.1;
  double outlier_sigma = 1.0;

  void fields(ParameterVisitor& field);
};

/// Velocities of a receiver by Doppler: with white and correlated errors, of a moment before their stamp, and
/// reflected now and then.
class VelocityReceiver {
 public:
  VelocityReceiver(const VelocityReceiverParameters& parameters, const std::vector<SensorFault>& faults,
                   std::uint64_t seed);

  /// Watches one step of `duration` that ended at `time` [s] with the antenna at that velocity in map [m/s].
  /// Returns the velocities delivered by now, spoilt by the faults.
  std::vector<GnssVelocity> step(const Eigen::Vector2d& velocity, bool in_shadow, double time,
                                 double duration);

 private:
  VelocityReceiverParameters parameters_;
  SensorFaults faults_;
  RandomStream random_;
  GaussMarkov2 slow_;
  DeliveryQueue<Eigen::Vector2d> lagging_;  ///< true velocities, by when they are told
  Eigen::Vector2d told_ = Eigen::Vector2d::Zero();
  std::int64_t emitted_ = 0;
  DeliveryQueue<GnssVelocity> under_way_;
};

}  // namespace multipath_localization
