#pragma once

#include <multipath_localization/FromLL.h>
#include <multipath_localization/SetDatum.h>
#include <multipath_localization/ToLL.h>

#include <string>

#include "multipath_localization/core/geodesy.hpp"

/// What MapServices answers. All return why a request cannot be answered, empty when it was; `map` is null
/// where there is no datum yet.
namespace multipath_localization {

constexpr double kFurthestPoint = 1e7;  ///< of map's origin, in each of its axes, that has a place [m]

/// Map's origin that is asked for goes to `place`; its axes stay east, north, up.
std::string answer(const SetDatum::Request& request, Geodetic& place);

/// The place of a point of map.
std::string answer(const ToLL::Request& request, const LocalFrame* map, ToLL::Response& response);

/// The point of map where a place is; one without an altitude lies at the datum's.
std::string answer(const FromLL::Request& request, const LocalFrame* map, FromLL::Response& response);

}  // namespace multipath_localization
