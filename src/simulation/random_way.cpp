#include "simulation/random_way.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "multipath_localization/core/measurements.hpp"
#include "simulation/random_ranges.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

namespace ranges = random_ranges;

constexpr double kWanderTime = 5.0;   ///< correlation time of the driver's unsteadiness [s]
constexpr double kCreep = 0.03;       ///< slowest approach to where the robot has to stand [m/s]
constexpr double kRampLength = 0.3;   ///< over which a corner's curvature sets in, over its radius
constexpr double kFastestTurn = 1.5;  ///< while driving [rad/s]

/// A piece of the way: an arc of some length, or a turn on the spot by an angle.
struct Leg {
  double length = 0.0;     ///< [m]
  double curvature = 0.0;  ///< [1/m]
  double on_spot = 0.0;    ///< [rad]; 0: an arc
};

/// Gives a street's legs one after the other.
class Legs {
 public:
  Legs(const RandomWay& way, RandomStream& random) : way_(way), random_(random) {}

  Leg next() {
    while (legs_.empty()) refill();
    const Leg leg = legs_.front();
    legs_.pop_front();
    return leg;
  }

 private:
  void straight(double factor) { legs_.push_back({factor * way_.straight, 0.0, 0.0}); }

  void arc(double angle, double radius) {
    legs_.push_back({std::abs(angle) * radius, (angle > 0.0 ? 1.0 : -1.0) / radius, 0.0});
  }

  void bend(Span angle, double radius) {
    const double side = either_sign(random_);
    arc(side * draw(random_, angle), radius);
  }

  void corner(double angle) {
    if (way_.on_spot_rate > 0.0) {
      legs_.push_back({0.0, 0.0, angle});
    } else {
      arc(angle, way_.radius);
    }
  }

  void headland(double side) {
    straight(1.0);
    corner(side * 0.5 * kPi);
    legs_.push_back({0.5 * way_.radius, 0.0, 0.0});
    corner(side * 0.5 * kPi);
  }

  void curve() {
    straight(draw(random_, Span{0.0, 0.5}));
    bend(Span{0.2, 1.4}, way_.radius * draw(random_, LogSpan{1.5, 8.0}));
  }

  void crossing() {
    straight(draw(random_, Span{0.3, 1.5}));
    if (!chance(random_, 0.3)) corner(either_sign(random_) * 0.5 * kPi);
  }

  void refill() {
    const double wide = std::max(way_.radius, 0.3 * way_.straight);
    switch (way_.street) {
      case Street::kBlock:
        for (const double side : {1.0, 0.6, 1.0, 0.6}) {
          straight(side);
          corner(0.5 * kPi);
        }
        break;
      case Street::kTown: return crossing();
      case Street::kLoop: straight(0.5); return arc(kPi, wide);
      case Street::kStraight: straight(4.0); return bend(Span{0.05, 0.4}, 10.0 * way_.radius);
      case Street::kCurves: return curve();
      case Street::kEight: arc(2.0 * kPi, wide); return arc(-2.0 * kPi, wide);
      case Street::kField: headland(1.0); return headland(-1.0);
    }
  }

  const RandomWay& way_;
  RandomStream& random_;
  std::deque<Leg> legs_;
};

/// Follows legs within the limits of speed, acceleration and turning.
class Driver {
 public:
  Driver(const RandomWay& way, std::uint64_t seed)
      : way_(way),
        random_(seed, 0, kRandomWayStream),
        legs_(way, random_),
        leg_(legs_.next()),
        next_(legs_.next()),
        speed_(way.start_speed) {
    pose_.yaw = draw(random_, Span{-kPi, kPi});
  }

  MotionStep step(double time) {
    if (leg_.on_spot != 0.0) {
      turn_on_spot(time);
    } else {
      drive(time);
    }
    pose_ = pose_ * displacement({0.0, kWayStep, speed_, yaw_rate_});
    return {pose_, speed_, yaw_rate_};
  }

 private:
  void turn_on_spot(double time) {
    speed_ = 0.0;
    const double goal = any_holds(way_.stops, time) ? 0.0 : way_.on_spot_rate;
    const double rate = std::min(std::abs(yaw_rate_) + 3.0 * kWayStep, goal);
    yaw_rate_ = std::copysign(std::min(rate, std::abs(leg_.on_spot) / kWayStep), leg_.on_spot);
    leg_.on_spot -= yaw_rate_ * kWayStep;
    if (std::abs(leg_.on_spot) < 1e-9) go_on();
  }

