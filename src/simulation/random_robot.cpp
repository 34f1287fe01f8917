#include "simulation/random_robot.hpp"

#include <cmath>

#include "simulation/random_ranges.hpp"
#include "simulation/streams.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

namespace ranges = random_ranges;

void describe_receiver(const RandomReceiver& receiver, std::ostream& out) {
  out << to_string(receiver.kind) << " " << receiver.levels.front().sigma() << " m at "
      << 1e3 / receiver.period_ms << " Hz, declared " << to_string(receiver.declaration);
  if (receiver.declared_sigma > 0.0) out << " " << receiver.declared_sigma << " m";
  if (receiver.optimism > 1.0) out << " /" << receiver.optimism;
}

void describe_faults(const RandomRobot& robot, std::ostream& out) {
  const RandomReceiver& receiver = robot.receiver;
  for (const RandomShadow& shadow : receiver.shadows) {
    out << "; shadow " << shadow.bias << " m " << to_string(shadow.law);
  }
  if (!receiver.shadows.empty()) out << (receiver.declares_shadow ? " (declared)" : " (not declared)");
  if (receiver.kind == ReceiverKind::kRtk && receiver.wrong_fix_share > 0.0) {
    out << "; wrong fixes " << 100.0 * receiver.wrong_fix_share << " %";
  }
  if (receiver.outlier_share > 0.0) out << "; outliers " << 100.0 * receiver.outlier_share << " %";
  for (const RandomOutage& outage : receiver.outages) {
    out << "; outage " << outage.when.duration << " s";
    if (outage.off_duration > 0.0) out << " then " << outage.off_bias << " m off";
  }
  if (!robot.odometry.faults.empty()) out << "; " << robot.odometry.faults.size() << " wheel faults";
  if (!robot.way.reversals.empty()) out << "; backs up";
}

}  // namespace

RandomRobot draw_robot(std::uint64_t seed) {
  RandomStream random(seed, 0, kRandomRobotStream);
  RandomRobot robot;
  const double speed = draw(random, ranges::kSpeed);
  const double duration = std::round(draw(random, ranges::kDuration));
  robot.odometry = draw_odometry(random, speed, duration);
  robot.way = draw_way(random, speed, duration, robot.odometry.turns_by_wheels(),
                       robot.odometry.yaw != YawSource::kDoppler);
  robot.steps = drive_way(robot.way, seed);
  RandomStream receiver(seed, 0, kRandomReceiverStream);
  robot.receiver = draw_receiver(receiver, robot.steps, speed);
  return robot;
}

std::string describe(const RandomRobot& robot) {
  PlainStream out;
  out.precision(2);
  describe_receiver(robot.receiver, out);
  out << "; " << robot.way.speed << " m/s " << to_string(robot.way.street) << ", "
      << to_string(robot.odometry.yaw) << " at " << std::lround(1e3 / robot.odometry.period_ms) << " Hz";
  describe_faults(robot, out);
  return out.str();
}

}  // namespace multipath_localization
