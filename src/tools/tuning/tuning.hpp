#pragma once

#include <string>

#include "evaluation/drive.hpp"
#include "tools/tuning/noise_fit.hpp"

namespace multipath_localization {

/// What a drive says of its robot, and which fixes it says that by.
struct Tuning {
  NoiseFit fit;
  bool alike = true;      ///< fixes and odometry go the same way, but for scale: else the fit means nothing
  bool open_sky = false;  ///< by the fixes under open sky; false: by all, as there are too few of these
  std::size_t fixes = 0;  ///< of the drive
  std::size_t parts = 1;  ///< between silences of odometry, of which the longest counts
};

Tuning tune(const Drive& whole);

/// Parameters of localization_node as YAML to load after config/robot.yaml, with how sure each is. What the
/// drive does not tell stays as it is by default, unless the drive rules that out. Comments alone where the
/// fit means nothing.
std::string to_yaml(const Tuning& tuning);

}  // namespace multipath_localization
