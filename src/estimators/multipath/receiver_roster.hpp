#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization::multipath {

/// Which receivers the hypotheses of a cloud know: the one that they attend to, and the others in the order
/// of OtherReceivers.
struct ReceiverRoster {
  struct Other {
    std::size_t receiver = 0;
    std::optional<double> level;
    double silence = 0.0;  ///< since its last fix [s]
    FixLevel told = FixLevel::kUntold;
  };

  std::optional<std::size_t> attended;  ///< none before the first fix
  std::optional<double> level;          ///< declared sigma that holds, of the one attended to [m]
  FixLevel told = FixLevel::kUntold;    ///< the last level that this one has told
  std::vector<Other> others;

  /// All of them, by number.
  [[nodiscard]] std::vector<std::size_t> known() const {
    std::vector<std::size_t> all;
    if (attended) all.push_back(*attended);
    for (const Other& other : others) all.push_back(other.receiver);
    std::sort(all.begin(), all.end());
    return all;
  }

  /// Where among the others one is, their number for none of them.
  [[nodiscard]] std::size_t place_of(std::size_t receiver) const {
    std::size_t k = 0;
    while (k < others.size() && others[k].receiver != receiver) ++k;
    return k;
  }
};

}  // namespace multipath_localization::multipath
