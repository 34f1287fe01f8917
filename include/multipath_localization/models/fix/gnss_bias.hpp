#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// How the bias moves between two fixes, as the parameter `bias_motion` says.
enum class BiasMotion { kRate, kWalk };

/// The bias of the fix as [NIS] tracks it: eta = (x, v_x, y, v_y), an offset in map and its rate [m, m/s].
namespace gnss_bias {

using State = Eigen::Vector4d;
using Matrix = Eigen::Matrix4d;

/// A of Eq. (14) over `dt` [s]. Departs, if it walks: the offset stays where it is and has no rate. [NIS]
/// lets the bias run on at the rate it grew with on the way into the shadow.
Matrix transition(BiasMotion motion, double dt);

/// Covariance that comes in over `dt`, of the rate's white acceleration of density `q` [m^2/s^3], or of the
/// offset's walk of density `q` [m^2/s]. Departs: [NIS] prints none (q = 0), with which the gain dies and the
/// filter fits one straight line through the whole past.
Matrix process_noise(BiasMotion motion, double q, double dt);

/// The 2 x 4 observation of Eq. (15). Departs: [NIS] prints its transpose in Eqs. (15), (18), (20);
/// [NISJ] prints it as it is here, but A transposed, which would add positions to rates.
Eigen::Matrix<double, 2, 4> observation();

/// (x, y) of eta.
Eigen::Vector2d offset(const State& eta);

}  // namespace gnss_bias

/// What the bias filter is fed with, as the parameter `bias_input` says.
enum class BiasInput { kRelative, kSmoothed, kAbsolute };

/// Where the probability of open sky in Eq. (33) comes from, as the parameter `sky` says.
enum class Sky { kFixed, kScatter };

/// Decisions about Eqs. (10), (14)-(21) that [NIS] leaves open.
struct GnssBiasParameters {
  BiasInput bias_input = BiasInput::kRelative;
  BiasMotion bias_motion = BiasMotion::kRate;
  double bias_process_noise = 1.0;
  Sky sky = Sky::kFixed;

  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