  void drive(double time) {
    const double goal = goal_speed(time);
    const double step = way_.acceleration * kWayStep;
    speed_ += std::clamp(goal - speed_, -step, step);
    const double way = std::abs(speed_) * kWayStep;
    const double ramp = way / (kRampLength * way_.radius * way_.radius);
    curvature_ += std::clamp(leg_.curvature - curvature_, -ramp, ramp);
    const double kept = std::exp(-kWayStep / kWanderTime);
    wander_ = kept * wander_ + std::sqrt(1.0 - kept * kept) * way_.wander * random_.normal();
    yaw_rate_ = speed_ * (curvature_ + wander_);
    leg_.length -= way;
    if (leg_.length <= 0.0) go_on();
  }

  void go_on() {
    leg_ = next_;
    next_ = legs_.next();
  }

  [[nodiscard]] double limit(const Leg& leg) const {
    if (leg.on_spot != 0.0) return kCreep;
    if (leg.curvature == 0.0) return way_.speed;
    const double radius = 1.0 / std::abs(leg.curvature);
    return std::min({way_.speed, std::sqrt(way_.lateral_acceleration * radius), kFastestTurn * radius});
  }

  [[nodiscard]] double goal_speed(double time) const {
    if (any_holds(way_.stops, time)) return 0.0;
    if (any_holds(way_.reversals, time)) return -std::min(limit(leg_), ranges::kReverseSpeed);
    const double next = limit(next_);
    return std::min(limit(leg_),
                    std::sqrt(next * next + 2.0 * way_.acceleration * std::max(leg_.length, 0.0)));
  }

  const RandomWay& way_;
  RandomStream random_;
  Legs legs_;
  Leg leg_;
  Leg next_;
  Pose2 pose_;
  double speed_;
  double yaw_rate_ = 0.0;
  double curvature_ = 0.0;
  double wander_ = 0.0;
};

void draw_stops(RandomStream& random, RandomWay& way) {
  const auto somewhere = [&](LogSpan length) {
    return Interval{draw(random, Span{0.0, way.duration}), draw(random, length)};
  };
  if (!chance(random, ranges::kStartsDriving)) way.stops.push_back({0.0, draw(random, ranges::kStartParked)});
  way.start_speed = way.stops.empty() ? way.speed : 0.0;
  if (chance(random, ranges::kParks)) way.stops.push_back(somewhere(ranges::kParking));
  const int stops = static_cast<int>(draw(random, Span{0.0, ranges::kMostStops + 1.0}));
  for (int i = 0; i < stops; ++i) way.stops.push_back(somewhere(ranges::kStop));
}

}  // namespace

std::string_view to_string(Street street) {
  switch (street) {
    case Street::kBlock: return "block";
    case Street::kTown: return "town";
    case Street::kLoop: return "loop";
    case Street::kStraight: return "straight";
    case Street::kCurves: return "curves";
    case Street::kEight: return "eight";
    case Street::kField: return "field";
  }
  return "";
}

bool any_holds(const std::vector<Interval>& intervals, double time) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [time](const Interval& interval) { return interval.holds(time); });
}

RandomWay draw_way(RandomStream& random, double speed, double duration, bool turns_on_spot, bool reverses) {
  RandomWay way;
  way.street = one_of(random, {Street::kBlock, Street::kTown, Street::kLoop, Street::kStraight,
                               Street::kCurves, Street::kEight, Street::kField});
  way.duration = duration;
  way.speed = speed;
  way.acceleration = draw(random, ranges::kAcceleration);
  way.lateral_acceleration = draw(random, ranges::kLateralAcceleration);
  way.radius = draw(random, ranges::kTurnRadius) + ranges::kRadiusOfSpeed * way.speed;
  way.straight = std::clamp(way.speed * draw(random, ranges::kStraight), ranges::kStraightLimits.low,
                            ranges::kStraightLimits.high);
  const double on_spot_rate = draw(random, ranges::kOnSpotRate);
  const bool on_spot = chance(random, ranges::kOnSpot);
  if (turns_on_spot && on_spot && way.speed < ranges::kOnSpotSpeed) way.on_spot_rate = on_spot_rate;
  way.wander = draw(random, ranges::kWander) / way.radius;
  draw_stops(random, way);
  if (reverses && chance(random, ranges::kReverses)) {
    for (int i = 0; i < 3; ++i) {
      way.reversals.push_back({draw(random, Span{0.0, way.duration}), draw(random, ranges::kReversing)});
    }
  }
  return way;
}

std::vector<MotionStep> drive_way(const RandomWay& way, std::uint64_t seed) {
  Driver driver(way, seed);
  std::vector<MotionStep> steps(static_cast<std::size_t>(std::lround(way.duration / kWayStep)));
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = driver.step(static_cast<double>(i) * kWayStep);
  return steps;
}

}  // namespace multipath_localization
