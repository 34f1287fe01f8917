#pragma once

#include <optional>
#include <string>

#include "multipath_localization/GnssEpoch.h"
#include "multipath_localization/core/estimate.hpp"
#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"

/// Raw measurements as messages and back: ECEF there, map here.
namespace multipath_localization {

/// How epochs of pseudoranges are read.
struct EpochParameters {
  double default_sigma = 5.0;
  double largest_sigma = 1000.0;

  void fields(ParameterVisitor& field);
};

/// An epoch, or the reason why it is refused.
struct CheckedEpoch {
  Reason reason = Reason::kAccepted;
  PseudorangeEpoch epoch;   ///< counts only when accepted
  std::size_t dropped = 0;  ///< satellites left out of it
};

/// Reads an epoch of an antenna at `antenna_in_base` [m].
///
/// | in the message                                     | what happens                              |
/// |----------------------------------------------------|-------------------------------------------|
/// | stamp zero                                         | refused: zero stamp                       |
/// | more than 256 satellites                           | refused: too many satellites              |
/// | no satellite left by the lines below               | refused: too few satellites               |
///
/// | of one satellite                                   | what happens                              |
/// |----------------------------------------------------|-------------------------------------------|
/// | constellation not one of Pseudorange's             | dropped                                   |
/// | named before in the same epoch                     | dropped                                   |
/// | pseudorange not in 1e6..1e8 m, NaN, infinite       | dropped; a clock 60 ms fast or 190 ms slow passes |
/// | position not 1e7..1e8 m from the Earth's centre    | dropped, NaN and infinite too             |
/// | range rate or velocity infinite or over 1e5 m/s    | dropped                                   |
/// | range rate or part of the velocity NaN             | not measured, not known                   |
/// | C/N0 infinite, below 0 or above 100 dB-Hz          | dropped; NaN: not known                   |
/// | elevation infinite or beyond +-pi/2                | dropped                                   |
/// | elevation NaN                                      | as seen from the datum                    |
/// | sigma infinite or above `largest_sigma`            | dropped                                   |
/// | sigma zero, negative or NaN                        | `default_sigma`                           |
///
/// Stamps in the future or too old are the Localizer's to refuse.
CheckedEpoch to_epoch(const GnssEpoch& message, const LocalFrame& map, const EpochParameters& parameters,
                      const Eigen::Vector2d& antenna_in_base = Eigen::Vector2d::Zero());

/// The part of `to_epoch` that needs no datum: `accepted`, or the reason why not.
Reason check(const GnssEpoch& message, const EpochParameters& parameters);

/// Where the antenna was by plain least squares over the satellites that `to_epoch` keeps; nothing where they
/// do not tell or lead over 100 km up or down.
std::optional<Geodetic> solve_geodetic(const GnssEpoch& message, const EpochParameters& parameters);

/// The way back; `to_epoch` gives the same epoch again.
GnssEpoch to_message(const PseudorangeEpoch& epoch, const LocalFrame& map, const std_msgs::Header& header);

}  // namespace multipath_localization
