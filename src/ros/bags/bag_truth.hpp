#pragma once

#include <geometry_msgs/Pose.h>
#include <std_msgs/Header.h>

#include <map>
#include <string>
#include <vector>

#include "evaluation/drive.hpp"
#include "multipath_localization/core/estimate.hpp"

namespace multipath_localization {

/// Where the base of a bag was, and when its fixes were biased.
class BagTruth {
 public:
  /// Takes a pose, or says why not.
  Reason add(const std_msgs::Header& header, const geometry_msgs::Pose& message);
  /// From that stamp on [s].
  void add_shadow(double stamp, bool in_shadow) { shadows_[stamp] = in_shadow; }

  /// By stamp, with the shadow last said at each.
  [[nodiscard]] std::vector<TruthSample> samples() const;
  /// That the poses are in, without slash.
  [[nodiscard]] const std::string& frame() const { return frame_; }

 private:
  std::string frame_;
  std::map<double, Pose2> poses_;
  std::map<double, bool> shadows_;
  bool turns_ = false;  ///< there is a heading: one that is always zero was never filled in
};

}  // namespace multipath_localization
