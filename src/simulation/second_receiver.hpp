#pragma once

#include <cstdint>
#include <vector>

#include "simulation/receiver.hpp"
#include "simulation/zone.hpp"

namespace multipath_localization {

struct SecondReceiverParameters {
  double rate = 0.0;
  double antenna_x = 0.0;
  double antenna_y = -0.8;
  double sigma_open = 0.3;
  double sigma_shadow = 1.0;
  double declared_sigma = 0.3;
  std::vector<ZoneParameters> zones;

  void fields(ParameterVisitor& field);
};

/// A second GNSS receiver of the robot, with errors and shadows of its own. Its fixes are those of number 1.
class SecondReceiver {
 public:
  /// Throws ParameterError on a polygon of fewer than three corners.
  SecondReceiver(const SecondReceiverParameters& parameters, const std::vector<OutageParameters>& outages,
                 std::uint64_t seed);

  /// Watches one step of `duration` that ended at `time` [s] with the base at `base_in_map`. Returns the
  /// fixes made by now.
  std::vector<GnssFix> step(const Pose2& base_in_map, double time, double duration);

 private:
  Receiver receiver_;
  Zones zones_;
};

}  // namespace multipath_localization
