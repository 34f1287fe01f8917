#include "evaluation/random_drive.hpp"

#include <algorithm>

#include "simulation/random_gyro.hpp"
#include "simulation/random_heading.hpp"
#include "simulation/random_velocity.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

constexpr int kTruthPeriodMs = 100;
const Geodetic kDatum{33.894, 130.839, 30.0};
const Eigen::Vector2d kSecondAntenna(0.0, -0.8);            // of a second receiver, on the base [m]
constexpr std::uint64_t kSecondSeed = 0xC2B2AE3D27D4EB4FU;  // its errors are not those of the first

std::vector<TruthSample> truth_of(const RandomRobot& robot) {
  const int period_ms = std::min(kTruthPeriodMs, robot.receiver.period_ms);
  const auto stride = static_cast<std::size_t>(period_ms / kWayStepMs);
  std::vector<TruthSample> truth;
  for (std::size_t n = 1; n * stride <= robot.steps.size(); ++n) {
    TruthSample sample;
    sample.stamp = static_cast<double>(n * stride) * kWayStepMs / 1000.0;
    sample.base_in_map = robot.steps[n * stride - 1].base_in_map;
    sample.has_yaw = true;
    sample.shadow = shadow_at(robot.receiver, sample.base_in_map.position()) != nullptr;
    sample.wheel_fault = robot.odometry.faulty(sample.stamp, sample.stamp);
    truth.push_back(sample);
  }
  return truth;
}

template <class Reading>
void append(const std::vector<Reading>& readings, Drive& drive) {
  for (const Reading& reading : readings) drive.measurements.push_back({reading, reading.stamp});
}

void add_extras(const RandomExtras& extras, std::uint64_t seed, const RandomRobot& robot, Drive& drive) {
  if (extras.gyro) {
    for (const YawRate& read : read_gyro(draw_gyro(seed), robot.steps, seed)) {
      drive.yaw_rates.push_back({read, read.stamp});
    }
  }
  if (extras.velocity) {
    append(read_velocities(draw_velocity(seed), robot.receiver, robot.steps, seed), drive);
  }
  if (extras.heading) append(read_headings(draw_heading(seed), robot.steps, seed), drive);
  if (extras.receivers) {
    RandomStream random(seed, 1, kRandomReceiverStream);
    const RandomReceiver second = draw_receiver(random, robot.steps, robot.way.speed);
    for (GnssFix& fix : read_fixes(second, robot.steps, seed + kSecondSeed, kSecondAntenna).fixes) {
      fix.receiver = 1;
      drive.measurements.push_back({fix, fix.stamp});
    }
  }
  if (extras.velocity || extras.heading || extras.receivers) sort_by_arrival(drive.measurements);
}

/// The level of an RTK receiver's fix, by its own word.
FixLevel level_of(const FixTruth& truth) {
  if (truth.level == kFixed) return FixLevel::kFixed;
  return truth.level == kFloat ? FixLevel::kFloat : FixLevel::kSingle;
}

void tell_levels(const std::vector<FixTruth>& truths, std::vector<GnssFix>& fixes) {
  for (std::size_t i = 0; i < fixes.size(); ++i) fixes[i].level = level_of(truths[i]);
}

}  // namespace

RandomDrive random_drive(std::uint64_t seed, const RandomExtras& extras) {
  RandomDrive made;
  made.robot = draw_robot(seed);
  made.drive.name = "random_" + std::to_string(seed);
  made.drive.datum = kDatum;
  made.drive.truth = truth_of(made.robot);
  ReadOdometry odometry = read_odometry(made.robot.odometry, made.robot.steps, seed);
  made.drive.odometry = std::move(odometry.increments);
  made.without_faults = std::move(odometry.without_faults);
  ReadFixes fixes = read_fixes(made.robot.receiver, made.robot.steps, seed);
  if (extras.levels && made.robot.receiver.kind == ReceiverKind::kRtk) tell_levels(fixes.truths, fixes.fixes);
  for (const GnssFix& fix : fixes.fixes) made.drive.measurements.push_back({fix, fix.stamp});
  made.fix_truths = std::move(fixes.truths);
  add_extras(extras, seed, made.robot, made.drive);
  made.robot.steps = {};
  return made;
}

}  // namespace multipath_localization
