#include "models/fix/gnss_likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/covariance.hpp"
#include "simd/elementary.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

/// w / (2 pi sigma^2) exp(-d^2 / (2 sigma^2)), the kernel of Eqs. (27), (31), as the logarithm
/// `peak - precision d^2`.
struct Kernel {
  double peak;
  double precision;

  Kernel(double weight, double sigma)
      : peak(std::log(weight / (2.0 * kPi * square(sigma)))), precision(0.5 / square(sigma)) {}

  double operator()(double squared_distance) const { return peak - precision * squared_distance; }
};

/// (dx, dy) of Eqs. (28), (29): antenna expected at the pose - fix [m].
struct AntennaErrors {
  BlockValues x;
  BlockValues y;
};

void antenna_errors(PoseBlock poses, double fix_x, double fix_y, AntennaErrors* error) {
#pragma omp simd
  for (std::size_t i = 0; i < poses.size; ++i) {
    error->x[i] = poses.x[i] - fix_x;
    error->y[i] = poses.y[i] - fix_y;
  }
}

void add_lever_arm(PoseBlock poses, double arm_x, double arm_y, AntennaErrors* error) {
#pragma omp simd
  for (std::size_t i = 0; i < poses.size; ++i) {
    const auto [s, c] = elementary::sincos_pi(poses.yaw[i] * (1.0 / kPi));
    error->x[i] += c * arm_x - s * arm_y;
    error->y[i] += s * arm_x + c * arm_y;
  }
}

/// The position's term of Eq. (27), as printed: the sum of two.
void direct_cross(const AntennaErrors* error, Kernel kernel, double* along_x, double* along_y,
                  std::size_t size) {
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) {
    along_x[i] = kernel(square(error->x[i]));
    along_y[i] = kernel(square(error->y[i]));
  }
}

void direct_product(const AntennaErrors* error, Kernel kernel, double* direct, std::size_t size) {
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) direct[i] = kernel(square(error->x[i]) + square(error->y[i]));
}

/// The position's term of Eqs. (31), (32): the distance from the ring. Departs where the ring is off the fix.
void shadow_ring(const AntennaErrors* error, Kernel kernel, const ShadowRing* ring, double* term,
                 std::size_t size) {
  const double east = ring->offset.x();
  const double north = ring->offset.y();
  const double radius = ring->radius;
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) {
    term[i] = kernel(square(std::sqrt(square(error->x[i] + east) + square(error->y[i] + north)) - radius));
  }
}

/// The heading's term of Eqs. (27), (30), (31).
void heading_error(PoseBlock poses, Kernel kernel, double heading, double* term) {
#pragma omp simd
  for (std::size_t i = 0; i < poses.size; ++i) {
    term[i] = kernel(square(elementary::wrap(poses.yaw[i] - heading)));
  }
}

/// The terms of Eq. (33) of each particle, as logarithms.
struct Terms {
  std::array<BlockValues, 4> term;
  std::array<double, 4> shadow{};  ///< how much of the term belongs to Eq. (31)
  std::size_t count = 0;

  double* add(double share) {
    shadow[count] = share;
    return term[count++].data();
  }
};

/// The sum of `Count` terms, the largest taken out first.
template <std::size_t Count>
void add_sum(const Terms* terms, double* log_weight, double* factor, float* shadow_share, std::size_t size) {
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) {
    double largest = terms->term[0][i];
    for (std::size_t k = 1; k < Count; ++k) {
      largest = terms->term[k][i] > largest ? terms->term[k][i] : largest;
    }
    double sum = 0.0;
    double shadow = 0.0;
    for (std::size_t k = 0; k < Count; ++k) {
      const double part = elementary::exp(terms->term[k][i] - largest);
      sum += part;
      shadow += terms->shadow[k] * part;
    }
    log_weight[i] += largest;
    factor[i] = sum;
    shadow_share[i] = static_cast<float>(shadow) / static_cast<float>(sum);
  }
}

}  // namespace

void GnssLikelihoodParameters::fields(ParameterVisitor& field) {
  field("sigma_b", sigma_b, {1e-3, 1e3}, "m", "of a fix by direct signals, Eq. (27)");
  field("sigma_s", sigma_s, {1e-3, 1e3}, "m", "of a fix in shadow about its bias, Eqs. (18), (31)");
  field("sigma_p", sigma_p, {1e-3, kPi}, "rad", "of the heading from two positions, Eqs. (27), (31)");
  field("use_declared_covariance", use_declared_covariance,
        "raise sigma_b and sigma_s to what the receiver declares; false as printed");
  field("likelihood_kernel", likelihood_kernel, {"product", "cross"},
        "position term of Eq. (27): product = exp(-dx^2 ..) exp(-dy^2 ..); cross = their sum, as printed");
}

FixSigmas fix_sigmas(const GnssLikelihoodParameters& parameters, const GnssFix& fix) {
  const double declared = parameters.use_declared_covariance ? mean_sigma(fix.covariance) : 0.0;
  return {std::max(parameters.sigma_b, declared), std::max(parameters.sigma_s, declared)};
}

GnssLikelihood::GnssLikelihood(const GnssLikelihoodParameters& parameters, const GnssFix& fix,
                               double shadow_weight, const ShadowRing& ring,
                               const std::optional<double>& heading)
    : cross_(parameters.likelihood_kernel == LikelihoodKernel::kCross),
      ring_(ring),
      shadow_weight_(shadow_weight),
      sigma_(fix_sigmas(parameters, fix)),
      sigma_p_(parameters.sigma_p),
      fix_(fix.position),
      antenna_in_base_(fix.antenna_in_base),
      heading_(heading) {}

void GnssLikelihood::add_to(InstructionSet set, const PoseBlock& poses, double* log_weight, double* factor,
                            float* shadow_share) const {
  AntennaErrors error;
  run<antenna_errors>(set, poses, fix_.x(), fix_.y(), &error);
  if (!antenna_in_base_.isZero(0.0)) {
    run<add_lever_arm>(set, poses, antenna_in_base_.x(), antenna_in_base_.y(), &error);
  }
  const AntennaErrors* errors = &error;
  const double position = heading_ ? 2.0 / 3.0 : 1.0;
  Terms terms;
  if (shadow_weight_ < 1.0) {
    const Kernel direct((1.0 - shadow_weight_) * position, sigma_.direct);
    double* along_x = terms.add(0.0);
    if (cross_) run<direct_cross>(set, errors, direct, along_x, terms.add(0.0), poses.size);
    if (!cross_) run<direct_product>(set, errors, direct, along_x, poses.size);
  }
  if (shadow_weight_ > 0.0) {
    const Kernel shadow(shadow_weight_ * position, sigma_.shadow);
    run<shadow_ring>(set, errors, shadow, &ring_, terms.add(1.0), poses.size);
  }
  if (heading_) {
    run<heading_error>(set, poses, Kernel(1.0 / 3.0, sigma_p_), *heading_, terms.add(shadow_weight_));
  }
  const Terms* all = &terms;
  switch (terms.count) {
    case 1: return run<add_sum<1>>(set, all, log_weight, factor, shadow_share, poses.size);
    case 2: return run<add_sum<2>>(set, all, log_weight, factor, shadow_share, poses.size);
    case 3: return run<add_sum<3>>(set, all, log_weight, factor, shadow_share, poses.size);
    default: return run<add_sum<4>>(set, all, log_weight, factor, shadow_share, poses.size);
  }
}

}  // namespace multipath_localization
