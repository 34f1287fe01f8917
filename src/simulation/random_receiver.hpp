#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/random_way.hpp"

namespace multipath_localization {

/// What kind of receiver a random robot has.
enum class ReceiverKind { kRtk, kGood, kPlain, kSmooth, kDrifting, kWhite };

/// What it says of its errors.
enum class Declaration { kHonest, kOptimistic, kConstant, kCentimetres, kMetres };

/// How the bias of one shadow goes on while the robot is in it.
enum class ShadowLaw { kConstant, kTurning, kJumping, kWalkingIn };

std::string_view to_string(ReceiverKind kind);
std::string_view to_string(Declaration declaration);
std::string_view to_string(ShadowLaw law);

/// The errors of fixes at one level of an RTK receiver, or of another receiver at all times. Standard
/// deviations are of each component [m]; all parts but the white one are drawn anew when the level is
/// entered.
struct FixErrors {
  double constant = 0.0;  ///< length of an offset that stays [m]
  double slow_sigma = 0.0;
  double slow_time = 1.0;  ///< correlation time [s]
  double white_sigma = 0.0;

  /// Of all parts together [m].
  [[nodiscard]] double sigma() const;
};

/// A place in shadow.
struct RandomShadow {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< [m]
  double bias = 0.0;    ///< its length [m]
  ShadowLaw law = ShadowLaw::kConstant;
  double turn_rate = 0.0;  ///< turning [rad/s]
  double interval = 0.0;   ///< jumping: between jumps; walking in: until it is there [s]
  double noise = 0.0;      ///< white, over the bias
};

/// An interval without fixes, and for how long and how far the first ones after it are off.
struct RandomOutage {
  Interval when;
  double off_duration = 0.0;  ///< [s]
  double off_bias = 0.0;      ///< [m]
};

enum RtkLevel : std::size_t { kFixed, kFloat, kSingle };

/// The receiver of a random robot, as drawn.
struct RandomReceiver {
  ReceiverKind kind = ReceiverKind::kGood;
  int period_ms = 200;
  std::vector<FixErrors> levels;                                 ///< RTK: fixed, float, single; others: one
  std::vector<FixStatus> statuses;                               ///< claimed at each
  Eigen::Matrix2d shape = Eigen::Matrix2d::Identity();           ///< of errors: times independent ones
  Eigen::Matrix2d declared_shape = Eigen::Matrix2d::Identity();  ///< of the covariance that is declared
  Declaration declaration = Declaration::kHonest;
  double optimism = 1.0;         ///< optimistic: true over declared sigma
  double declared_sigma = 0.0;   ///< where it is always the same [m]
  bool declares_shadow = false;  ///< what a shadow does counts in what is honest, and RTK loses its fix there
  double fixed_stretch = 0.0;    ///< mean time fixed [s]
  double float_stretch = 0.0;    ///< mean time float or single [s]
  double wrong_fix_share = 0.0;  ///< of new fixes
  double outlier_share = 0.0;
  std::vector<RandomShadow> shadows;
  std::vector<RandomOutage> outages;
};

/// Draws a receiver; its shadows lie along the way that was driven.
RandomReceiver draw_receiver(RandomStream& random, const std::vector<MotionStep>& steps, double speed);

/// What is wrong with a fix.
enum class FixFault { kNone, kShadow, kWrongFix, kAfterOutage, kOutlier };

/// The truth about one fix, which no estimator but the oracle is told.
struct FixTruth {
  FixFault fault = FixFault::kNone;
  std::size_t level = 0;
  bool new_level = false;                          ///< its slow errors were drawn anew
  bool new_bias = false;                           ///< the bias is another one than that of the fix before
  double bias_sigma = 0.0;                         ///< of each component of the bias once it is there [m]
  double bias_part = 0.0;                          ///< how much of it is there by now, 0..1
  double bias_turn = 0.0;                          ///< since the fix before [rad]
  double extra_white_sigma = 0.0;                  ///< [m]
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();  ///< of this fix [m]
};

struct ReadFixes {
  std::vector<GnssFix> fixes;
  std::vector<FixTruth> truths;  ///< of each
};

/// The fixes of a receiver on a way, of an antenna that is there on the base [m]. Deterministic by its
/// arguments.
ReadFixes read_fixes(const RandomReceiver& receiver, const std::vector<MotionStep>& steps, std::uint64_t seed,
                     const Eigen::Vector2d& antenna_in_base = Eigen::Vector2d::Zero());

/// The place in shadow that holds a point, the first of several; nullptr: none.
const RandomShadow* shadow_at(const RandomReceiver& receiver, const Eigen::Vector2d& point);

}  // namespace multipath_localization
