#include "simulation/random_odometry.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/gauss_markov.hpp"
#include "simulation/random_ranges.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

namespace {

namespace ranges = random_ranges;

constexpr double kWheelsOnly = 8.0;      ///< [m/s] faster robots do not steer by their driven wheels
constexpr double kSlowestDoppler = 0.3;  ///< [m/s] below it a velocity tells no direction

/// What the two sides of the robot have rolled, or the whole of it.
struct Rolled {
  double way = 0.0;   ///< [m]
  double turn = 0.0;  ///< [rad]
};

/// Counts whole ticks and keeps the rest for the next time.
class TickCounter {
 public:
  explicit TickCounter(double tick) : tick_(tick) {}

  double count(double way) {
    if (tick_ == 0.0) return way;
    rest_ += way;
    const double whole = tick_ * std::floor(rest_ / tick_);
    rest_ -= whole;
    return whole;
  }

 private:
  double tick_;
  double rest_ = 0.0;
};

/// Encoders of either side, or one of the middle.
class Encoders {
 public:
  explicit Encoders(const RandomOdometry& odometry)
      : odometry_(odometry), left_(odometry.tick), right_(odometry.tick) {}

  Rolled read(const Rolled& rolled) {
    if (!odometry_.turns_by_wheels()) return {left_.count(rolled.way), rolled.turn};
    const double half = 0.5 * odometry_.wheel_separation * rolled.turn;
    const double left = left_.count(rolled.way - half);
    const double right = right_.count(rolled.way + half);
    return {0.5 * (left + right), (right - left) / odometry_.wheel_separation};
  }

 private:
  const RandomOdometry& odometry_;
  TickCounter left_;
  TickCounter right_;
};

/// The same wheels under the faults.
Rolled spoilt(const RandomOdometry& odometry, Rolled rolled, double time) {
  for (const WheelFault& fault : odometry.faults) {
    if (!fault.when.holds(time)) continue;
    if (fault.kind != WheelFault::Kind::kDeadEncoder) {
      rolled.way *= 1.0 + fault.ratio;
      if (odometry.turns_by_wheels()) rolled.turn *= 1.0 + fault.ratio;
    } else if (odometry.turns_by_wheels()) {
      const double right = rolled.way + 0.5 * odometry.wheel_separation * rolled.turn;
      rolled = {0.5 * right, right / odometry.wheel_separation};
    } else {
      rolled.way = 0.0;
    }
  }
  return rolled;
}

/// What wheels and gyro make of the motion, period by period.
class WheelReader {
 public:
  WheelReader(const RandomOdometry& odometry, std::uint64_t seed)
      : odometry_(odometry),
        random_(seed, 0, kRandomOdometryStream),
        drift_(odometry.scale_drift_sigma, odometry.scale_drift_time,
               RandomStream(seed, 1, kRandomOdometryStream)),
        gyro_bias_(odometry.gyro_bias),
        encoders_(odometry),
        faulty_encoders_(odometry) {}

  /// One part of the motion of `duration` [s].
  void move(double speed, double yaw_rate, double time, double duration) {
    const double way = speed * duration;
    const Rolled rolled{
        way * (1.0 + odometry_.speed_scale + drift_.value().x()),
        yaw_rate * duration * (1.0 + odometry_.turn_scale) + odometry_.curvature_offset * way};
    add(rolled, clean_);
    add(spoilt(odometry_, rolled, time), faulty_);
    moved_ += std::abs(way) + (odometry_.turns_by_wheels() ? std::abs(yaw_rate * duration) : 0.0);
  }

  /// Ends a period of `duration` at `stamp` [s].
  void emit(double stamp, double duration, ReadOdometry& read) {
    drift_.step(duration, random_);
    gyro_bias_ += odometry_.gyro_bias_walk * std::sqrt(duration) * random_.normal();
    const double way_noise = odometry_.speed_noise * std::sqrt(moved_) * random_.normal();
    const bool rests = odometry_.yaw != YawSource::kGyro && moved_ == 0.0;
    const double turn_noise = rests ? 0.0 : odometry_.yaw_noise * std::sqrt(duration) * random_.normal();
    const Rolled noise{way_noise, turn_noise};
    read.without_faults.push_back(increment(encoders_, clean_, noise, stamp, duration));
    read.increments.push_back(increment(faulty_encoders_, faulty_, noise, stamp, duration));
    clean_ = faulty_ = {};
    moved_ = 0.0;
  }

