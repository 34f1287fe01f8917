#pragma once

#include "multipath_localization/core/random.hpp"

namespace multipath_localization::multipath {

/// What the headings that are told are off by: one guess, carried by a hypothesis, equation (23).
struct HeadingLaw {
  bool drawn = false;     ///< whether there has been a heading since the hypothesis began
  bool believed = false;  ///< otherwise they say nothing: of another frame, of another sign
  bool outlier = false;   ///< the last one was one
  double noise = 1.0;     ///< error [declared sigma]
  double offset = 0.0;    ///< of the mounting, constant [rad]
};

/// Draws all of a law but whether it is believed; the mounting is off by `offset` [rad], about.
void draw_heading_errors(HeadingLaw& law, double offset, RandomStream& random);

/// Lets noise and belief change within `duration` [s], and the offset by so little that a learnt one goes on.
void wander(HeadingLaw& law, double duration, RandomStream& random);

}  // namespace multipath_localization::multipath
