#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "simulation/simulator.hpp"

namespace multipath_localization {

/// Shadow zones (translucent ground) and buildings (grey prisms) of a world. A half-plane is drawn as a
/// square of 200 m.
visualization_msgs::MarkerArray world_markers(const SimulatorParameters& world,
                                              const std_msgs::Header& header);

}  // namespace multipath_localization
