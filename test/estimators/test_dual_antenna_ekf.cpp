#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/estimators/dual_antenna_ekf.hpp"
#include "multipath_localization/estimators/localizer.hpp"
#include "multipath_localization/models/differential_drive.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

constexpr double kStep = 0.01;
constexpr int kStepsPerFix = 20;
constexpr double kBaseline = 0.3;
constexpr double kDegree = kPi / 180.0;
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// The robot of [KAM] on its circle to the left: wheels that slip at every step, pairs of fixes at 5 Hz.
class SlippingRobot {
 public:
  explicit SlippingRobot(std::uint64_t seed, double wheel_noise = 0.1)
      : wheel_noise_(wheel_noise), seed_(seed) {}

  Pose2 truth;
  WheelSpeeds wheels{0.2, 0.3};
  Eigen::Vector3d pose_error = Eigen::Vector3d::Zero();  ///< of every pair
  double fix_sigma = 0.004;
  double time = 0.0;

  OdometryIncrement drive() {
    RandomStream random(seed_, ++step_, 1);
    time = kStep * step_;
    const auto told = [&](const WheelSpeeds& w) {
      return OdometryIncrement{time, kStep, speed(w), yaw_rate(w, 0.35)};
    };
    WheelSpeeds slipping = wheels;
    if (speed(wheels) != 0.0) {
      slipping.left += wheel_noise_ * random.normal();
      slipping.right += wheel_noise_ * random.normal();
    }
    truth = truth * displacement(told(slipping));
    return told(wheels);
  }

  [[nodiscard]] DualAntennaFix pair() const {
    RandomStream random(seed_, step_, 2);
    const Pose2 seen{truth.x + pose_error.x(), truth.y + pose_error.y(), truth.yaw + pose_error.z()};
    const auto fix_at = [&](double y) {
      GnssFix fix;
      fix.stamp = time;
      fix.antenna_in_base = {0.0, y};
      const double east = random.normal();
      fix.position = seen * fix.antenna_in_base + fix_sigma * Eigen::Vector2d(east, random.normal());
      fix.covariance = std::max(fix_sigma * fix_sigma, 1.6e-5) * Eigen::Matrix2d::Identity();
      return fix;
    };
    const GnssFix left = fix_at(0.5 * kBaseline);
    return {time, left, fix_at(-0.5 * kBaseline)};
  }

  /// Drives on for `duration`, giving the filter everything and `observe` a look after each pair.
  template <class Observe>
  void run(Estimator& filter, double duration, const Observe& observe) {
    const auto steps = std::lround(duration / kStep);
    for (long i = 0; i < steps; ++i) {
      filter.predict(drive());
      if (step_ % kStepsPerFix != 0) continue;
      last = filter.update(pair());
      observe();
    }
  }
  void run(Estimator& filter, double duration) {
    run(filter, duration, [] {});
  }

  Innovation last;

 private:
  double wheel_noise_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
};

double heading_error(const Estimator& filter, const Pose2& truth) {
  return angle_difference(filter.estimate().pose.yaw, truth.yaw);
}

double distance(const Estimator& filter, const Pose2& truth) {
  return position_error(filter.estimate(), truth).norm();
}

PosePrior at(const Pose2& pose) {
  PosePrior prior;
  prior.pose = pose;
  prior.covariance = Eigen::Vector3d(1e-4, 1e-4, 1e-3).asDiagonal();
  return prior;
}

DualAntennaEkfParameters measured(double wheel_noise) {
  DualAntennaEkfParameters parameters;
  parameters.wheel_noise = wheel_noise;
  parameters.pose_covariance = "measured";
  return parameters;
}

TEST(DualAntennaEkf, StartsWithPositionAndHeadingFromTheFirstPair) {
  SlippingRobot robot(1);
  robot.truth = {100.0, -50.0, 3.0};
  robot.wheels = {};
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  EXPECT_FALSE(filter.estimate().valid);
  EXPECT_TRUE(filter.hypotheses().empty());
  robot.run(filter, 0.2);
  EXPECT_EQ(robot.last.reason, Reason::kAccepted);
  EXPECT_TRUE(filter.estimate().valid && filter.estimate().aligned);
  EXPECT_LT(distance(filter, robot.truth), 0.02);
  EXPECT_LT(std::abs(heading_error(filter, robot.truth)), 5.0 * kDegree);
  EXPECT_EQ(filter.hypotheses().size(), 1U);
}

