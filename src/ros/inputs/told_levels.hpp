#pragma once

#include <cstddef>
#include <map>

#include "ros/messages/level_messages.hpp"

namespace multipath_localization {

/// Brings the levels that a receiver's driver tells beside its fixes to these. The two are of one instant and
/// of one clock, but may come in either order.
class ToldLevels {
 public:
  /// Keeps no more than so many: seconds of the fastest receiver.
  explicit ToldLevels(std::size_t most = 100) : most_(most) {}

  void add(const ToldLevel& told);

  /// Of a fix of that stamp [s]: the level of the same stamp, or else the last one of the seconds before it.
  [[nodiscard]] FixLevel at(double stamp) const;

 private:
  std::size_t most_;
  std::map<double, FixLevel> told_;  ///< by stamp [s]
};

}  // namespace multipath_localization
