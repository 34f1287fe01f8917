#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "multipath_localization/localization/gyro_turn.hpp"

namespace multipath_localization {
namespace {

constexpr double kPeriod = 0.02;  ///< of odometry [s]
constexpr int kPerIncrement = 2;  ///< gyro samples

/// A turn to the left, then one to the right, over and over [rad/s].
double true_rate(double time) { return 0.6 * std::sin(0.5 * time); }
double true_turn(double time) { return 1.2 * (1.0 - std::cos(0.5 * time)); }

/// What gyro and wheels make of a true yaw rate at a time [s].
struct Sensors {
  std::function<double(double time)> gyro = true_rate;
  std::function<double(double time)> wheels = true_rate;
  double speed = 1.0;       ///< [m/s]
  double gyro_delay = 0.0;  ///< of its messages [s]
};

/// Drives through `gyro` for a while and sums up what the increments turn by.
class Driver {
 public:
  explicit Driver(Sensors sensors) : sensors_(std::move(sensors)) {}

  double drive(double duration) {
    double turn = 0.0;
    for (const double end = time_ + duration - 0.5 * kPeriod; time_ < end;) {
      time_ += kPeriod;
      while (gyro_time_ + sensors_.gyro_delay < time_ - 1e-9) {
        gyro_time_ += kPeriod / kPerIncrement;
        gyro.add({gyro_time_, sensors_.gyro(gyro_time_)});
      }
      last = gyro.with_turn({time_, kPeriod, sensors_.speed, sensors_.wheels(time_ - 0.5 * kPeriod)},
                            sensors_.speed == 0.0);
      turn += last.yaw_rate * kPeriod;
    }
    return turn;
  }

  GyroTurn gyro;
  OdometryIncrement last;

 private:
  Sensors sensors_;
  double time_ = 0.0;
  double gyro_time_ = 0.0;
};

Sensors with_wheels(std::function<double(double)> wheels) {
  Sensors sensors;
  sensors.wheels = std::move(wheels);
  return sensors;
}

Sensors with_gyro(std::function<double(double)> gyro) {
  Sensors sensors;
  sensors.gyro = std::move(gyro);
  return sensors;
}

TEST(GyroTurn, IntegratesTheGyroInPlaceOfSkiddingWheels) {
  Driver driver(with_wheels([](double time) { return 1.3 * true_rate(time) + 0.05; }));
  EXPECT_NEAR(driver.drive(20.0), true_turn(20.0), 1e-3);
  EXPECT_EQ(driver.last.turn_source, TurnSource::kGyro);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kUsed);
  EXPECT_NEAR(driver.gyro.frequency(), kPerIncrement / kPeriod, 0.1);
}

TEST(GyroTurn, LosesNoTurnWhereSamplesComeAfterTheOdometry) {
  Sensors sensors = with_wheels([](double) { return 0.0; });
  sensors.gyro_delay = 0.06;
  Driver driver(sensors);
  EXPECT_NEAR(driver.drive(20.0), true_turn(20.0), 0.05);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kUsed);
}

TEST(GyroTurn, KeepsTheTurnOfTheWheelsWithoutAGyroAndWhereItIsLate) {
  GyroTurn none;
  EXPECT_EQ(none.with_turn({1.0, kPeriod, 1.0, 0.25}, false).yaw_rate, 0.25);
  EXPECT_EQ(none.standing(), GyroStanding::kAbsent);
  Sensors sensors = with_wheels([](double) { return 0.25; });
  sensors.gyro_delay = 0.5;
  Driver late(sensors);
  EXPECT_NEAR(late.drive(10.0), 2.5, 1e-9);
  EXPECT_EQ(late.gyro.standing(), GyroStanding::kSilent);
  EXPECT_EQ(late.last.turn_source, TurnSource::kWheels);
}

TEST(GyroTurn, GoesOnByTheWheelsWhenTheGyroFallsSilent) {
  Driver driver({});
  driver.drive(10.0);
  const OdometryIncrement next = driver.gyro.with_turn({11.0, 1.0, 1.0, 0.125}, false);
  EXPECT_EQ(next.yaw_rate, 0.125);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kSilent);
}