TEST(DualAntennaEkf, NeesAndNisLieInTheirChiSquareBands) {
  constexpr int kSeeds = 60;
  constexpr int kPairs = 100;
  double nees_sum = 0.0;
  double nis_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SlippingRobot robot(seed);
    DualAntennaEkf filter{DualAntennaEkfParameters{}};
    filter.start(std::nullopt);
    robot.run(filter, 0.2);
    robot.run(filter, 0.2 * kPairs, [&] { nis_sum += robot.last.nis; });
    Eigen::Vector3d error;
    error << position_error(filter.estimate(), robot.truth), heading_error(filter, robot.truth);
    nees_sum += error.dot(filter.estimate().covariance.inverse() * error);
  }
  // 3.3 standard deviations of a mean of chi-squares: sqrt(2 dof / count).
  EXPECT_NEAR(nees_sum / kSeeds, 3.0, 3.3 * std::sqrt(6.0 / kSeeds));
  EXPECT_NEAR(nis_sum / (kSeeds * kPairs), 3.0, 3.3 * std::sqrt(6.0 / (kSeeds * kPairs)));
}

TEST(DualAntennaEkf, HoldsTheHeadingAtRestHeadingWest) {
  SlippingRobot robot(3);
  robot.truth = {0.0, 0.0, kPi};  // where the heading of the pairs jumps between -pi and pi
  robot.wheels = {};
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 10.0);
  robot.run(filter, 20.0, [&] { ASSERT_LT(std::abs(heading_error(filter, robot.truth)), 1.0 * kDegree); });
  EXPECT_LT(distance(filter, robot.truth), 0.003);
}

TEST(DualAntennaEkf, FollowsASlowTurnOnTheSpot) {
  SlippingRobot robot(4, 0.0);
  robot.wheels = {-0.008, 0.008};
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 20.0);
  robot.run(filter, 20.0, [&] { ASSERT_LT(std::abs(heading_error(filter, robot.truth)), 1.0 * kDegree); });
}

TEST(DualAntennaEkf, TimeAloneDecidesWhatWheelNoiseAmountsTo) {
  DualAntennaEkf coarse{DualAntennaEkfParameters{}};
  DualAntennaEkf fine{DualAntennaEkfParameters{}};
  coarse.start(at({}));
  fine.start(at({}));
  for (int i = 1; i <= 10; ++i) coarse.predict({0.1 * i, 0.1, 0.0, 0.5});
  for (int i = 1; i <= 100; ++i) fine.predict({0.01 * i, 0.01, 0.0, 0.5});
  EXPECT_NEAR(coarse.estimate().covariance(2, 2), fine.estimate().covariance(2, 2), 1e-12);
  EXPECT_GT(fine.estimate().covariance(2, 2), 2.0 * at({}).covariance(2, 2));
}

/// How much an error of the heading grows while the robot turns from 60 degrees south of east to north, when
/// nothing else errs: the filter's own doing.
double growth(const DualAntennaEkfParameters& parameters) {
  constexpr double kError = 1e-6;
  SlippingRobot robot(1, 0.0);
  robot.fix_sigma = 0.0;
  DualAntennaEkf filter(parameters);
  filter.start(at({}));
  robot.run(filter, 40.4);  // until the gain has settled
  PosePrior turned = at(robot.truth);
  turned.covariance = filter.estimate().covariance;
  turned.pose.yaw += kError;
  filter.start(turned);
  robot.run(filter, 9.2);
  return std::abs(heading_error(filter, robot.truth)) / kError;
}

