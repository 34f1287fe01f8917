#pragma once

#include <string_view>

namespace multipath_localization {

/// How far the pose can be trusted, in the order (and numbers) of LocalizationState.msg, whose name C++ has
/// taken.
enum class Trust {
  kNotReady,       ///< no odometry or no fix yet
  kAligning,       ///< heading or position not yet confirmed: drive on
  kGood,           ///< aligned, fixes agree
  kMultipath,      ///< aligned, fixes are biased and the bias is tracked
  kDeadReckoning,  ///< aligned, no usable fix for a while
  kLost,           ///< the pose must not be driven by
};

/// "NOT_READY", "ALIGNING", ...
std::string_view to_string(Trust state);

}  // namespace multipath_localization
