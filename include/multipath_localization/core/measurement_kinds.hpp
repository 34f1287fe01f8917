#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

#include "multipath_localization/core/measurements.hpp"

namespace multipath_localization {

/// What reports call the kinds of Measurement, by index.
inline constexpr std::array<std::string_view, std::variant_size_v<Measurement>> kMeasurementNames = {
    "fix", "dual", "epoch", "velocity", "heading"};

/// Whether a kind tells where the robot is, rather than how it moves or points.
constexpr bool tells_position(std::size_t kind) { return kind != kVelocityKind && kind != kHeadingKind; }

}  // namespace multipath_localization
