#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "estimators/multipath/aids.hpp"
#include "estimators/multipath/explanations.hpp"
#include "estimators/multipath/heading_block.hpp"
#include "estimators/multipath/hypothesis.hpp"
#include "estimators/multipath/receiver_roster.hpp"
#include "estimators/multipath/velocity_block.hpp"
#include "multipath_localization/core/estimate.hpp"

namespace multipath_localization::multipath {

/// What all hypotheses together hold of the fixes of one receiver.
struct FixErrors {
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();             ///< [m]
  Eigen::Matrix2d bias_covariance = Eigen::Matrix2d::Zero();  ///< [m^2]
  double white_variance = 0.0;                                ///< an axis [m^2]
  double slow_variance = 0.0;                                 ///< of the slow error, an axis [m^2]
  double shadow = 0.0;                                        ///< probability of a shadow
};

/// The hypotheses as one Gaussian and some probabilities, equations (15), (16); of the fixes it tells of the
/// receiver that is attended to.
struct Mixture {
  State mean = State::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of x, y, yaw: within and between hypotheses
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();            ///< of the fixes [m]
  Eigen::Matrix2d bias_covariance = Eigen::Matrix2d::Zero();
  double white_variance = 0.0;  ///< of a fix, an axis [m^2]
  double slow_variance = 0.0;   ///< of the slow error of a fix, an axis [m^2]
  NoiseFactors odometry_noise;
  double shadow = 0.0;             ///< probability of a shadow
  double wheel_fault = 0.0;        ///< probability of wheels that fail
  std::optional<double> velocity;  ///< probability that the last velocities of a receiver are what they seem
  std::optional<double> heading;   ///< likewise of the last headings
  double agreement = 1.0;          ///< weight of those within kHeadingReach of the mean heading
  double effective_size = 1.0;
  std::vector<FixErrors> others;  ///< of the other receivers

  /// Probability of a shadow of the receiver that is held to be least in one.
  [[nodiscard]] double least_shadow() const;
  [[nodiscard]] OdometryErrors odometry_errors() const;  ///< on average
};

/// How much of a fix `duration` [s] after the last one counts as evidence.
double evidence_share(const Mixture& mixture, double duration);

class HypothesisCloud;
/// Puts what a cloud knows of the fixes of each receiver into an estimate.
void tell_receivers(const HypothesisCloud& cloud, PoseEstimate& estimate);

/// The receiver that tells most of the position: of those that are not silent, the one whose fixes are least
/// off; 0 before the first fix.
std::size_t followed(const HypothesisCloud& cloud);

/// Of the k-th of the receivers that the hypotheses do not attend to.
FixErrors errors_of_other(const std::vector<Hypothesis>& hypotheses, std::size_t k);

/// How wide the odometry's constants may be off at the start.
struct CloudSettings {
  int particles = 800;
  OdometryNoise odometry;
  double turn_scale_sigma = 0.04;
};

/// Weighted hypotheses of pose, errors of odometry and laws of errors.
class HypothesisCloud {
 public:
  HypothesisCloud(const CloudSettings& settings, std::uint64_t seed) : settings_(settings), seed_(seed) {}

  /// Forgets all hypotheses.
  void clear();
  [[nodiscard]] bool empty() const { return hypotheses_.empty(); }
  /// Holds for the next start or, the number of particles, from the next resampling on.
  void set(const CloudSettings& settings) { settings_ = settings; }

  /// Spreads hypotheses all round the circle about a fix, as that one declares itself.
  void start(const GnssFix& fix);
  /// The same with no more hypotheses than the settings want, every other one with the laws of errors and the
  /// constants of the odometry that `learnt` has, by a receiver whose fixes are off by at most `largest_bias`
  /// [m].
  void start(const GnssFix& fix, const HypothesisCloud& learnt, double largest_bias);
  /// Spreads them about a pose; what a fix declares is learnt from the first one.
  void start(const PosePrior& prior);

  void propagate(const OdometrySum& odometry);

  /// Lets wheels fail while there is no fix to tell: a fault begins with that probability, or goes on, for
  /// `duration` [s] at the usual `speed` [m/s]. Where a gyro tells the turns no fault of wheels feigns any.
  void let_wheels_fail(double probability, double speed, double duration, bool standing, bool turns_by_gyro);

  /// Weighs a fix; `sighting.level` is set here, equation (13), (14). Returns the logarithm of its
  /// probability density [1/m^2].
  double weigh(Sighting sighting);
  /// Weighs velocities among the hypotheses that believe them, equation (21).
  void weigh(const VelocitySighting& sighting);
  /// Weighs headings among the hypotheses that believe them, equation (24).
  void weigh(const HeadingSighting& sighting);
  /// Lets all hypotheses believe headings from now on, and take them to be off by about `offset` [rad].
  void mount_heading(double offset);

  /// Takes in the hypotheses of another cloud as a `share` of the whole.
  void take_in(const HypothesisCloud& other, double share);

  [[nodiscard]] const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }
  [[nodiscard]] const Mixture& mixture() const { return mixture_; }
  [[nodiscard]] const ReceiverRoster& receivers() const { return receivers_; }
  /// Of one of these receivers; none of another.
  [[nodiscard]] FixErrors errors_of(std::size_t receiver) const;

 private:
  void spread(std::size_t count, double largest_bias);
  void attend(const Sighting& sighting);
  void refresh();
  void resample(std::optional<std::size_t> wanted = {});

  CloudSettings settings_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  std::uint32_t aid_step_ = 0;
  Aids aids_;
  std::vector<Hypothesis> hypotheses_;
  Mixture mixture_;
  ReceiverRoster receivers_;
};

}  // namespace multipath_localization::multipath