/// The cause of what section 4.1 of [KAM] leaves open. R of Eq. (12) correlates errors of y and theta by
/// 0.72. With F = I the filter does not know that a wrong heading moves the position; heading east it takes
/// the position's innovation, through that correlation, for news of the heading, of the wrong sign, and turns
/// itself away from the truth. With large wheel noise it does not believe its prediction enough for that.
TEST(DualAntennaEkf, PrintedIdentityForFIsUnstableUnlessWheelNoiseIsLarge) {
  const auto printed = [](double wheel_noise) {
    DualAntennaEkfParameters parameters = measured(wheel_noise);
    parameters.heading_jacobian = false;
    return parameters;
  };
  EXPECT_GT(growth(printed(0.1)), 10.0);
  EXPECT_GT(growth(printed(0.3)), 3.0);
  EXPECT_LT(growth(printed(1.0)), 0.1);
  for (const double wheel_noise : {0.1, 0.3, 1.0}) EXPECT_LT(growth(measured(wheel_noise)), 1e-6);

  DualAntennaEkfParameters uncorrelated = printed(0.1);
  for (const std::size_t i : {1U, 2U, 3U, 5U, 6U, 7U}) uncorrelated.pose_error.covariance[i] = 0.0;
  EXPECT_LT(growth(uncorrelated), 1.0);
}

/// Largest error of the heading at the pairs over a turn from east to east [rad].
double worst_heading(DualAntennaEkfParameters parameters, double wheel_noise) {
  parameters.wheel_noise = wheel_noise;
  parameters.gate = std::numeric_limits<double>::infinity();
  SlippingRobot robot(5, wheel_noise);
  DualAntennaEkf filter(parameters);
  filter.start(at({}));
  double worst = 0.0;
  robot.run(filter, 22.0, [&] { worst = std::max(worst, std::abs(heading_error(filter, robot.truth))); });
  return worst;
}

TEST(DualAntennaEkf, PrintedInnovationSpikesWhereTheHeadingPassesWest) {
  DualAntennaEkfParameters unwrapped;
  unwrapped.wrap_innovation = false;
  for (const double wheel_noise : {0.1, 0.3}) {
    EXPECT_GT(worst_heading(unwrapped, wheel_noise), 30.0 * kDegree);
    EXPECT_LT(worst_heading({}, wheel_noise), 5.0 * kDegree);
  }
}

TEST(DualAntennaEkf, TakesTheMeanErrorOffWhenTold) {  // Eq. (11) of [KAM]
  const auto error_at_rest = [](bool subtract) {
    DualAntennaEkfParameters parameters = measured(0.1);
    parameters.subtract_mean = subtract;
    SlippingRobot robot(6);
    robot.wheels = {};
    robot.pose_error = PoseError(parameters.pose_error).mean;
    DualAntennaEkf filter(parameters);
    filter.start(std::nullopt);
    robot.run(filter, 20.0);
    return std::pair(distance(filter, robot.truth), std::abs(heading_error(filter, robot.truth)));
  };
  EXPECT_NEAR(error_at_rest(false).first, 0.061, 0.003);
  EXPECT_NEAR(error_at_rest(false).second, 0.0288, 0.01);
  EXPECT_LT(error_at_rest(true).first, 0.003);
  EXPECT_LT(error_at_rest(true).second, 0.01);
}

TEST(DualAntennaEkf, RefusesPairsThatBetrayAnAntennaThatIsOff) {
  SlippingRobot robot(7);
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  const std::vector<double> before = numbers_of(filter.estimate());
  robot.drive();
  DualAntennaFix reflected = robot.pair();
  reflected.left.position += rotation(robot.truth.yaw) * Eigen::Vector2d(0.0, 0.1);
  EXPECT_EQ(filter.update(reflected).reason, Reason::kWrongBaseline);
  robot.drive();
  DualAntennaFix merged = robot.pair();
  merged.right.position = merged.left.position + Eigen::Vector2d(1e-4, 0.0);
  EXPECT_EQ(filter.update(merged).reason, Reason::kWrongBaseline);
  robot.drive();
  DualAntennaFix unmounted = robot.pair();
  unmounted.left.antenna_in_base = unmounted.right.antenna_in_base;
  EXPECT_EQ(filter.update(unmounted).reason, Reason::kWrongBaseline);
  EXPECT_EQ(numbers_of(filter.estimate()), before);
}

TEST(DualAntennaEkf, RefusesAGrossOutlierAndGivesWayToOneThatLasts) {
  const DualAntennaEkfParameters parameters;
  SlippingRobot robot(8);
  DualAntennaEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  const Pose2 before = robot.truth;
  robot.truth = {before.x + 30.0, before.y - 40.0, before.yaw + 2.5};  // carried away
  robot.run(filter, 0.2);
  EXPECT_EQ(robot.last.reason, Reason::kGated);
  robot.run(filter, parameters.reopen_after - 0.4);
  EXPECT_EQ(robot.last.reason, Reason::kGated);
  robot.run(filter, 1.0);
  EXPECT_EQ(robot.last.reason, Reason::kAccepted);
  EXPECT_LT(distance(filter, robot.truth), 0.05);
  EXPECT_LT(std::abs(heading_error(filter, robot.truth)), 5.0 * kDegree);
}

