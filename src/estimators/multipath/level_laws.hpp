#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "estimators/multipath/error_laws.hpp"
#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization::multipath {

/// The laws of errors that a receiver has at each level it tells: one that declares the same at all of them
/// is off by centimetres at one and by metres at another.
class LevelLaws {
 public:
  /// The law with which a receiver goes on at the level `to`, after `held` has held at the level `from`. The
  /// first time it is that one, as of a receiver whose declared sigma follows its level, or else any.
  FixLaw change(FixLevel from, FixLevel to, const FixLaw& held, RandomStream& random);

 private:
  static constexpr std::size_t kLevels = static_cast<std::size_t>(FixLevel::kFixed) + 1;

  std::array<std::optional<FixLaw>, kLevels> laws_;
};

}  // namespace multipath_localization::multipath
