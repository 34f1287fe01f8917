#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "ros/messages/conversions.hpp"

namespace multipath_localization {

/// Brings the fixes of two antennas together by their stamps, as soon as both are there. Unlike
/// message_filters' approximate time it waits for no later message and names every fix it gives up.
class FixPairing {
 public:
  enum class Side { kLeft, kRight };

  /// What comes of one more fix.
  struct Outcome {
    std::optional<FixPair> pair;
    std::vector<sensor_msgs::NavSatFix> unpaired;  ///< given up
  };

  /// Fixes whose stamps differ by more than `tolerance` [s] are no pair.
  explicit FixPairing(double tolerance) : tolerance_(tolerance) {}

  /// Pairs the fix with the nearest one of the other side, or keeps it. What waits is given up when a fix a
  /// second away from it comes in, or when a hundred wait on its side.
  Outcome add(Side side, const sensor_msgs::NavSatFix& fix);

  /// Gives up all that waits.
  std::vector<sensor_msgs::NavSatFix> clear();

 private:
  using Waiting = std::deque<sensor_msgs::NavSatFix>;
  /// The nearest within the tolerance, or the end.
  Waiting::iterator partner(Waiting& others, double stamp) const;

  double tolerance_;
  std::array<Waiting, 2> waiting_;  ///< by side, in order of arrival
};

}  // namespace multipath_localization
