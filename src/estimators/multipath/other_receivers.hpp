#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "estimators/multipath/error_laws.hpp"
#include "estimators/multipath/level_laws.hpp"
#include "estimators/multipath/state.hpp"

namespace multipath_localization::multipath {

/// What a hypothesis holds of the errors of a receiver beside its slow error and its bias.
struct ReceiverErrors {
  FixLaw law;
  LevelLaws level_laws;
  double level = 0.0;  ///< declared sigma that the slow error refers to [m]
  bool in_shadow = false;
  ShadowLaw shadow_law;
};

/// The receivers that a hypothesis does not attend to just now. Each has a slow error and a bias of its own,
/// kReceiverStates states that are correlated with the state of the hypothesis and with each other.
struct OtherReceivers {
  using Cross = Eigen::Matrix<double, kStateSize, Eigen::Dynamic>;

  std::vector<ReceiverErrors> errors;
  Eigen::VectorXd mean;
  Cross cross = Cross(kStateSize, 0);  ///< covariance of the state of the hypothesis with theirs
  Eigen::MatrixXd covariance;

  /// What a fix of one of them is off by, its white noise apart [m], and covariance of that [m^2].
  [[nodiscard]] Eigen::Vector2d bias(std::size_t other) const;
  [[nodiscard]] Eigen::Matrix2d bias_covariance(std::size_t other) const;

  /// The Kalman correction of a hypothesis by `innovation` with covariance `S`, measured as `H` times its
  /// state and corrected by the gain `K`, goes on to what is correlated with it.
  void correct(const Eigen::MatrixXd& H, const Eigen::MatrixXd& K, const Eigen::MatrixXd& S,
               const Eigen::VectorXd& innovation);
};

struct Hypothesis;

/// Attends to another receiver: its errors become those of the state, and those that were there go where
/// these have been.
void attend(Hypothesis& hypothesis, std::size_t other);

/// Adds a receiver of which that is known and no fix has told yet; its bias has the size of its shadow, if it
/// is in one.
void add_receiver(Hypothesis& hypothesis, const ReceiverErrors& errors);

/// Forgets one; the last one takes its place.
void forget_receiver(Hypothesis& hypothesis, std::size_t other);

/// Forgets what they are off by, of a position that is lost; whether they are in shadows is drawn anew.
void renew_receivers(Hypothesis& hypothesis, RandomStream& random);

/// How many times likelier the errors of the others are if the fixes of this receiver are right and the
/// position is off by the bias of its shadow: receivers that are off by the same are right rather than in
/// shadows that are alike, equation (25).
double likelier_if_moved(const Hypothesis& hypothesis);

/// Counts the errors of the others from a position that is off by the bias of the shadow of this one. Those
/// that are likelier under open sky then have left their shadows.
void count_from_fixes(Hypothesis& hypothesis);

}  // namespace multipath_localization::multipath
