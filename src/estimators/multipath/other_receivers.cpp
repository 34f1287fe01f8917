#include "estimators/multipath/other_receivers.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "estimators/multipath/hypothesis.hpp"
#include "estimators/multipath/log_normal.hpp"
#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr double kMostAgreement = 50.0;  // of which the exponential is finite

/// Where among the states of the others the slow error of one of them begins, and its bias.
Eigen::Index slow_of(std::size_t other) { return static_cast<Eigen::Index>(other) * kReceiverStates; }
Eigen::Index shadow_of(std::size_t other) { return slow_of(other) + kShadowX - kSlowX; }

/// State and covariance of a hypothesis and all its receivers together.
struct Joint {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;

  explicit Joint(const Hypothesis& h)
      : mean(kStateSize + h.others.mean.size()), covariance(mean.size(), mean.size()) {
    mean << h.mean, h.others.mean;
    covariance << h.covariance, h.others.cross, h.others.cross.transpose(), h.others.covariance;
  }

  void exchange(Eigen::Index one, Eigen::Index another) {
    for (Eigen::Index i = 0; i < kReceiverStates; ++i) {
      std::swap(mean(one + i), mean(another + i));
      covariance.row(one + i).swap(covariance.row(another + i));
      covariance.col(one + i).swap(covariance.col(another + i));
    }
  }

  /// Adds two components from `from` on, `times` them, to those from `to` on.
  void add(Eigen::Index to, Eigen::Index from, double times) {
    mean.segment<2>(to) += times * mean.segment<2>(from);
    covariance.middleRows<2>(to) += times * covariance.middleRows<2>(from);
    covariance.middleCols<2>(to) += times * covariance.middleCols<2>(from);
  }
  void clear(Eigen::Index two) {
    mean.segment<2>(two).setZero();
    covariance.middleRows<2>(two).setZero();
    covariance.middleCols<2>(two).setZero();
  }

  /// Puts back what there is of the first `others` receivers.
  void give_back(Hypothesis& h, std::size_t others) const {
    const Eigen::Index n = slow_of(others);
    h.mean = mean.head<kStateSize>();
    h.covariance = covariance.topLeftCorner<kStateSize, kStateSize>();
    h.others.mean = mean.segment(kStateSize, n);
    h.others.cross = covariance.block(0, kStateSize, kStateSize, n);
    h.others.covariance = covariance.block(kStateSize, kStateSize, n, n);
  }
};

/// Logarithms of the probability density of the errors of a receiver, as they are and by a position that is
/// off by the bias of the shadow of the attended one.
struct Likelihoods {
  double now = 0.0;
  double open = 0.0;
  double in_shadow = 0.0;

  Likelihoods(const Hypothesis& h, std::size_t other) {
    const ReceiverErrors& errors = h.others.errors[other];
    const Eigen::Index slow = slow_of(other);
    const Eigen::Index shadow = shadow_of(other);
    const Eigen::Matrix2d across =
        h.others.cross.block<2, 2>(kShadowX, slow) + h.others.cross.block<2, 2>(kShadowX, shadow);
    const Eigen::Vector2d bias = h.others.bias(other);
    // Without their correlation, which takes from the sum: shadows of one robot are more alike than in the
    // model.
    const Eigen::Matrix2d P =
        h.others.covariance.block<2, 2>(slow, slow) + h.others.covariance.block<2, 2>(shadow, shadow);
    const Eigen::Vector2d moved = bias - h.mean.segment<2>(kShadowX);
    const Eigen::Matrix2d moved_P =
        P + h.covariance.block<2, 2>(kShadowX, kShadowX) - across - across.transpose();
    const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d open_variance = square(errors.law.slow_sigma() * errors.level) * I;
    const Eigen::Matrix2d shadow_variance = open_variance + square(errors.shadow_law.size) * I;
    const double log_open = std::log1p(-kShadowAtStart);
    const double log_shadow = std::log(kShadowAtStart);
    now = errors.in_shadow ? log_shadow + log_normal(bias, P + shadow_variance)
                           : log_open + log_normal(bias, P + open_variance);
    open = log_open + log_normal(moved, moved_P + open_variance);
    in_shadow = log_shadow + log_normal(moved, moved_P + shadow_variance);
  }
};

}  // namespace

