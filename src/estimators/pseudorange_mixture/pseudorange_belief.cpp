#include "estimators/pseudorange_mixture/pseudorange_belief.hpp"

#include <cmath>

#include "multipath_localization/core/covariance.hpp"
#include "simd/instruction_set.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kStoppingTime = 0.2;      // of a slip once the wheels stand [s]
constexpr double kOffsetWalk = 0.01;       // between the clocks of two constellations, alike [m/sqrt(s)]
constexpr double kZenithDelayWalk = 0.01;  // of the ionosphere: a metre in three hours [m/sqrt(s)]

/// P - r r' of n x n, column by column.
void subtract_square(double* P, const double* r, Eigen::Index n) {
  for (Eigen::Index j = 0; j < n; ++j, P += n) {
    const double factor = r[j];
    for (Eigen::Index i = 0; i < n; ++i) P[i] -= factor * r[i];
  }
}

}  // namespace

void ReceiverStateNoise::fields(ParameterVisitor& field) {
  field("position_walk", position_walk, {0.0, 10.0}, "m/sqrt(s)",
        "side slip and what else odometry does not see, while moving");
  field("up_walk", up_walk, {0.0, 10.0}, "m/sqrt(s)", "random walk of the height while moving");
  field("clock_walk", clock_walk, {0.0, 100.0}, "m/sqrt(s)", "random walk of the receiver clock");
  field("drift_walk", drift_walk, {0.0, 10.0}, "m/s/sqrt(s)", "random walk of the receiver clock's drift");
  field("offset_sigma", offset_sigma, {0.1, 1e4}, "m",
        "1 sigma of the unknown offset between the clocks of two constellations");
  field("bias_sigma", bias_sigma, {0.1, 100.0}, "m",
        "1 sigma of a satellite's own bias in line of sight: orbit, atmosphere, GLONASS frequency");
  field("bias_time", bias_time, {1.0, 1e5}, "s", "correlation time of that bias");
}

Belief PseudorangeBelief::planar() const {
  Belief belief;
  belief.mean = mean.head<kPlanarSize>();
  belief.covariance = covariance.topLeftCorner<kPlanarSize, kPlanarSize>();
  return belief;
}

void PseudorangeBelief::append(double variance) {
  const Eigen::Index n = mean.size();
  mean.conservativeResize(n + 1);
  covariance.conservativeResize(n + 1, n + 1);
  renew(static_cast<int>(n), 0.0, variance);
}

void PseudorangeBelief::remove(int slot) {
  const Eigen::Index last = mean.size() - 1;
  const int place = state_of(slot);
  mean(place) = mean(last);
  covariance.row(place).swap(covariance.row(last));
  covariance.col(place).swap(covariance.col(last));
  mean.conservativeResize(last);
  covariance.conservativeResize(last, last);
}

void PseudorangeBelief::propagate(const PreintegratedOdometry& odometry, const MotionLaw& law,
                                  const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise,
                                  const SatelliteSlots& slots) {
  const double dt = odometry.duration();
  const double moving = odometry.moving_time();
  Matrix& P = covariance;
  const Eigen::Matrix2d R = move_planar(mean, P, odometry);
  P.row(kClock) += dt * P.row(kDrift);
  P.col(kClock) += dt * P.col(kDrift);
  mean(kClock) += dt * mean(kDrift);

  const double slipping = law.always ? dt : moving;
  P(kYaw, kYaw) += square(law.yaw_noise) * slipping;
  slip(slipping, law);
  settle(dt - slipping);
  change_slots(dt, noise, slots);
  add_noise(odometry, R, odometry_noise, noise);
}

