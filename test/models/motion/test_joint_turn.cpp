#include <gtest/gtest.h>

#include <cmath>

#include "models/motion/joint_turn.hpp"
#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 0.05;

/// Sum of the turns of a wheel at constant rate whose position a driver tells by `told`.
template <class Told>
double turned(double rate, int steps, const Told& told) {
  JointTurn joint;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const auto turn = joint.take(told(rate * kStep * i), kStep);
    EXPECT_EQ(turn.has_value(), i > 0);
    sum += turn.value_or(0.0);
  }
  return sum;
}

TEST(JointTurn, GoesByPositionsWhereTheyGoOn) {
  for (const double rate : {8.0, -8.0}) {
    EXPECT_NEAR(turned(rate, 200,
                       [](double angle) {
                         return JointReading{angle, kNan};
                       }),
                80.0 * rate / 8.0, 1e-9);
  }
}

TEST(JointTurn, GoesOnWherePositionsBeginAnewWithEachTurn) {
  for (const double rate : {8.0, -8.0}) {
    const double whole = 10.0 * rate;
    EXPECT_NEAR(turned(rate, 200,
                       [](double angle) {
                         return JointReading{wrap_angle(angle), kNan};
                       }),
                whole, 1e-9);
    EXPECT_NEAR(turned(rate, 200,
                       [](double angle) {
                         return JointReading{angle - 2.0 * kPi * std::floor(angle / (2.0 * kPi)), kNan};
                       }),
                whole, 1e-9);
  }
}

TEST(JointTurn, GoesByTheVelocityWherePositionsAreNotTold) {
  EXPECT_NEAR(turned(8.0, 200, [](double) { return JointReading{kNan, 8.0}; }), 80.0, 1e-9);
}

TEST(JointTurn, BridgesLostReadingsByPositions) {
  JointTurn joint;
  joint.take({100.0, kNan}, 0.0);
  joint.take({100.4, kNan}, kStep);
  EXPECT_NEAR(*joint.take({116.4, kNan}, 40 * kStep), 16.0, 1e-9);
}

TEST(JointTurn, BridgesLostTurnsByTheVelocityOrTheRateBefore) {
  for (const double velocity : {8.0, kNan}) {
    JointTurn joint;
    for (int i = 0; i < 20; ++i) joint.take({wrap_angle(8.0 * kStep * i), velocity}, kStep);
    const double gap = 2.0;
    const double turn = *joint.take({wrap_angle(8.0 * (kStep * 19 + gap)), velocity}, gap);
    EXPECT_NEAR(turn, 8.0 * gap, 1e-9) << velocity;
  }
}

TEST(JointTurn, OfALeapBeyondOneTurnIsTheLeap) {
  JointTurn joint;
  joint.take({500.0, kNan}, 0.0);
  joint.take({500.4, kNan}, kStep);
  EXPECT_NEAR(*joint.take({0.0, kNan}, kStep), -500.4, 1e-9) << "for the limit of speed to refuse";
}

TEST(JointTurn, IsUnknownFromAVelocityToAPosition) {
  JointTurn joint;
  joint.take({kNan, 8.0}, 0.0);
  EXPECT_FALSE(joint.take({3.0, kNan}, kStep));
  EXPECT_NEAR(*joint.take({3.4, kNan}, kStep), 0.4, 1e-12);
}

TEST(JointReading, IsToldByEitherNumber) {
  EXPECT_FALSE(JointReading().told());
  EXPECT_TRUE((JointReading{1.0, kNan}.told()));
  EXPECT_TRUE((JointReading{kNan, 1.0}.told()));
  EXPECT_FALSE((JointReading{std::numeric_limits<double>::infinity(), kNan}.told()));
}

}  // namespace
}  // namespace multipath_localization