TEST(DualAntennaEkf, SingleFixesThatAgreeKeepNoPairsOut) {
  SlippingRobot robot(9);
  robot.wheels = {};
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  // Turned by hand about the left antenna, whose fixes come singly as well.
  robot.truth = robot.truth * Pose2{0.0, 0.5 * kBaseline, 0.0} * Pose2{0.0, 0.0, 1.5} *
                Pose2{0.0, -0.5 * kBaseline, 0.0};
  for (int i = 0; i < 50; ++i) {
    robot.run(filter, 0.2);
    GnssFix left = robot.pair().left;
    left.position.x() += 1e-4;
    filter.update(left);
  }
  EXPECT_EQ(robot.last.reason, Reason::kAccepted);
  EXPECT_LT(std::abs(heading_error(filter, robot.truth)), 3.0 * kDegree);
}

TEST(DualAntennaEkf, HoldsThePositionOnOneAntennaAndTheHeadingByMotion) {
  SlippingRobot robot(10);
  DualAntennaEkfParameters parameters;
  DualAntennaEkf filter(parameters);
  filter.start(std::nullopt);
  robot.run(filter, 5.0);
  RootMeanSquare error;
  double worst_heading_error = 0.0;
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < kStepsPerFix; ++k) filter.predict(robot.drive());
    ASSERT_TRUE(filter.update(robot.pair().right).accepted());
    error.add(position_error(filter.estimate(), robot.truth));
    worst_heading_error = std::max(worst_heading_error, std::abs(heading_error(filter, robot.truth)));
  }
  EXPECT_LT(error.value(), 0.01);
  EXPECT_LT(worst_heading_error, 10.0 * kDegree);
  EXPECT_TRUE(filter.estimate().aligned);
}

TEST(DualAntennaEkf, ASingleFixIsWeighedWithTheMeanErrorToo) {
  DualAntennaEkfParameters parameters;
  parameters.subtract_mean = true;
  SlippingRobot robot(11);
  robot.wheels = {};
  robot.fix_sigma = 0.0;
  robot.pose_error = PoseError(parameters.pose_error).mean;
  DualAntennaEkf filter(parameters);
  filter.start(at(robot.truth));
  filter.predict(robot.drive());
  EXPECT_LT(filter.update(robot.pair().left).innovation.norm(), 1e-9);
}

TEST(DualAntennaEkf, FollowsFixesUntilAPairTellsTheHeading) {
  SlippingRobot robot(12);
  robot.fix_sigma = 0.5;  // no RTK yet
  DualAntennaEkfParameters parameters;
  DualAntennaEkf filter(parameters);
  filter.start(std::nullopt);
  EXPECT_TRUE(filter.update(robot.pair().left).accepted());
  robot.run(filter, 5.0);
  EXPECT_TRUE(filter.estimate().valid);
  EXPECT_FALSE(filter.estimate().aligned);
  EXPECT_LT(distance(filter, robot.truth), 2.0);
  robot.fix_sigma = 0.004;
  robot.run(filter, 0.2);
  EXPECT_TRUE(filter.estimate().aligned);
  EXPECT_LT(distance(filter, robot.truth), 0.02);
}

TEST(DualAntennaEkf, ALatePairCountsAtItsOwnStamp) {
  SlippingRobot robot(13, 0.0);
  robot.wheels = {0.6, 1.0};  // 0.8 m/s, 1.14 rad/s
  Localizer localizer(std::make_unique<DualAntennaEkf>(DualAntennaEkfParameters{}), LocalizerParameters{});
  localizer.start(std::nullopt);
  std::optional<DualAntennaFix> underway;
  for (int i = 1; i <= 2000; ++i) {
    localizer.add(robot.drive());
    if (i % kStepsPerFix == 0) underway = robot.pair();
    if (i % kStepsPerFix == 15 && underway) localizer.add(Measurement(*underway));  // 0.15 s late
    if (i > 100) {
      ASSERT_LT(position_error(localizer.estimate(), robot.truth).norm(), 0.02) << i;
      ASSERT_LT(std::abs(angle_difference(localizer.estimate().pose.yaw, robot.truth.yaw)), 5.0 * kDegree);
    }
  }
}

