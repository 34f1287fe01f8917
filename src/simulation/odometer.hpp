#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "simulation/robot.hpp"

namespace multipath_localization {

/// Wheels that turn more than the robot moves, for a while.
struct SlipParameters {
  double start = 0.0;
  double duration = 1.0;
  double ratio = 0.5;

  void fields(ParameterVisitor& field);
};

/// What the odometer reads, as `source` says.
enum class OdometerSource { kMotion, kCommand };

struct OdometerParameters {
  double rate = 50.0;
  OdometerSource source = OdometerSource::kMotion;
  double speed_scale_error = 0.0;
  double speed_scale_error_sigma = 0.0;
  double speed_noise = 0.0;
  double speed_noise_ratio = 0.0;
  double gyro_bias = 0.0;
  double gyro_bias_sigma = 0.0;
  double yaw_rate_noise = 0.0;
  double slip_rate = 0.0;
  double slip_duration = 1.0;
  double slip_ratio = 0.5;
  std::vector<SlipParameters> slips;

  void fields(ParameterVisitor& field);
};

/// Wheel odometry with a gyro: mean velocity and yaw rate over each of its periods, spoilt as real ones are.
class Odometer {
 public:
  Odometer(const OdometerParameters& parameters, std::uint64_t seed);

  /// Watches one step of `duration` that ended at `time` [s]; an increment whenever a period is full.
  std::optional<OdometryIncrement> step(const Robot& robot, double time, double duration);

  [[nodiscard]] double scale() const { return scale_; }          ///< measured over true speed, as drawn
  [[nodiscard]] double gyro_bias() const { return gyro_bias_; }  ///< as drawn [rad/s]
  [[nodiscard]] bool slipping() const { return slipping_; }
  [[nodiscard]] const OdometerParameters& parameters() const { return parameters_; }

 private:
  double slip_ratio(double time, double duration);

  OdometerParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  double scale_ = 1.0;
  double gyro_bias_ = 0.0;
  double distance_ = 0.0;  ///< wheel path since the last increment [m]
  double sideways_ = 0.0;  ///< wheel path to the left since the last increment [m]
  double turn_ = 0.0;      ///< since the last increment [rad]
  double elapsed_ = 0.0;   ///< since the last increment [s]
  std::int64_t emitted_ = 0;
  double slip_until_ = 0.0;
  bool slipping_ = false;
};

}  // namespace multipath_localization
