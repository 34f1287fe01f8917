#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "default_localizer.hpp"
#include "simulated_drive.hpp"

namespace multipath_localization {
namespace {

constexpr int kSeeds = 5;

/// What becomes of a velocity [m/s] on its way; nothing comes where it gives none.
using Fault = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&)>;

std::optional<Eigen::Vector2d> none(const Eigen::Vector2d& velocity) { return velocity; }

/// Velocities five times a second, with 5 cm/s of noise and every tenth second reflected.
void add_velocity(Localizer& localizer, const SimulatedDrive& drive, std::uint64_t seed, double stamp,
                  const Fault& fault) {
  const auto step = static_cast<std::uint32_t>(std::lround(20.0 * stamp));
  if (step % 4 != 0) return;
  RandomStream random(seed, step, 78);
  RandomStream of_second(seed, step / 20, 79);
  GnssVelocity velocity;
  velocity.stamp = stamp;
  velocity.velocity = rotation(drive.truth.yaw) * Eigen::Vector2d(drive.speed, drive.lateral_speed);
  velocity.velocity += 0.05 * normals<2>(random);
  if (of_second.uniform() < 0.1) velocity.velocity += normals<2>(of_second);
  velocity.covariance = 0.05 * 0.05 * Eigen::Matrix2d::Identity();
  const std::optional<Eigen::Vector2d> told = fault(velocity.velocity);
  if (!told) return;
  velocity.velocity = *told;
  localizer.add(Measurement(velocity));
}

/// Of one drive over two minutes, with fixes off by `bias` [m] between 60 and 100 s.
struct Drive {
  double bias = 20.0;
  Fault fault = none;
};

struct Outcome {
  double way_to_alignment = std::numeric_limits<double>::infinity();  ///< [m]
  double rmse_in_shadow = 0.0;                                        ///< [m]
};

Outcome outcome(const Drive& made, std::uint64_t seed) {
  Localizer localizer = default_localizer(seed);
  SimulatedDrive drive(seed);
  drive.fix_sigma = 1.0;
  drive.bias = [&](double time) {
    return time > 60.0 && time < 100.0 ? Eigen::Vector2d(0.0, made.bias) : Eigen::Vector2d(0.0, 0.0);
  };
  drive.spoilt = [&](const OdometryIncrement& u) {
    add_velocity(localizer, drive, seed, u.stamp, made.fault);
    return u;
  };
  Outcome result;
  RootMeanSquare in_shadow;
  drive.run(localizer, 120.0, [&] {
    if (localizer.estimate().aligned) {
      result.way_to_alignment = std::min(result.way_to_alignment, drive.speed * drive.time);
    }
    if (drive.time > 60.0 && drive.time < 100.0)
      in_shadow.add(position_error(localizer.estimate(), drive.truth));
  });
  result.rmse_in_shadow = in_shadow.value();
  return result;
}

Outcome mean_outcome(const Drive& made) {
  Outcome sum{0.0, 0.0};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Outcome one = outcome(made, seed);
    sum.way_to_alignment += one.way_to_alignment / kSeeds;
    sum.rmse_in_shadow += one.rmse_in_shadow / kSeeds;
  }
  return sum;
}

const Outcome& without_velocity() {
  static const Outcome kOutcome =
      mean_outcome({20.0, [](const Eigen::Vector2d&) { return std::optional<Eigen::Vector2d>(); }});
  return kOutcome;
}

TEST(MultipathParticleFilterVelocity, TellsTheCourseWithinFourMetres) {
  EXPECT_LT(mean_outcome({}).way_to_alignment, 4.0);
  EXPECT_GT(without_velocity().way_to_alignment, 8.0);
}

TEST(MultipathParticleFilterVelocity, KeepsDeadReckoningStraightInAShadow) {
  EXPECT_LT(mean_outcome({}).rmse_in_shadow, 0.9 * without_velocity().rmse_in_shadow);
}

TEST(MultipathParticleFilterVelocity, DoesNoHarmWhereItLies) {
  const Fault reversed = [](const Eigen::Vector2d& v) { return -v; };
  const Fault zero = [](const Eigen::Vector2d& v) { return 0.0 * v; };
  const Fault north_first = [](const Eigen::Vector2d& v) { return Eigen::Vector2d(v.y(), v.x()); };
  const Fault in_knots = [](const Eigen::Vector2d& v) { return 1.94 * v; };
  const Fault frozen = [](const Eigen::Vector2d&) { return Eigen::Vector2d(1.2, -1.6); };
  const double most = 1.4 * without_velocity().rmse_in_shadow;  // what five seeds differ by and a fifth
  EXPECT_LT(mean_outcome({20.0, reversed}).rmse_in_shadow, most);
  EXPECT_LT(mean_outcome({20.0, zero}).rmse_in_shadow, most);
  EXPECT_LT(mean_outcome({20.0, north_first}).rmse_in_shadow, most);
  EXPECT_LT(mean_outcome({20.0, in_knots}).rmse_in_shadow, most);
  EXPECT_LT(mean_outcome({20.0, frozen}).rmse_in_shadow, most);
}

TEST(MultipathParticleFilterVelocity, RefusesWhatIsNoVelocity) {
  Localizer localizer = default_localizer(1);
  localizer.add(OdometryIncrement{1.0, 1.0, 1.0, 0.0});
  GnssVelocity velocity;
  velocity.stamp = 1.0;
  velocity.velocity.x() = std::numeric_limits<double>::quiet_NaN();
  localizer.add(Measurement(velocity));
  velocity.velocity.x() = 1.0;
  velocity.covariance(0, 0) = -1.0;
  localizer.add(Measurement(velocity));
  const auto reports = localizer.take_reports();
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].innovation.reason, Reason::kNotFinite);
  EXPECT_EQ(reports[1].innovation.reason, Reason::kInvalidCovariance);
}

TEST(MultipathParticleFilterVelocity, SaysWhereItContradictsTheWheels) {
  Localizer localizer = default_localizer(1);
  SimulatedDrive drive(1);
  drive.spoilt = [&](const OdometryIncrement& u) {
    add_velocity(localizer, drive, 1, u.stamp, [&](const Eigen::Vector2d& v) {
      return std::optional<Eigen::Vector2d>(drive.time < 20.0 ? v : Eigen::Vector2d(-v));
    });
    return u;
  };
  drive.run(localizer, 40.0);
  int used = 0;
  int contradicted = 0;
  for (const MeasurementReport& report : localizer.take_reports()) {
    if (!std::holds_alternative<GnssVelocity>(report.measurement)) continue;
    if (report.stamp < 20.0 && report.innovation.accepted()) ++used;
    if (report.stamp > 22.0 && report.innovation.reason == Reason::kGated) ++contradicted;
  }
  EXPECT_GT(used, 70);
  EXPECT_GT(contradicted, 70);
}

}  // namespace
}  // namespace multipath_localization
