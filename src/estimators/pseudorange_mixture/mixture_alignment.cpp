#include "estimators/pseudorange_mixture/mixture_alignment.hpp"

#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kSettledMass = 0.95;      // of the cluster, that aligns
constexpr double kSettledDistance = 20.0;  // over which it holds that: a wrong heading shows on it [m]
constexpr double kSettledYawSigma = 0.3;   // [rad]
constexpr double kUnsettle = 0.8;          // mass of the cluster that ends an alignment
constexpr double kAgreementTime = 4.0;     // single epochs do not make a doubt [s]

}  // namespace

void MixtureAlignment::restart(const std::optional<double>& yaw_variance) {
  settled_over_ = 0.0;
  agreement_ = 1.0;
  aligned_ = yaw_variance && *yaw_variance < square(kSettledYawSigma);
}

void MixtureAlignment::compare(double found, double expected, double duration) {
  agreement_ += (found / expected - agreement_) * (1.0 - std::exp(-duration / kAgreementTime));
}

void MixtureAlignment::update(double mass, double yaw_variance, double moved) {
  const bool settled = !in_doubt() && mass >= kSettledMass && yaw_variance < square(kSettledYawSigma);
  settled_over_ = settled ? settled_over_ + moved : 0.0;
  if (mass < kUnsettle || in_doubt()) aligned_ = false;
  if (settled && settled_over_ >= kSettledDistance) aligned_ = true;
}

}  // namespace multipath_localization
