#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What reports call the kinds of Measurement, by index.
inline constexpr std::array<std::string_view, std::variant_size_v<Measurement>> kMeasurementNames = {
    "fix", "dual", "epoch", "velocity", "heading"};

}  // namespace multipath_localization