Eigen::Vector2d OtherReceivers::bias(std::size_t other) const {
  return mean.segment<2>(slow_of(other)) + mean.segment<2>(shadow_of(other));
}

Eigen::Matrix2d OtherReceivers::bias_covariance(std::size_t other) const {
  return covariance_of_sum(covariance, slow_of(other), shadow_of(other));
}

void OtherReceivers::correct(const Eigen::MatrixXd& H, const Eigen::MatrixXd& K, const Eigen::MatrixXd& S,
                             const Eigen::VectorXd& innovation) {
  if (errors.empty()) return;
  const Eigen::MatrixXd PH = cross.transpose() * H.transpose();
  const Eigen::MatrixXd gain = PH * S.inverse();
  mean += gain * innovation;
  cross -= K * PH.transpose();
  covariance -= gain * PH.transpose();
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
}

void attend(Hypothesis& h, std::size_t other) {
  Joint joint(h);
  joint.exchange(kSlowX, kStateSize + slow_of(other));
  joint.give_back(h, h.others.errors.size());
  ReceiverErrors& errors = h.others.errors[other];
  std::swap(static_cast<FixLaw&>(h.law), errors.law);
  std::swap(h.level_laws, errors.level_laws);
  std::swap(h.level, errors.level);
  std::swap(h.in_shadow, errors.in_shadow);
  std::swap(h.shadow_law, errors.shadow_law);
}

void add_receiver(Hypothesis& h, const ReceiverErrors& errors) {
  OtherReceivers& others = h.others;
  const Eigen::Index n = others.mean.size();
  const Eigen::Index m = n + kReceiverStates;
  others.errors.push_back(errors);
  others.mean.conservativeResizeLike(Eigen::VectorXd::Zero(m));
  others.cross.conservativeResizeLike(OtherReceivers::Cross::Zero(kStateSize, m));
  others.covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(m, m));
  others.covariance.diagonal().segment<2>(n).setConstant(square(errors.law.slow_sigma() * errors.level));
  if (!errors.in_shadow) return;
  others.covariance.diagonal().segment<2>(n + kShadowX - kSlowX).setConstant(square(errors.shadow_law.size));
}

void forget_receiver(Hypothesis& h, std::size_t other) {
  Joint joint(h);
  const std::size_t last = h.others.errors.size() - 1;
  joint.exchange(kStateSize + slow_of(other), kStateSize + slow_of(last));
  joint.give_back(h, last);
  h.others.errors[other] = h.others.errors[last];
  h.others.errors.pop_back();
}

void renew_receivers(Hypothesis& h, RandomStream& random) {
  const std::vector<ReceiverErrors> known = std::exchange(h.others, {}).errors;
  for (ReceiverErrors errors : known) {
    errors.in_shadow = random.uniform() < kShadowAtStart;
    add_receiver(h, errors);
  }
}

double likelier_if_moved(const Hypothesis& h) {
  double log_ratio = 0.0;
  for (std::size_t k = 0; k < h.others.errors.size(); ++k) {
    const Likelihoods likelihoods(h, k);
    log_ratio += std::max(likelihoods.open, likelihoods.in_shadow) - likelihoods.now;
  }
  return std::exp(std::min(log_ratio, kMostAgreement));
}

void count_from_fixes(Hypothesis& h) {
  if (h.others.errors.empty()) return;
  Joint joint(h);
  for (std::size_t k = 0; k < h.others.errors.size(); ++k) {
    ReceiverErrors& errors = h.others.errors[k];
    const Likelihoods likelihoods(h, k);
    const Eigen::Index slow = kStateSize + slow_of(k);
    const Eigen::Index shadow = kStateSize + shadow_of(k);
    joint.add(shadow, kShadowX, -1.0);
    errors.in_shadow = likelihoods.in_shadow > likelihoods.open;
    if (errors.in_shadow) continue;
    joint.add(slow, shadow, 1.0);
    joint.clear(shadow);
  }
  joint.give_back(h, h.others.errors.size());
}

}  // namespace multipath_localization::multipath
