#pragma once

#include <cmath>
#include <initializer_list>

#include "multipath_localization/core/random.hpp"

namespace multipath_localization {

/// Drawn evenly from low..high.
struct Span {
  double low;
  double high;
};

/// Drawn evenly in its logarithm: every doubling is as likely as the next.
struct LogSpan {
  double low;
  double high;
};

inline double draw(RandomStream& random, Span span) {
  return span.low + (span.high - span.low) * random.uniform();
}

inline double draw(RandomStream& random, LogSpan span) {
  return span.low * std::pow(span.high / span.low, random.uniform());
}

/// Either sign, as likely as not.
inline double either_sign(RandomStream& random) { return random.uniform() < 0.5 ? -1.0 : 1.0; }

inline bool chance(RandomStream& random, double probability) { return random.uniform() < probability; }

/// One of the items, all as likely.
template <class Item>
Item one_of(RandomStream& random, std::initializer_list<Item> items) {
  return items.begin()[static_cast<std::size_t>(random.uniform() * static_cast<double>(items.size()))];
}

/// What random robots are drawn from: the only place of these numbers. Wider than what robots have, so that
/// nothing that is tuned on them is tuned on one kind of robot.
namespace random_ranges {

// The way
constexpr Span kDuration{240.0, 600.0};     ///< [s] long enough for heading, constants and a few shadows
constexpr LogSpan kSpeed{0.3, 25.0};        ///< [m/s] a lawn mower .. a car out of town
constexpr LogSpan kAcceleration{0.3, 3.0};  ///< [m/s^2] a tractor .. a hard stop of a car
constexpr LogSpan kLateralAcceleration{0.3, 3.0};  ///< [m/s^2] how fast corners are taken
constexpr LogSpan kTurnRadius{0.4, 4.0};           ///< [m] of the tightest turn, at walking pace
constexpr double kRadiusOfSpeed = 0.4;             ///< [s] times the speed, added to it: cars turn wider
constexpr LogSpan kStraight{4.0, 40.0};            ///< [s] at the speed: from one corner to the next
constexpr Span kStraightLimits{3.0, 800.0};        ///< [m] that it is cut to
constexpr double kOnSpot = 0.4;             ///< share of slow robots with driven wheels that turn on the spot
constexpr double kOnSpotSpeed = 3.0;        ///< [m/s] faster ones do not
constexpr LogSpan kOnSpotRate{0.2, 1.5};    ///< [rad/s] of such a turn
constexpr LogSpan kWander{1e-4, 3e-2};      ///< [rad] the driver's unsteadiness: curvature times turn radius
constexpr double kParks = 0.35;             ///< share of drives with a long stop
constexpr LogSpan kParking{60.0, 300.0};    ///< [s] of it: loading, charging, a level crossing
constexpr int kMostStops = 4;               ///< short stops, 0 .. this many
constexpr LogSpan kStop{3.0, 40.0};         ///< [s] traffic lights, gates
constexpr double kReverses = 0.25;          ///< share of robots that back up now and then
constexpr LogSpan kReversing{4.0, 25.0};    ///< [s] of it
constexpr double kReverseSpeed = 1.5;       ///< [m/s] at most
constexpr double kStartsDriving = 0.4;      ///< share of drives that begin at full speed
constexpr LogSpan kStartParked{1.0, 60.0};  ///< [s] the others stand first

// Odometry
constexpr Span kSpeedScaleSigma{0.0, 0.04};      ///< [1] tyre pressure and load: some %
constexpr LogSpan kScaleDriftSigma{1e-4, 0.01};  ///< [1] ground and load that change on the way
constexpr LogSpan kScaleDriftTime{10.0, 200.0};  ///< [s] correlation time of that
constexpr LogSpan kSpeedNoise{2e-3, 0.03};       ///< [sqrt(m)] white: standard deviation of the way after 1 m
constexpr LogSpan kGyroBiasSigma{1e-4, 0.02};    ///< [rad/s] a good gyro at rest .. a cheap one, warm
constexpr LogSpan kGyroBiasWalk{1e-6, 1e-4};     ///< [rad/s/sqrt(s)] its walk
constexpr LogSpan kYawNoise{3e-4, 1e-2};         ///< [rad/sqrt(s)] angle random walk; wheels: while they turn
constexpr Span kSkidTurnScale{0.05, 0.30};       ///< [1] turns of a skid steer read too high by
constexpr double kWheelTurnScaleSigma = 0.03;    ///< [1] track width that is not known better
constexpr LogSpan kCurvatureOffset{1e-4,
                                   3e-2};  ///< [1/m] unequal wheels .. steering 2 deg off at 1 m wheelbase
constexpr double kCurvatureOffsetRate =
    0.1;  ///< [rad/s] what that comes to at full speed, at most: a driver would see more
constexpr LogSpan kTick{1e-3, 20e-3};  ///< [m] of way per encoder tick: motor shaft .. a magnet a spoke
constexpr double kTicks = 0.5;         ///< share of wheel odometry that counts ticks
constexpr double kTickOfSeparation =
    0.02;  ///< [1] of the wheel separation at most where yaw comes from ticks
constexpr LogSpan kWheelSeparation{0.25, 1.8};  ///< [m] indoor robot .. car
constexpr double kDoppler = 0.1;               ///< share of robots that move by the receiver's velocity alone
constexpr LogSpan kDopplerSigma{0.03, 0.4};    ///< [m/s] of a component, correlated
constexpr LogSpan kDopplerTime{0.5, 15.0};     ///< [s] correlation time: multipath, the receiver's own filter
constexpr double kSlips = 0.3;                 ///< share of robots whose wheels slip now and then
constexpr LogSpan kSlipInterval{30.0, 300.0};  ///< [s] between slips
constexpr LogSpan kSlipDuration{0.3, 4.0};     ///< [s] of a slip
constexpr Span kSlipRatio{-0.5, 1.0};          ///< [1] wheel path beyond the robot's over the robot's
constexpr double kWheelFault = 0.12;  ///< share of drives with wheels locked, spinning or an encoder dead
constexpr LogSpan kWheelFaultDuration{2.0, 12.0};  ///< [s] of that

// A gyro beside the odometry; its bias is drawn as that of one within it
constexpr LogSpan kGyroNoise{1e-4, 3e-3};  ///< [rad/sqrt(s)] a good one .. a cheap one on a robot that shakes
constexpr double kGyroScaleSigma = 0.005;  ///< [1] by data sheets 0.1 to 1 %

// Velocity by Doppler; standard deviations are of each component
constexpr LogSpan kVelocitySigma{0.03, 0.1};    ///< [m/s] under open sky, white and correlated part together
constexpr LogSpan kVelocityTime{0.5, 5.0};      ///< [s] correlation time: the receiver's own filter
constexpr Span kVelocityLag{0.0, 0.3};          ///< [s] that it is late by
constexpr LogSpan kVelocityDeclared{0.3, 3.0};  ///< [1] declared over true sigma
constexpr Span kVelocityOutliers{0.05, 0.15};   ///< [1] share of the time by reflections
constexpr LogSpan kVelocityOutlier{0.3, 3.0};   ///< [m/s] how far it is off then

// The receiver under open sky; standard deviations are of each component
constexpr Span kShape{1.0, 2.0};  ///< [1] longer over shorter axis of the errors: satellites to one side
constexpr LogSpan kFixedSigma{0.005, 0.03};    ///< [m] RTK fixed, white
constexpr LogSpan kFloatSigma{0.1, 1.0};       ///< [m] RTK float, slow
constexpr LogSpan kFloatTime{20.0, 300.0};     ///< [s] its correlation time
constexpr LogSpan kFixedStretch{30.0, 900.0};  ///< [s] mean time a receiver stays fixed
constexpr LogSpan kFloatStretch{3.0, 60.0};    ///< [s] mean time it needs to fix again
constexpr LogSpan kGoodSigma{0.1, 0.5};        ///< [m] multi-band or SBAS, slow part and white part
constexpr LogSpan kGoodTime{20.0, 300.0};      ///< [s] correlation time of the slow part
constexpr Span kPlainOffset{1.0, 3.0};  ///< [m] single point: orbits and ionosphere, does not average out
constexpr LogSpan kPlainSlowSigma{0.2, 1.5};     ///< [m] what changes of it
constexpr LogSpan kPlainSlowTime{30.0, 600.0};   ///< [s] correlation time of that
constexpr LogSpan kPlainWhiteSigma{0.05, 1.0};   ///< [m]
constexpr LogSpan kSmoothSigma{0.2, 1.5};        ///< [m] of consumer receivers that filter themselves
constexpr Span kSmoothTime{1.0, 3.0};            ///< [s] time constant of that filter
constexpr LogSpan kSmoothWhiteSigma{0.01, 0.1};  ///< [m] what it leaves of white noise
constexpr LogSpan kDriftSigma{0.3, 3.0};         ///< [m] drifting receivers
constexpr LogSpan kDriftTime{10.0, 1000.0};      ///< [s] correlation time
constexpr LogSpan kDriftWhiteSigma{0.05, 0.5};   ///< [m]
constexpr LogSpan kWhiteSigma{0.1, 3.0};         ///< [m] receivers with white noise alone

// What it declares
constexpr LogSpan kOptimism{2.0, 20.0};        ///< [1] true over declared sigma
constexpr LogSpan kConstantSigma{0.01, 10.0};  ///< [m] a driver that always fills in the same
constexpr LogSpan kCentimetres{0.01, 0.05};    ///< [m] declared while metres off
constexpr LogSpan kMetres{2.0, 10.0};          ///< [m] declared while good
constexpr Span kDeclaredShape{1.0, 4.0};       ///< [1] longer over shorter axis of a full covariance matrix
constexpr double kFullCovariance = 0.4;        ///< share of receivers that give one
constexpr double kStatusConstant = 0.3;        ///< share of drivers that always give the same status

// What goes wrong with fixes
constexpr Span kWrongFixShare{
    0.0, 0.3};  ///< [1] of an RTK receiver's new fixes that are wrong; half of them make none
constexpr LogSpan kWrongFixOffset{0.3, 15.0};     ///< [m] at centimetre noise, declared fixed
constexpr LogSpan kWrongFixDuration{5.0, 120.0};  ///< [s] until it is found out
constexpr int kMostShadows = 3;                   ///< places in shadow, 0 .. this many
constexpr LogSpan kShadowBias{2.0, 30.0};         ///< [m] a house .. towers
constexpr LogSpan kShadowTime{1.0, 20.0};         ///< [s] half the way through one, at the speed
constexpr double kShadowOfWay =
    0.4;  ///< its radius over half the diagonal of the way, at most: some sky is open
constexpr LogSpan kShadowTurn{3e-3, 0.1};     ///< [rad/s] of a bias that turns: satellites and walls move
constexpr LogSpan kShadowJump{2.0, 20.0};     ///< [s] between jumps of one that jumps
constexpr LogSpan kShadowWalkIn{5.0, 60.0};   ///< [s] one that walks in takes to grow
constexpr LogSpan kShadowNoise{0.01, 0.3};    ///< [1] white noise over bias, added to the receiver's
constexpr double kShadowDeclared = 0.4;       ///< share of receivers that declare what a shadow does to them
constexpr double kStartsInShadow = 0.15;      ///< share of drives that begin in one
constexpr LogSpan kOutlierShare{1e-3, 0.05};  ///< [1] of lone fixes far off; of half the receivers
constexpr LogSpan kOutlier{3.0, 50.0};        ///< [m] how far
constexpr int kMostOutages = 3;               ///< 0 .. this many
constexpr LogSpan kOutage{5.0, 120.0};        ///< [s] a hall, a tunnel, a receiver that starts again
constexpr double kOffAfterOutage = 0.5;       ///< share of outages after which the first fixes are off
constexpr LogSpan kOffAfterOutageBias{1.0, 15.0};  ///< [m] by this
constexpr LogSpan kOffAfterOutageTime{3.0, 40.0};  ///< [s] for this long

// Headings of two antennas or of a compass
constexpr LogSpan kHeadingSigma{0.003, 0.06};   ///< [rad] a baseline of a metre .. a cheap compass
constexpr LogSpan kHeadingTime{2.0, 60.0};      ///< [s] in which its slow part forgets itself
constexpr Span kHeadingOffset{-0.03, 0.03};     ///< [rad] of a mounting by hand
constexpr LogSpan kHeadingDeclared{0.3, 3.0};   ///< declared over true sigma
constexpr LogSpan kHeadingOutliers{1e-3, 0.1};  ///< share of the time

}  // namespace random_ranges

}  // namespace multipath_localization
