#pragma once

#include <map>
#include <string>
#include <vector>

#include "multipath_localization/core/estimate.hpp"

namespace multipath_localization {

/// Counts what of a bag was left out, by topic and reason.
class BagRefusals {
 public:
  /// Whether that reason lets a message of that topic pass; counts it otherwise.
  bool passes(const std::string& topic, Reason reason);

  /// "TOPIC: REASON, N times", each.
  [[nodiscard]] std::vector<std::string> lines() const;
  /// The same in one line in brackets; empty where nothing was left out.
  [[nodiscard]] std::string in_brackets() const;

 private:
  std::map<std::string, int> times_;  ///< by topic and reason
};

}  // namespace multipath_localization