TEST(GyroTurn, BelievesNoGyroOfTheOtherSign) {
  Driver driver(with_gyro([](double time) { return -true_rate(time); }));
  driver.drive(10.0);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kReversed);
  EXPECT_NEAR(driver.drive(10.0), true_turn(20.0) - true_turn(10.0), 1e-3);
}

TEST(GyroTurn, BelievesNoGyroThatCountsInDegrees) {
  Driver driver(with_gyro([](double time) { return 57.3 * true_rate(time); }));
  driver.drive(10.0);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kTooLarge);
}

TEST(GyroTurn, BelievesAGyroThatTurnsLessThanWheelsThatSeeTurnsWhereThereAreNone) {
  Driver driver(with_wheels([](double) { return 0.5; }));
  EXPECT_NEAR(driver.drive(20.0), true_turn(20.0), 1e-3);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kUsed);
}

TEST(GyroTurn, MakesGoodWhatAFrozenGyroMissed) {
  Driver driver(with_gyro([](double time) { return true_rate(std::min(time, 8.0)); }));
  EXPECT_NEAR(driver.drive(20.0), true_turn(20.0), 0.03);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kFrozen);
}

TEST(GyroTurn, GoesBackToAGyroThatHasComeToItself) {
  Driver driver(with_gyro([](double time) { return time < 20.0 ? -true_rate(time) : true_rate(time); }));
  driver.drive(20.0);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kReversed);
  driver.drive(120.0);
  EXPECT_EQ(driver.gyro.standing(), GyroStanding::kUsed);
}

TEST(GyroTurn, TellsTheBiasOfABaseThatStands) {
  Sensors sensors = with_wheels([](double) { return 0.0; });
  sensors.gyro = [](double) { return 0.023; };
  sensors.speed = 0.0;
  Driver driver(sensors);
  EXPECT_EQ(driver.drive(5.0), 0.0);
  EXPECT_NEAR(driver.last.rate_at_rest, 0.023, 1e-9);
}

TEST(GyroTurn, SeesABaseThatIsTurnedOnStandingWheels) {
  Sensors sensors = with_wheels([](double) { return 0.0; });
  sensors.gyro = [](double time) { return 0.5 + 0.001 * std::sin(70.0 * time); };
  sensors.speed = 0.0;
  Driver driver(sensors);
  EXPECT_NEAR(driver.drive(2.0), 1.0, 0.02);
}

TEST(GyroTurn, TakesNoPauseBetweenTwoTicksForRest) {
  Sensors sensors = with_wheels([](double) { return 0.0; });
  sensors.gyro = [](double time) { return 0.05 + 0.001 * std::sin(70.0 * time); };
  sensors.speed = 1e-9;
  Driver driver(sensors);
  EXPECT_NEAR(driver.drive(2.0), 0.1, 1e-3);
  EXPECT_TRUE(std::isnan(driver.last.rate_at_rest));
}

TEST(GyroTurn, LeavesOutWhatIsNotFiniteOrOutOfOrder) {
  Driver driver({});
  driver.drive(5.0);
  driver.gyro.add({5.01, std::numeric_limits<double>::quiet_NaN()});
  driver.gyro.add({std::numeric_limits<double>::infinity(), 0.1});
  driver.gyro.add({4.5, 100.0});
  EXPECT_NEAR(driver.drive(5.0), true_turn(10.0) - true_turn(5.0), 1e-3);
}

TEST(GyroTurn, StartsAfreshWhenTheClockGoesBack) {
  GyroTurn gyro;
  gyro.add({1000.0, 0.3});
  gyro.add({10.0, 0.2});
  gyro.add({10.1, 0.2});
  EXPECT_NEAR(gyro.with_turn({10.1, 0.1, 1.0, 0.0}, false).yaw_rate, 0.2, 1e-9);
}

TEST(GyroTurn, SaysOfEveryStandingWhatItIs) {
  for (const GyroStanding standing :
       {GyroStanding::kAbsent, GyroStanding::kUsed, GyroStanding::kSilent, GyroStanding::kFrozen,
        GyroStanding::kReversed, GyroStanding::kTooLarge}) {
    EXPECT_STRNE(to_string(standing), "");
  }
}

}  // namespace
}  // namespace multipath_localization
