#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

#include "estimators/multipath/multipath_particle_filter.hpp"
#include "multipath_localization/core/random.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "multipath_localization/localization/tilt_record.hpp"
#include "simulation/ground.hpp"
#include "simulation/simulator.hpp"

namespace multipath_localization {
namespace {

constexpr double kSlope = 0.2617993877991494;  ///< 15 degrees
constexpr int kSeeds = 3;

GroundParameters slope(double wavelength = 0.0) { return {kSlope, wavelength}; }

TEST(Ground, IsLevelWhereNothingIsSaid) {
  const Tilt tilt = GroundParameters().tilt({3.0, 4.0, 1.0});
  EXPECT_EQ(tilt.pitch, 0.0);
  EXPECT_EQ(tilt.roll, 0.0);
}

TEST(Ground, RisesToTheEast) {
  const Tilt up = slope().tilt({0.0, 0.0, 0.0});
  EXPECT_NEAR(up.pitch, -kSlope, 1e-12) << "nose up";
  EXPECT_NEAR(up.roll, 0.0, 1e-12);
  const Tilt across = slope().tilt({0.0, 0.0, 0.5 * kPi});
  EXPECT_NEAR(across.pitch, 0.0, 1e-12);
  EXPECT_NEAR(across.roll, -kSlope, 1e-12) << "the left side is lower to who looks north";
}

TEST(Ground, LeansAMastDownhillWhicheverWayTheRobotPoints) {
  for (const double yaw : {0.0, 0.7, 2.0, -1.4}) {
    const Pose2 base{2.0, -1.0, yaw};
    const Eigen::Vector2d mast = base * levelled(slope().tilt(base), {0.0, 0.0, 1.2}) - base.position();
    EXPECT_NEAR(mast.x(), -1.2 * std::sin(kSlope), 1e-12);
    EXPECT_NEAR(mast.y(), 0.0, 1e-12);
  }
}

TEST(Ground, InWavesFallsBehindTheCrest) {
  EXPECT_NEAR(slope(20.0).tilt({0.0, 0.0, 0.0}).pitch, -kSlope, 1e-12);
  EXPECT_NEAR(slope(20.0).tilt({5.0, 0.0, 0.0}).pitch, 0.0, 1e-12);
  EXPECT_NEAR(slope(20.0).tilt({10.0, 0.0, 0.0}).pitch, kSlope, 1e-12);
}

TEST(Ground, LengthensTheWayOfTheWheels) {
  SimulatorParameters parameters;
  parameters.ground.slope = kSlope;
  Simulator simulator(parameters, 1);
  double driven = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const auto odometry = simulator.step({1.0, 0.0}).odometry;
    if (odometry) driven += odometry->speed * odometry->duration;
  }
  EXPECT_NEAR(driven * std::cos(kSlope), simulator.truth().x, 0.02);
}

/// How the base is levelled on a drive.
enum class Levelling { kNone, kByOrientation, kByGravity };

/// An RTK receiver on a mast of 1.2 m, 0.3 m ahead of the axle, and an IMU.
class MastDrive {
 public:
  MastDrive(const GroundParameters& ground, Levelling levelling, std::uint64_t seed)
      : levelling_(levelling),
        seed_(seed),
        simulator_(world(ground), seed),
        localizer_(std::make_unique<MultipathParticleFilter>(MultipathParticleFilterParameters{}, seed), {}) {
    localizer_.start(std::nullopt);
  }

  /// Position RMSE over two minutes of winding way behind the first one [m].
  double rmse() {
    double squares = 0.0;
    int count = 0;
    while (simulator_.time() < 180.0) {
      if (!step() || simulator_.time() < 60.0) continue;
      squares += (localizer_.estimate().pose.position() - simulator_.truth().position()).squaredNorm();
      ++count;
    }
    return std::sqrt(squares / count);
  }

 private:
  static SimulatorParameters world(const GroundParameters& ground) {
    SimulatorParameters parameters;
    parameters.ground = ground;
    parameters.receiver.antenna_x = 0.3;
    parameters.receiver.antenna_z = 1.2;
    parameters.receiver.sigma_open = parameters.receiver.declared_sigma_open = 0.015;
    parameters.gyro.rate = 50.0;
    return parameters;
  }

  /// Whether odometry came.
  bool step() {
    const Readings readings = simulator_.step({1.5, 0.15 * std::sin(0.1 * simulator_.time())});
    for (const YawRate& yaw_rate : readings.yaw_rates) {
      tilt_.add(inertial(yaw_rate));
      localizer_.add(yaw_rate);
    }
    if (readings.odometry) {
      tilt_.drive(*readings.odometry);
      localizer_.add(over_map(tilt_.at(readings.odometry->stamp), *readings.odometry));
    }
    for (const Measurement& measurement : readings.measurements) {
      GnssFix fix = std::get<GnssFix>(measurement);
      fix.status = FixStatus::kGroundBased;
      fix.antenna_in_base = levelled(tilt_.at(fix.stamp), {0.3, 0.0, 1.2});
      localizer_.add(Measurement(fix));
    }
    return readings.odometry.has_value();
  }

  /// What the IMU says, with noise.
  InertialSample inertial(const YawRate& yaw_rate) {
    RandomStream random(seed_, ++samples_, 5);
    const auto noise = [&](double sigma) {
      const double x = random.normal(), y = random.normal();
      return Eigen::Vector3d(sigma * Eigen::Vector3d(x, y, random.normal()));
    };
    const Tilt tilt = simulator_.parameters().ground.tilt(simulator_.truth());
    const Eigen::Vector3d up = up_in_base(tilt);
    InertialSample sample;
    sample.stamp = yaw_rate.stamp;
    const double about_normal = along_ground(tilt, {0.0, 1.0, 0.0, yaw_rate.rate}).yaw_rate;
    sample.rate = Eigen::Vector3d(0.0, 0.0, about_normal) + noise(0.005);
    const Eigen::Vector3d curve(0.0, simulator_.speed() * simulator_.yaw_rate(), 0.0);
    if (levelling_ == Levelling::kByOrientation) sample.up = (up + noise(0.005)).normalized();
    if (levelling_ == Levelling::kByGravity) sample.acceleration = 9.81 * up + curve + noise(0.2);
    return sample;
  }

  Levelling levelling_;
  std::uint64_t seed_;
  std::uint32_t samples_ = 0;
  Simulator simulator_;
  Localizer localizer_;
  TiltRecord tilt_;
};

double mean_rmse(const GroundParameters& ground, Levelling levelling) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) sum += MastDrive(ground, levelling, seed).rmse();
  return sum / kSeeds;
}

TEST(SlopeDrive, ByRollAndPitchIsAboutAsGoodAsOnFlatGround) {
  EXPECT_LT(mean_rmse({}, Levelling::kNone), 0.03) << "flat";
  EXPECT_LT(mean_rmse({kSlope, 0.0}, Levelling::kByOrientation), 0.05);
  EXPECT_LT(mean_rmse({kSlope, 0.0}, Levelling::kByGravity), 0.05);
}

TEST(SlopeDrive, InWavesFollowsTheSlope) {
  EXPECT_LT(mean_rmse({kSlope, 30.0}, Levelling::kByOrientation), 0.05);
}

TEST(SlopeDrive, WithoutThemTheMastIsAsFarOffAsItLeans) {
  EXPECT_GT(mean_rmse({kSlope, 0.0}, Levelling::kNone), 0.2);
}

}  // namespace
}  // namespace multipath_localization
