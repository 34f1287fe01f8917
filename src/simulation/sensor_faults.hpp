#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/fault_interval.hpp"

namespace multipath_localization {

/// What goes wrong for a while with an input of up to three numbers.
struct SensorFault : FaultInterval {
  std::string kind = "silent";
  double size = 0.0;

  void fields(ParameterVisitor& field);
};

/// Stands between such an input and whoever uses it, and spoils it. Of several faults at a time all count.
/// Deterministic by seed.
class SensorFaults {
 public:
  /// The faults' times count from `start` [s]; `what` is the input's name in phrases, `stream` whose random
  /// numbers it draws.
  SensorFaults(std::vector<SensorFault> faults, std::string what, std::uint64_t seed, std::uint32_t stream,
               double start = 0.0)
      : faults_(std::move(faults)), what_(std::move(what)), seed_(seed), stream_(stream), start_(start) {}

  struct Spoilt {
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    double delay = 0.0;  ///< of its arrival [s]
  };
  /// A value of that stamp as it comes out, nothing where it is lost. Once per message, in order.
  std::optional<Spoilt> spoil(double stamp, const Eigen::Vector3d& value);

  /// A phrase for each fault that is there at `now`.
  [[nodiscard]] std::vector<std::string> active(double now) const;

 private:
  std::vector<SensorFault> faults_;
  std::string what_;
  std::uint64_t seed_;
  std::uint32_t stream_;
  double start_;
  std::uint32_t messages_ = 0;
  std::optional<Eigen::Vector3d> frozen_;  ///< what was said as the fault began
};

}  // namespace multipath_localization
