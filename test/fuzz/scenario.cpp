#include "evaluation/scenario.hpp"

#include "evaluation/suite.hpp"
#include "oracle.hpp"
#include "ros/fault_injector_node/fault_injector.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

void check(const Scenario& scenario) {
  require(std::isfinite(scenario.duration) && scenario.duration > 0.0, "the duration is not above 0");
  for (const Eigen::Vector2d& point : scenario.waypoints)
    require(point.allFinite(), "a waypoint is not finite");
  const MotionCommand command = command_at(scenario.sequence, 1.0, scenario.simulator.robot.wheelbase);
  require_finite(command.speed + command.steering_angle, "a command");
  require_described(scenario.simulator, "a simulator's parameters");
  require_described(scenario.steering, "a follower's parameters");
}

}  // namespace

void scenario(const std::string& bytes) {
  const std::string file = written("scenario.yaml", bytes);
  const auto one = unless_refused<ParameterError>([&] { return load_scenario(file); });
  if (one) check(*one);
  const auto suite = unless_refused<ParameterError>([&] { return load_suite(file); });
  if (suite) {
    for (const Scenario& row : *suite) check(row);
  }
  const auto faults = unless_refused<ParameterError>([&] {
    FaultInjectorParameters read;
    load(read_yaml(file), read);
    return read;
  });
  if (faults) require_described(*faults, "a fault injector's parameters");
}

}  // namespace multipath_localization::fuzz