 private:
  static void add(const Rolled& part, Rolled& sum) {
    sum.way += part.way;
    sum.turn += part.turn;
  }

  [[nodiscard]] OdometryIncrement increment(Encoders& encoders, Rolled rolled, const Rolled& noise,
                                            double stamp, double duration) const {
    add(noise, rolled);
    const Rolled counted = encoders.read(rolled);
    const double bias = odometry_.yaw == YawSource::kGyro ? gyro_bias_ : 0.0;
    return {stamp, duration, counted.way / duration, counted.turn / duration + bias};
  }

  const RandomOdometry& odometry_;
  RandomStream random_;
  GaussMarkov2 drift_;
  double gyro_bias_;
  Encoders encoders_;
  Encoders faulty_encoders_;
  Rolled clean_;
  Rolled faulty_;
  double moved_ = 0.0;  ///< in this period [m], turns of driven wheels counted with 1 m/rad
};

/// Motion as the velocities of a receiver tell it: mean speed of two of them, and by how much they turned.
std::vector<OdometryIncrement> read_doppler(const RandomOdometry& odometry,
                                            const std::vector<MotionStep>& steps, std::uint64_t seed) {
  RandomStream random(seed, 0, kRandomOdometryStream);
  GaussMarkov2 error(odometry.doppler_sigma, odometry.doppler_time,
                     RandomStream(seed, 1, kRandomOdometryStream));
  const double period = 1e-3 * odometry.period_ms;
  const auto stride = static_cast<std::size_t>(odometry.period_ms / kWayStepMs);
  std::vector<OdometryIncrement> increments;
  double last_speed = steps.front().speed;
  std::optional<double> last_direction;
  for (std::size_t i = stride - 1, n = 1; i < steps.size(); i += stride, ++n) {
    error.step(period, random);
    const double yaw = steps[i].base_in_map.yaw;
    const Eigen::Vector2d velocity =
        steps[i].speed * Eigen::Vector2d(std::cos(yaw), std::sin(yaw)) + error.value();
    const double speed = velocity.norm();
    std::optional<double> direction;
    if (speed > std::max(kSlowestDoppler, 2.0 * odometry.doppler_sigma)) {
      direction = std::atan2(velocity.y(), velocity.x());
    }
    const double told = direction ? speed : 0.0;
    const double turn = direction && last_direction ? angle_difference(*direction, *last_direction) : 0.0;
    const double stamp = static_cast<double>(n) * odometry.period_ms / 1000.0;
    increments.push_back({stamp, period, 0.5 * (told + last_speed), turn / period});
    last_speed = told;
    if (direction) last_direction = direction;
  }
  return increments;
}

void draw_faults(RandomStream& random, double duration, RandomOdometry& odometry) {
  if (chance(random, ranges::kSlips)) {
    const double interval = draw(random, ranges::kSlipInterval);
    for (double time = interval * draw(random, Span{0.0, 2.0}); time < duration;
         time += interval * draw(random, Span{0.0, 2.0})) {
      odometry.faults.push_back({WheelFault::Kind::kSlip,
                                 {time, draw(random, ranges::kSlipDuration)},
                                 draw(random, ranges::kSlipRatio)});
    }
  }
  if (chance(random, ranges::kWheelFault)) {
    const auto kind = one_of(
        random, {WheelFault::Kind::kLocked, WheelFault::Kind::kSpinning, WheelFault::Kind::kDeadEncoder});
    const Interval when{draw(random, Span{0.0, duration}), draw(random, ranges::kWheelFaultDuration)};
    odometry.faults.push_back({kind, when, kind == WheelFault::Kind::kLocked ? -1.0 : 1.0});
  }
}

void draw_turning(RandomStream& random, double speed, RandomOdometry& odometry) {
  const double offset =
      std::min(draw(random, ranges::kCurvatureOffset), ranges::kCurvatureOffsetRate / speed);
  const double skid = draw(random, ranges::kSkidTurnScale);
  if (odometry.yaw == YawSource::kGyro) {
    odometry.gyro_bias_sigma = draw(random, ranges::kGyroBiasSigma);
    odometry.gyro_bias = odometry.gyro_bias_sigma * random.normal();
    odometry.gyro_bias_walk = draw(random, ranges::kGyroBiasWalk);
    return;
  }
  odometry.curvature_offset_sigma = offset;
  odometry.curvature_offset = offset * random.normal();
  odometry.turn_scale_sigma = ranges::kWheelTurnScaleSigma;
  odometry.turn_scale = odometry.turn_scale_sigma * random.normal();
  if (odometry.yaw != YawSource::kSkidSteer) return;
  odometry.turn_scale = skid;
  odometry.turn_scale_mean = 0.5 * (ranges::kSkidTurnScale.low + ranges::kSkidTurnScale.high);
  odometry.turn_scale_sigma = (ranges::kSkidTurnScale.high - ranges::kSkidTurnScale.low) / std::sqrt(12.0);
}

}  // namespace