void PseudorangeBelief::slip(double dt, const MotionLaw& law) {
  const double tau = law.velocity_time;
  const double kept = std::exp(-dt / tau);
  const double way = tau * (1.0 - kept);  // of a metre a second, until it has decayed
  constexpr int v = kVelocityEast;
  Matrix& P = covariance;
  P.topRows<2>() += (way * P.middleRows<2>(v)).eval();
  P.leftCols<2>() += (way * P.middleCols<2>(v)).eval();
  P.middleRows<2>(v) *= kept;
  P.middleCols<2>(v) *= kept;
  mean.head<2>() += way * mean.segment<2>(v);
  mean.segment<2>(v) *= kept;

  const double variance = square(law.velocity_sigma);
  const double of_position = variance * square(tau) * (2.0 * dt / tau - 3.0 + 4.0 * kept - square(kept));
  const double of_both = variance * tau * square(1.0 - kept);
  const double of_velocity = variance * (1.0 - square(kept));
  for (int i = 0; i < 2; ++i) {
    P(kX + i, kX + i) += of_position;
    P(kX + i, v + i) += of_both;
    P(v + i, kX + i) += of_both;
    P(v + i, v + i) += of_velocity;
  }
}

void PseudorangeBelief::settle(double dt) {
  constexpr int v = kVelocityEast;
  const double kept = std::exp(-dt / kStoppingTime);
  covariance.middleRows<2>(v) *= kept;
  covariance.middleCols<2>(v) *= kept;
  mean.segment<2>(v) *= kept;
}

void PseudorangeBelief::change_slots(double dt, const ReceiverStateNoise& noise,
                                     const SatelliteSlots& slots) {
  Matrix& P = covariance;
  const double kept = std::exp(-dt / noise.bias_time);
  Vector factor = Vector::Ones(mean.size());
  for (int slot = 0; slot < slots.size(); ++slot) {
    if (slots.owner(slot).satellite) factor(state_of(slot)) = kept;
  }
  mean.array() *= factor.array();
  for (Eigen::Index i = 0; i < P.cols(); ++i) P.col(i).array() *= factor(i) * factor.array();
  for (int slot = 0; slot < slots.size(); ++slot) {
    const int i = state_of(slot);
    P(i, i) += slots.owner(slot).satellite ? square(noise.bias_sigma) * (1.0 - kept * kept)
                                           : square(kOffsetWalk) * dt;
  }
}

void PseudorangeBelief::add_noise(const PreintegratedOdometry& odometry, const Eigen::Matrix2d& R,
                                  const OdometryNoise& odometry_noise, const ReceiverStateNoise& noise) {
  const double dt = odometry.duration();
  const double moving = odometry.moving_time();
  Matrix& P = covariance;
  add_odometry_noise(P, odometry, R, odometry_noise);
  P(kX, kX) += square(noise.position_walk) * moving;
  P(kY, kY) += square(noise.position_walk) * moving;
  P(kUp, kUp) += square(noise.up_walk) * moving;
  P(kClock, kClock) += square(noise.clock_walk) * dt;
  P(kDrift, kDrift) += square(noise.drift_walk) * dt;
  P(kZenithDelay, kZenithDelay) += square(kZenithDelayWalk) * dt;
  // Rounding is to leave P symmetric. Only these rows and columns were changed apart.
  P.leftCols<kFixed>() = P.topRows<kFixed>().transpose().eval();
  P.topLeftCorner<kFixed, kFixed>() = symmetric<kFixed>(P.topLeftCorner<kFixed, kFixed>());
}

PseudorangeBelief::Vector PseudorangeBelief::covariance_with(const SparseRow& H) const {
  Vector PHt = H.value(0) * covariance.col(H.state(0));
  for (int i = 1; i < H.size(); ++i) PHt.noalias() += H.value(i) * covariance.col(H.state(i));
  return PHt;
}

void PseudorangeBelief::correct(const Vector& PHt, double S, double innovation) {
  mean += PHt * (innovation / S);
  mean(kYaw) = wrap_angle(mean(kYaw));
  // As a square, so that rounding leaves P symmetric.
  const Vector root = PHt / std::sqrt(S);
  static const InstructionSet set = best_instruction_set();
  run<subtract_square>(set, covariance.data(), root.data(), root.size());
}

void PseudorangeBelief::renew(int state, double value, double variance) {
  mean(state) = value;
  covariance.row(state).setZero();
  covariance.col(state).setZero();
  covariance(state, state) = variance;
}

}  // namespace multipath_localization
