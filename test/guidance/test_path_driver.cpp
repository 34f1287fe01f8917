// How well the path is kept, in closed loop with bases that lag and poses that are late.

#include <gtest/gtest.h>

#include <random>

#include "multipath_localization/guidance/waypoint_follower.hpp"
#include "regulated_pure_pursuit.hpp"
#include "steered_base.hpp"

namespace multipath_localization {
namespace {

using Route = std::vector<Eigen::Vector2d>;

constexpr double kStep = 0.02;  // of control and motion [s]

/// What became of a drive.
struct Outcome {
  double squares = 0.0;
  int steps = 0;
  double largest = 0.0;        ///< distance from the path [m]
  double goal_distance = 0.0;  ///< at the end [m]
  double time = 0.0;           ///< until at rest [s]
  bool at_rest = false;
  bool within_limits = true;

  [[nodiscard]] double rmse() const { return std::sqrt(squares / std::max(steps, 1)); }

  void see(double deviation) {
    squares += deviation * deviation;
    largest = std::max(largest, deviation);
    ++steps;
  }
};

WaypointFollowerParameters parameters_of(const BaseTraits& base, double speed) {
  WaypointFollowerParameters p;
  p.loop = false;
  p.cruise_speed = speed;
  p.wheelbase = base.wheelbase;
  p.steering_lag = base.steering_lag;
  return p;
}

/// `earlier`, `before` and `now` are commands one after the other.
bool keeps(const CommandLimits& limits, const MotionCommand& earlier, const MotionCommand& before,
           const MotionCommand& now, double most) {
  const double faster = (now.speed - before.speed) / kStep;
  const double jerk = std::abs(now.speed - 2.0 * before.speed + earlier.speed) / (kStep * kStep);
  const double turn = std::abs(now.steering_angle - before.steering_angle) / kStep;
  return jerk <= limits.max_jerk + 1e-3 && faster <= limits.max_acceleration + 1e-9 &&
         -faster <= limits.max_deceleration + 1e-9 && turn <= limits.max_steering_rate + 1e-9 &&
         std::abs(now.steering_angle) <= most + 1e-12;
}

/// Drives a route from `start` until the base is at rest at its end, or for an hour.
Outcome drive(const Route& route, const WaypointFollowerParameters& p, const BaseTraits& traits,
              const Pose2& start) {
  WaypointFollower follower(p, route);
  CommandLimiter limiter(p.limits, p.wheelbase);
  SteeredBase base(traits, start);
  Outcome outcome;
  MotionCommand earlier;
  for (; outcome.time < 3600.0 && !outcome.at_rest; outcome.time += kStep) {
    const Pose2 now = limiter.carried_forward(base.arrived(), traits.pose_age);
    const FollowerOutput wanted = follower.command(now, traits.pose_age, Trust::kGood);
    const MotionCommand before = limiter.last();
    const MotionCommand command = limiter.limited(wanted.command, wanted.urgent, kStep);
    outcome.within_limits =
        outcome.within_limits && keeps(p.limits, earlier, before, command, p.max_steering_angle);
    earlier = before;
    base.step(command, kStep);
    const PathProgress* progress = follower.progress_on_path();
    if (progress != nullptr) {
      const double s = progress->station();
      const Eigen::Vector2d at = base.pose().position();
      outcome.see((progress->path().at(progress->path().nearest(at, s - 3.0, s + 3.0)).position - at).norm());
    }
    outcome.at_rest = follower.finished() && command.speed == 0.0;
  }
  outcome.goal_distance = (base.pose().position() - route.back()).norm();
  return outcome;
}

/// The same path, limits and base under regulated pure pursuit.
Outcome pursue(const Route& route, const WaypointFollowerParameters& p, const BaseTraits& traits,
               const Pose2& start) {
  Route all = route;
  all.insert(all.begin(), start.position());
  const Path path(all, p.switch_radius);
  RegulatedPurePursuit pursuit(path, p.cruise_speed, p.wheelbase);
  CommandLimiter limiter(p.limits, p.wheelbase);
  SteeredBase base(traits, start);
  Outcome outcome;
  for (; outcome.time < 3600.0 && pursuit.station() < path.length() - 0.1; outcome.time += kStep) {
    MotionCommand wanted = pursuit.command(base.arrived(), limiter.last().speed);
    wanted.steering_angle = std::clamp(wanted.steering_angle, -p.max_steering_angle, p.max_steering_angle);
    base.step(limiter.limited(wanted, false, kStep), kStep);
    const Eigen::Vector2d at = base.pose().position();
    const double s = pursuit.station();
    outcome.see((path.at(path.nearest(at, s - 3.0, s + 3.0)).position - at).norm());
  }
  return outcome;
}

struct Shape {
  const char* name;
  Route waypoints;
};

/// Shapes of a size [m], from the origin on, heading east.
std::vector<Shape> shapes(double size) {
  Route eight;
  for (const double side : {1.0, -1.0}) {
    for (int i = 1; i <= 12; ++i) {
      const double turn = 2.0 * kPi * i / 12.0;
      eight.emplace_back(size * std::sin(turn), side * size * (1.0 - std::cos(turn)));
    }
  }
  Route slalom;
  for (int i = 1; i <= 8; ++i) slalom.emplace_back(2.0 * size * i, i % 2 == 0 ? -0.5 * size : 0.5 * size);
  return {{"figure of eight", eight},
          {"slalom", slalom},
          {"hairpin", {{4.0 * size, 0.0}, {4.0 * size, 2.0 * size}, {0.0, 2.0 * size}}},
          {"block", {{6.0 * size, 0.0}, {6.0 * size, 4.0 * size}, {0.0, 4.0 * size}, {0.0, 0.5 * size}}}};
}

/// Every shape, driven by bases from small to large whose steering lags by 0.2 s and whose poses are 0.1 s
/// late; what is driven is at least as wide as the base can turn.
template <class Visit>
void drive_all(const Visit& visit) {
  for (const double wheelbase : {0.3, 0.5, 1.0, 3.0}) {
    for (const double speed : {0.3, 1.5, 5.0}) {
      const BaseTraits traits{wheelbase, 0.2, 0.1};
      WaypointFollowerParameters p = parameters_of(traits, speed);
      const double turning_radius = 1.0 / p.tightest_curvature();
      p.switch_radius = std::max(0.5, 0.5 * turning_radius);
      for (const Shape& shape : shapes(2.0 + 1.5 * turning_radius)) visit(shape, p, traits);
    }
  }
}

Pose2 towards(const Eigen::Vector2d& waypoint) { return {0.0, 0.0, std::atan2(waypoint.y(), waypoint.x())}; }

TEST(PathDriver, AreKeptByBasesThatLagWithPosesThatAreLate) {
  drive_all([](const Shape& shape, const WaypointFollowerParameters& p, const BaseTraits& traits) {
    const Outcome outcome = drive(shape.waypoints, p, traits, towards(shape.waypoints.front()));
    SCOPED_TRACE(std::string(shape.name) + ", wheelbase " + std::to_string(p.wheelbase) + ", speed " +
                 std::to_string(p.cruise_speed));
    EXPECT_LT(outcome.largest, 0.15);
    EXPECT_LT(outcome.goal_distance, 0.1);
    EXPECT_TRUE(outcome.at_rest);
    EXPECT_TRUE(outcome.within_limits);
  });
}

TEST(PathDriver, AreKeptBetterThanByRegulatedPurePursuit) {
  constexpr double kTie = 1e-3;  // [m]
  drive_all([](const Shape& shape, const WaypointFollowerParameters& p, const BaseTraits& traits) {
    const Pose2 start = towards(shape.waypoints.front());
    EXPECT_LT(drive(shape.waypoints, p, traits, start).rmse(),
              pursue(shape.waypoints, p, traits, start).rmse() + kTie)
        << shape.name << ", wheelbase " << p.wheelbase << ", speed " << p.cruise_speed;
  });
}

/// From any heading, along waypoints anywhere, of which the last may be within the turning circle.
TEST(PathDriver, OfRandomRoutesKeepTheLimitsAndEndAtRestAtTheGoal) {
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (int i = 0; i < 1000; ++i) {
    const BaseTraits traits{uniform(0.3, 1.0), uniform(0.0, 0.2), uniform(0.0, 0.1)};
    WaypointFollowerParameters p = parameters_of(traits, uniform(0.3, 3.0));
    p.switch_radius = uniform(0.3, 2.0);
    Route route;
    const int waypoints = 1 + i % 7;
    for (int k = 0; k < waypoints; ++k) route.emplace_back(uniform(-30.0, 30.0), uniform(-30.0, 30.0));
    const double bearing = uniform(-kPi, kPi);
    const Eigen::Vector2d last_leg(std::cos(bearing), std::sin(bearing));
    route.emplace_back(route.back() + std::pow(10.0, uniform(-0.7, 1.3)) * last_leg);
    const Outcome outcome = drive(route, p, traits, {0.0, 0.0, uniform(-kPi, kPi)});
    EXPECT_TRUE(outcome.within_limits) << i;
    EXPECT_TRUE(outcome.at_rest) << i;
    EXPECT_LT(outcome.goal_distance, 0.1) << i;
  }
}

}  // namespace
}  // namespace multipath_localization
