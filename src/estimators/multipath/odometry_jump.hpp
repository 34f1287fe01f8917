#pragma once

#include <Eigen/Core>
#include <optional>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/models/motion/preintegrated_odometry.hpp"

namespace multipath_localization {

struct OdometryJumpParameters {
  double largest_acceleration = 2.5;
  double largest_yaw_acceleration = 8.0;
  double fault_probability = 0.1;

  void fields(ParameterVisitor& field);
};

/// Watches for odometry that changes faster than the robot can and its noise explains: an encoder that stops
/// or starts to count, wheels that lock or spin. Speed and yaw rate are compared as means over a tenth of a
/// second, two tenths apart, so that neither quantisation nor white noise of single increments counts.
class OdometryJump {
 public:
  /// Which of the two jumped.
  struct Jump {
    bool speed = false;  ///< as at a hard brake too
    bool turn = false;   ///< as no driver turns

    [[nodiscard]] bool any() const { return speed || turn; }
  };

  OdometryJump(const OdometryJumpParameters& parameters, const OdometryNoise& noise)
      : parameters_(parameters), noise_(noise) {}

  /// Takes a usable increment.
  void add(const OdometryIncrement& u);

  /// What has jumped since the last call.
  Jump take();

 private:
  struct Window {
    double duration = 0.0;                          ///< [s]
    double turn = 0.0;                              ///< [rad]
    Eigen::Vector2d way = Eigen::Vector2d::Zero();  ///< forwards and to the left [m]
  };

  [[nodiscard]] Jump between(const Window& before, const Window& middle, const Window& after) const;

  OdometryJumpParameters parameters_;
  OdometryNoise noise_;
  Window current_;
  std::optional<Window> last_;
  std::optional<Window> last_but_one_;
  Jump jump_;
};

}  // namespace multipath_localization
