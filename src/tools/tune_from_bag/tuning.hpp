#pragma once

#include <string>

#include "multipath_localization/evaluation/sensor_noise.hpp"

namespace multipath_localization {

/// Parameters of localization_node that fit the noise, as YAML with the evidence beside each; what the drive
/// does not tell stands there as a comment, without a value.
std::string tuning(const SensorNoise& noise, const std::string& source);

}  // namespace multipath_localization
