#pragma once

namespace multipath_localization {

/// An echo beside the signal that a receiver tracks.
struct Echo {
  double amplitude = 0.0;  ///< over that of the tracked signal, below 1
  double delay = 0.0;      ///< against the tracked signal, negative when earlier [m]
  double phase = 0.0;      ///< of the carrier, against the tracked signal's [rad]
};

/// What an echo adds to the pseudorange of the C/A code [m], for a coherent early-minus-late correlator of a
/// spacing [chip]: the multipath error of van Dierendonck, Fenton and Ford, [2] of [SUZ].
double code_multipath(const Echo& echo, double spacing);

}  // namespace multipath_localization
