#pragma once

#include <Eigen/Core>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

/// The bias of the fix as [NIS] tracks it: eta = (x, v_x, y, v_y), an offset in map and its rate [m, m/s].
namespace gnss_bias {

using State = Eigen::Vector4d;
using Matrix = Eigen::Matrix4d;

/// A of Eq. (14) over `dt` [s].
Matrix transition(double dt);

/// Covariance that the rate's white acceleration of density `q` [m^2/s^3] adds over `dt`. Departs: [NIS]
/// prints none (q = 0), with which the gain dies and the filter fits one straight line through the whole
/// past.
Matrix process_noise(double q, double dt);

/// The 2 x 4 observation of Eq. (15). Departs: [NIS] prints its transpose in Eqs. (15), (18), (20);
/// [NISJ] prints it as it is here, but A transposed, which would add positions to rates.
Eigen::Matrix<double, 2, 4> observation();

/// (x, y) of eta.
Eigen::Vector2d offset(const State& eta);

}  // namespace gnss_bias

/// What the bias filter is fed with, as the parameter `bias_input` says.
enum class BiasInput { kRelative, kSmoothed, kAbsolute };

/// Decisions about Eqs. (14)-(21) that [NIS] leaves open.
struct GnssBiasParameters {
  BiasInput bias_input = BiasInput::kRelative;
  double bias_process_noise = 1.0;

  void fields(ParameterVisitor& field);
};

}  // namespace multipath_localization