std::string_view to_string(YawSource source) {
  switch (source) {
    case YawSource::kGyro: return "gyro";
    case YawSource::kWheels: return "wheels";
    case YawSource::kSkidSteer: return "skid steer";
    case YawSource::kSteering: return "steering";
    case YawSource::kDoppler: return "Doppler";
  }
  return "";
}

bool RandomOdometry::faulty(double start, double end) const {
  return std::any_of(faults.begin(), faults.end(), [&](const WheelFault& fault) {
    return fault.when.start < end && fault.when.start + fault.when.duration > start;
  });
}

RandomOdometry draw_odometry(RandomStream& random, double speed, double duration) {
  RandomOdometry odometry;
  odometry.yaw = speed < kWheelsOnly
                     ? one_of(random, {YawSource::kGyro, YawSource::kGyro, YawSource::kWheels,
                                       YawSource::kSkidSteer, YawSource::kSteering})
                     : one_of(random, {YawSource::kGyro, YawSource::kGyro, YawSource::kSteering});
  if (chance(random, ranges::kDoppler) && speed > 1.0) odometry.yaw = YawSource::kDoppler;
  odometry.doppler_sigma = draw(random, ranges::kDopplerSigma);
  odometry.doppler_time = draw(random, ranges::kDopplerTime);
  odometry.period_ms = one_of(random, {10, 20, 20, 20, 40, 50, 50, 100, 100, 200, 5, 1});
  if (odometry.yaw == YawSource::kDoppler) {
    odometry.period_ms = one_of(random, {1000, 1000, 200});
    return odometry;
  }
  odometry.speed_scale_sigma = draw(random, ranges::kSpeedScaleSigma);
  odometry.speed_scale = odometry.speed_scale_sigma * random.normal();
  odometry.scale_drift_sigma = draw(random, ranges::kScaleDriftSigma);
  odometry.scale_drift_time = draw(random, ranges::kScaleDriftTime);
  odometry.speed_noise = draw(random, ranges::kSpeedNoise);
  odometry.yaw_noise = draw(random, ranges::kYawNoise);
  odometry.wheel_separation = draw(random, ranges::kWheelSeparation);
  draw_turning(random, speed, odometry);
  const double tick = draw(random, ranges::kTick);
  if (chance(random, ranges::kTicks)) {
    const double largest = ranges::kTickOfSeparation * odometry.wheel_separation;
    odometry.tick = odometry.turns_by_wheels() ? std::min(tick, largest) : tick;
  }
  draw_faults(random, duration, odometry);
  return odometry;
}

ReadOdometry read_odometry(const RandomOdometry& odometry, const std::vector<MotionStep>& steps,
                           std::uint64_t seed) {
  ReadOdometry read;
  if (odometry.yaw == YawSource::kDoppler) {
    read.increments = read.without_faults = read_doppler(odometry, steps, seed);
    return read;
  }
  const int part_ms = std::min(odometry.period_ms, kWayStepMs);
  const double part = 1e-3 * part_ms;
  WheelReader reader(odometry, seed);
  std::int64_t now_ms = 0;
  for (const MotionStep& step : steps) {
    for (int done_ms = 0; done_ms < kWayStepMs; done_ms += part_ms) {
      reader.move(step.speed, step.yaw_rate, 1e-3 * static_cast<double>(now_ms), part);
      now_ms += part_ms;
      if (now_ms % odometry.period_ms != 0) continue;
      reader.emit(static_cast<double>(now_ms) / 1000.0, 1e-3 * odometry.period_ms, read);
    }
  }
  return read;
}

}  // namespace multipath_localization