TEST(DualAntennaEkf, RefusesBadInputByItsReasonAndKeepsItsState) {
  SlippingRobot robot(14);
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 1.0);
  filter.predict(robot.drive());
  const std::vector<double> before = numbers_of(filter.estimate());
  const auto reason_of = [&](const std::function<void(DualAntennaFix&)>& spoil) {
    robot.drive();
    DualAntennaFix fixes = robot.pair();
    spoil(fixes);
    return filter.update(fixes).reason;
  };
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.stamp = kNan; }), Reason::kNotFinite);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.left.position.x() = kNan; }), Reason::kNotFinite);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.right.position.y() += 1e9; }), Reason::kInvalidPosition);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.right.covariance(0, 0) = -1.0; }),
            Reason::kInvalidCovariance);
  EXPECT_EQ(reason_of([](DualAntennaFix& f) { f.left.antenna_in_base.x() = kNan; }), Reason::kNotFinite);
  GnssFix single = robot.pair().left;
  single.covariance(0, 1) = kNan;
  EXPECT_EQ(filter.update(single).reason, Reason::kNotFinite);
  EXPECT_EQ(filter.update(PseudorangeEpoch{}).reason, Reason::kUnused);
  filter.predict({robot.time, kStep, kNan, 0.0});
  filter.predict({robot.time, 0.0, 1.0, 0.0});
  EXPECT_EQ(numbers_of(filter.estimate()), before);
  EXPECT_TRUE(all_finite(filter.estimate()));
}

TEST(DualAntennaEkf, ParkedOneReceiverMayRepeatItselfButNotBoth) {
  SlippingRobot robot(15);
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(std::nullopt);
  robot.run(filter, 1.0);
  robot.wheels = {0.0, 0.0};
  const DualAntennaFix stuck = robot.pair();
  for (int k = 0; k < kStepsPerFix; ++k) filter.predict(robot.drive());
  DualAntennaFix half_stuck = robot.pair();
  half_stuck.right = stuck.right;
  EXPECT_EQ(filter.update(half_stuck).reason, Reason::kAccepted);
  EXPECT_EQ(filter.update(half_stuck).reason, Reason::kFrozen);
  robot.run(filter, 0.2);
  EXPECT_EQ(robot.last.reason, Reason::kAccepted);
}

TEST(DualAntennaEkf, UnusablePriorsCountForNothingAndWideOnesLeaveTheHeadingOpen) {
  DualAntennaEkf filter{DualAntennaEkfParameters{}};
  filter.start(at({kNan, 0.0, 0.0}));
  EXPECT_FALSE(filter.estimate().valid);
  PosePrior wide = at({3.0, 4.0, 0.5});
  wide.covariance(2, 2) = 1.0;
  filter.start(wide);
  EXPECT_TRUE(filter.estimate().valid);
  EXPECT_FALSE(filter.estimate().aligned);
  filter.start(at({3.0, 4.0, 0.5}));
  EXPECT_TRUE(filter.estimate().aligned);
}

TEST(DualAntennaEkf, RefusesAMeasuredCovarianceThatIsNone) {
  DualAntennaEkfParameters parameters = measured(0.1);
  parameters.pose_error.covariance = {1.0};
  EXPECT_THROW(DualAntennaEkf{parameters}, ParameterError);
  parameters.pose_error.covariance = std::vector<double>(9, 0.0);
  EXPECT_THROW(DualAntennaEkf{parameters}, ParameterError) << "singular";
  parameters.pose_covariance = "declared";
  EXPECT_NO_THROW(DualAntennaEkf{parameters});
}

TEST(DualAntennaEkf, SameCallsSameBytes) {
  const auto numbers = [] {
    SlippingRobot robot(16);
    DualAntennaEkf filter{DualAntennaEkfParameters{}};
    filter.start(std::nullopt);
    robot.run(filter, 5.0);
    return numbers_of(filter.estimate());
  };
  EXPECT_EQ(numbers(), numbers());
}

}  // namespace
}  // namespace multipath_localization
