#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "default_localizer.hpp"
#include "simulated_drive.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {
namespace {

constexpr int kSeeds = 5;

/// What becomes of a heading [rad] on its way at a time [s]; nothing comes where it gives none.
using Fault = std::function<std::optional<double>(double yaw, double time)>;

std::optional<double> none(double yaw, double /*time*/) { return yaw; }
std::optional<double> silent(double /*yaw*/, double /*time*/) { return std::nullopt; }

/// Headings five times a second, with 0.02 rad of noise and every twentieth second any.
void add_heading(Localizer& localizer, const SimulatedDrive& drive, std::uint64_t seed, double stamp,
                 const Fault& fault) {
  const auto step = static_cast<std::uint32_t>(std::lround(20.0 * stamp));
  if (step % 4 != 0) return;
  RandomStream random(seed, step, 88);
  RandomStream of_second(seed, step / 20, 89);
  double yaw = drive.truth.yaw + 0.02 * random.normal();
  if (of_second.uniform() < 0.05) yaw += 2.0 * kPi * of_second.uniform();
  const std::optional<double> told = fault(yaw, stamp);
  if (told) localizer.add(Measurement(Heading{stamp, wrap_angle(*told), 0.02 * 0.02}));
}

/// Of two minutes, between 60 and 100 s without fixes and with odometry that swerves.
struct Outcome {
  double way_to_alignment = std::numeric_limits<double>::infinity();  ///< [m]
  double rmse_in_outage = 0.0;                                        ///< [m]
  double yaw_nees = 0.0;  ///< mean squared error of the heading over its variance, until the outage
};

Outcome outcome(const Fault& fault, std::uint64_t seed) {
  Localizer localizer = default_localizer(seed);
  SimulatedDrive drive(seed);
  drive.fix_sigma = 1.0;
  drive.spoilt = [&](OdometryIncrement u) {
    add_heading(localizer, drive, seed, u.stamp, fault);
    if (!drive.receiving) u.yaw_rate += 0.02 * std::sin(0.1 * u.stamp + static_cast<double>(seed));
    return u;
  };
  Outcome result;
  RootMeanSquare in_outage, sigmas_off;
  const auto observe = [&] {
    const PoseEstimate& estimate = localizer.estimate();
    if (estimate.aligned) {
      result.way_to_alignment = std::min(result.way_to_alignment, drive.speed * drive.time);
      if (drive.time < 60.0) {
        sigmas_off.add(Eigen::Vector2d(angle_difference(estimate.pose.yaw, drive.truth.yaw), 0.0) /
                       std::sqrt(estimate.covariance(2, 2)));
      }
    }
    if (!drive.receiving) in_outage.add(position_error(estimate, drive.truth));
  };
  drive.run(localizer, 60.0, observe);
  drive.receiving = false;
  drive.run(localizer, 40.0, observe);
  drive.receiving = true;
  drive.run(localizer, 20.0, observe);
  result.rmse_in_outage = in_outage.value();
  result.yaw_nees = square(sigmas_off.value());
  return result;
}

Outcome mean_outcome(const Fault& fault) {
  Outcome sum{0.0, 0.0, 0.0};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Outcome one = outcome(fault, seed);
    sum.way_to_alignment += one.way_to_alignment / kSeeds;
    sum.rmse_in_outage += one.rmse_in_outage / kSeeds;
    sum.yaw_nees += one.yaw_nees / kSeeds;
  }
  return sum;
}

const Outcome& without_headings() {
  static const Outcome kOutcome = mean_outcome(silent);
  return kOutcome;
}

const Outcome& with_headings() {
  static const Outcome kOutcome = mean_outcome(none);
  return kOutcome;
}

TEST(MultipathParticleFilterHeading, EndsAligningSooner) {
  EXPECT_LT(with_headings().way_to_alignment, 0.7 * without_headings().way_to_alignment);
}

