#include "multipath_localization/models/fix/gnss_bias.hpp"

namespace multipath_localization {

namespace gnss_bias {

Matrix transition(BiasMotion motion, double dt) {
  if (motion == BiasMotion::kWalk) return Eigen::Vector4d(1.0, 0.0, 1.0, 0.0).asDiagonal();
  Matrix A = Matrix::Identity();
  A(0, 1) = A(2, 3) = dt;
  return A;
}

Matrix process_noise(BiasMotion motion, double q, double dt) {
  if (motion == BiasMotion::kWalk) return Eigen::Vector4d(q * dt, 0.0, q * dt, 0.0).asDiagonal();
  Matrix Q = Matrix::Zero();
  for (const int i : {0, 2}) {
    Q(i, i) = q * dt * dt * dt / 3.0;
    Q(i, i + 1) = Q(i + 1, i) = q * dt * dt / 2.0;
    Q(i + 1, i + 1) = q * dt;
  }
  return Q;
}

Eigen::Matrix<double, 2, 4> observation() {
  Eigen::Matrix<double, 2, 4> H = Eigen::Matrix<double, 2, 4>::Zero();
  H(0, 0) = H(1, 2) = 1.0;
  return H;
}

Eigen::Vector2d offset(const State& eta) { return {eta(0), eta(2)}; }

}  // namespace gnss_bias

void GnssBiasParameters::fields(ParameterVisitor& field) {
  field("bias_input", bias_input, {"relative", "smoothed", "absolute"},
        "what the bias Kalman filter smooths: relative = fix - predicted position; smoothed = the fix, its "
        "distance from the predicted position being the radius; absolute = the fix, its distance from the "
        "map's origin being the radius, as Eq. (21) prints");
  field("bias_motion", bias_motion, {"rate", "walk"},
        "how the bias moves between fixes, Eq. (14): rate = on at its rate, as printed; walk = by its noise "
        "alone");
  field("bias_process_noise", bias_process_noise, {0.0, 1e4}, "m^2/s^3",
        "Q of Eq. (17): white acceleration of the bias, or, in m^2/s, its walk; 0 as printed");
  field(
      "sky", sky, {"fixed", "scatter"},
      "share of direct signals in Eq. (33): fixed = 1 - shadow_weight, as printed; scatter = the probability "
      "that the last fixes scatter about the bias filter by sigma_b and not by sigma_s, Eq. (11); then the "
      "bias is none under open sky, Eq. (10), and ring_fraction, Eq. (22), is multiplied by it");
}

}  // namespace multipath_localization
