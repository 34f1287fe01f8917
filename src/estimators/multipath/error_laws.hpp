#pragma once

#include "estimators/multipath/odometry_sum.hpp"
#include "multipath_localization/core/random.hpp"

namespace multipath_localization::multipath {

/// Probability of a shadow of a receiver of which nothing is known: a robot is often switched on beside its
/// shed.
constexpr double kShadowAtStart = 0.3;

/// How large the errors of a receiver's fixes under open sky are: one guess, carried by a hypothesis,
/// equations (5), (6). Natural logarithms, so that they wander by factors.
struct FixLaw {
  double log_white = 0.0;      ///< white error of a fix, in the sigma it declares
  double log_slow = 0.0;       ///< slow error of a fix that does not average out, likewise
  double log_slow_time = 0.0;  ///< its correlation time [s]

  [[nodiscard]] double white_variance() const;  ///< [declared variance]
  [[nodiscard]] double slow_sigma() const;      ///< [declared sigma]
  [[nodiscard]] double slow_time() const;       ///< [s]
  [[nodiscard]] double open_sigma() const;      ///< the larger of the two errors [declared sigma]
};

/// The same of odometry besides, likewise.
struct ErrorLaw : FixLaw {
  double log_way = 0.0;   ///< noise of the way, in that of the parameters
  double log_turn = 0.0;  ///< noise of the turn, likewise
  double log_walk = 0.0;  ///< walk of the odometry's constants, likewise
  double log_gyro = 0.0;  ///< noise of the gyro beside the odometry, in that of a cheap one
  bool blind = false;     ///< odometry that has told of no turn yet tells of none

  [[nodiscard]] NoiseFactors odometry_noise() const;
};

/// A law drawn from the priors.
FixLaw draw_fix_law(RandomStream& random);

/// A law drawn from the priors, but for the noise of the gyro.
ErrorLaw draw_error_law(RandomStream& random);

/// `log_gyro`, drawn from its prior.
double draw_gyro_noise(RandomStream& random);

/// Lets the law wander for `duration` [s] about its prior.
void wander_fixes(FixLaw& law, double duration, RandomStream& random);
/// The same of a robot that drives, that of its odometry.
void wander_odometry(ErrorLaw& law, double duration, RandomStream& random);

/// What the fixes of one shadow are off by, equation (7): a bias that is a Gauss-Markov process, and white
/// noise.
struct ShadowLaw {
  double size = 0.0;         ///< sigma of the bias [m]
  double time = 0.0;         ///< its correlation time [s]
  double noise = 0.0;        ///< sigma of the white noise [m]
  double first = 0.0;        ///< sigma of the first bias [m]
  double leave_rate = 0.0;   ///< how soon the shadow ends [1/s]
  double change_rate = 0.0;  ///< how soon another reflection takes over [1/s]
};

/// A law for the next shadow, of biases from what tells them from the errors of an open sky (`open_sigma`
/// [m]) up to `largest` [m].
ShadowLaw draw_shadow_law(double open_sigma, double largest, RandomStream& random);

/// Probability that a receiver that began anew `age` [s] ago began wrong and has not found out yet.
double still_wrong(double age);
/// Whether a receiver that begins anew within a shadow holds on to the error that it begins with.
bool held(RandomStream& random);
/// The bias moves no more, for minutes: of wrong ambiguities.
void hold(ShadowLaw& law, RandomStream& random);

/// A law where the fixes come back after a gap: nobody saw the bias begin, and it may be held.
ShadowLaw draw_reacquired_law(double open_sigma, double largest, RandomStream& random);

/// Draws log-uniformly from low..high, both above zero.
double log_uniform(double low, double high, RandomStream& random);

}  // namespace multipath_localization::multipath