TEST(MultipathParticleFilterHeading, KeepsDeadReckoningStraightInAnOutage) {
  EXPECT_LT(with_headings().rmse_in_outage, 0.7 * without_headings().rmse_in_outage);
}

TEST(MultipathParticleFilterHeading, SaysHowUnsureTheHeadingIsWhereItIsOffByAConstant) {
  const Outcome off = mean_outcome([](double yaw, double) { return yaw + 0.175; });
  EXPECT_LT(off.yaw_nees, 2.0);
  EXPECT_LT(off.rmse_in_outage, 1.4 * without_headings().rmse_in_outage);
  EXPECT_LT(with_headings().yaw_nees, 2.0);
}

TEST(MultipathParticleFilterHeading, DoesNoHarmWhereItLies) {
  const double most = 1.4 * without_headings().rmse_in_outage;  // what five seeds differ by and a fifth
  const auto harm = [&](const Fault& fault) { return mean_outcome(fault).rmse_in_outage; };
  EXPECT_LT(harm([](double yaw, double) { return -yaw; }), most);
  EXPECT_LT(harm([](double yaw, double) { return yaw + kPi; }), most);
  EXPECT_LT(harm([](double yaw, double time) { return time > 30.0 ? yaw + kPi : yaw; }), most);
  EXPECT_LT(harm([](double, double) { return 0.3; }), most);
  EXPECT_LT(harm([](double yaw, double time) { return time > 30.0 ? 0.3 + 1e-6 * time : yaw; }), most)
      << "frozen but for the last digits";
}

TEST(MultipathParticleFilterHeading, RefusesWhatIsNoHeading) {
  Localizer localizer = default_localizer(1);
  localizer.add(OdometryIncrement{1.0, 1.0, 1.0, 0.0});
  Heading heading{1.0, std::numeric_limits<double>::quiet_NaN(), 0.01};
  localizer.add(Measurement(heading));
  heading = {1.0, 0.5, -1.0};
  localizer.add(Measurement(heading));
  const auto reports = localizer.take_reports();
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].innovation.reason, Reason::kNotFinite);
  EXPECT_EQ(reports[1].innovation.reason, Reason::kInvalidCovariance);
}

TEST(MultipathParticleFilterHeading, SaysWhereItIsContradicted) {
  Localizer localizer = default_localizer(1);
  SimulatedDrive drive(1);
  drive.spoilt = [&](const OdometryIncrement& u) {
    add_heading(localizer, drive, 1, u.stamp,
                [](double yaw, double time) { return std::optional<double>(time < 20.0 ? yaw : yaw + 2.0); });
    return u;
  };
  drive.run(localizer, 36.0);
  int used = 0;
  int contradicted = 0;
  for (const MeasurementReport& report : localizer.take_reports()) {
    if (!std::holds_alternative<Heading>(report.measurement)) continue;
    if (report.stamp < 20.0 && report.innovation.accepted()) ++used;
    if (report.stamp > 22.0 && report.innovation.reason == Reason::kGated) ++contradicted;
  }
  EXPECT_GT(used, 60);
  EXPECT_GT(contradicted, 50);
}

TEST(MultipathParticleFilterHeading, LearnsToBelieveAntennasThatAreMountedAcross) {
  Localizer localizer = default_localizer(1);
  SimulatedDrive drive(1);
  drive.bend = 0.6;
  drive.spoilt = [&](const OdometryIncrement& u) {
    add_heading(localizer, drive, 1, u.stamp,
                [](double yaw, double) { return std::optional<double>(yaw + 0.5 * kPi); });
    return u;
  };
  drive.run(localizer, 150.0);
  int used = 0;
  for (const MeasurementReport& report : localizer.take_reports()) {
    if (!std::holds_alternative<Heading>(report.measurement) || report.stamp < 120.0) continue;
    used += report.innovation.accepted() ? 1 : 0;
  }
  EXPECT_GT(used, 100);
}

}  // namespace
}  // namespace multipath_localization
