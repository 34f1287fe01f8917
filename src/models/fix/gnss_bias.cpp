#include "multipath_localization/models/fix/gnss_bias.hpp"

namespace multipath_localization {

namespace gnss_bias {

Matrix transition(double dt) {
  Matrix A = Matrix::Identity();
  A(0, 1) = A(2, 3) = dt;
  return A;
}

Matrix process_noise(double q, double dt) {
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
  field("bias_process_noise", bias_process_noise, {0.0, 1e4}, "m^2/s^3",
        "white acceleration of the bias, Q of Eq. (17); 0 as printed");
}

}  // namespace multipath_localization
