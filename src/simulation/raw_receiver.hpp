#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "simulation/constellations.hpp"
#include "simulation/receiver_clock.hpp"
#include "simulation/sky_view.hpp"

namespace multipath_localization {

/// What becomes of a signal in the receiver. Noise falls with C/N0 as that of a delay lock loop.
struct RawReceiverParameters {
  double elevation_mask_deg = 10.0;
  double cn0_zenith = 49.0;
  double cn0_horizon = 41.0;
  double fading_sigma = 2.0;
  double fading_time_constant = 3.0;
  double tracking_threshold = 20.0;
  double lock_delay = 1.0;
  double code_noise = 0.5;
  double doppler_noise = 0.05;
  double correlator_spacing = 0.1;
  double loop_bandwidth = 0.1;
  double atmosphere_sigma = 0.5;
  double atmosphere_time_constant = 300.0;
  double inter_system_sigma = 8.0;
  double declared_floor = 4.0;
  double declared_ratio = 4.0;
  ReceiverClockParameters clock;

  void fields(ParameterVisitor& field);
};

/// An antenna in map: east, north, up.
struct AntennaState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
};

/// An observation and the truth behind it.
struct TrackedSignal {
  SatelliteObservation observation;
  SignalPath path;         ///< the strongest, which is tracked
  double multipath = 0.0;  ///< what it and the other paths add to the pseudorange [m]

  [[nodiscard]] bool line_of_sight() const { return path.kind == SignalPath::Kind::kDirect; }
};

/// Measures pseudorange, Doppler and C/N0 of every satellite it can track.
class RawReceiver {
 public:
  RawReceiver(const RawReceiverParameters& parameters, std::vector<Satellite> satellites, SkyView sky,
              const LocalFrame& map, std::uint64_t seed);

  /// The signals tracked at `time` [s], later than at the last call; it is on since long before the first.
  std::vector<TrackedSignal> measure(const AntennaState& antenna, double time);

 private:
  /// What of a satellite's signal runs with time.
  struct Channel {
    double atmosphere = 0.0;              ///< residual delay at the zenith [m]
    double fading = 0.0;                  ///< of C/N0 [dB]
    double code_delay = 0.0;              ///< of the code as tracked, against the straight line [m]
    std::optional<double> tracked_since;  ///< [s]
  };
  /// What a channel draws anew at every epoch, of standard deviation 1.
  struct Noise {
    double code;
    double doppler;
  };
  struct View {
    OrbitState satellite;
    double range;               ///< [m]
    Eigen::Vector3d direction;  ///< to the satellite, length 1
    double elevation;           ///< [rad]
    std::vector<SignalPath> paths;
  };

  Noise step(std::size_t index, double duration);
  [[nodiscard]] View view(const Satellite& satellite, const AntennaState& antenna, double time) const;
  [[nodiscard]] double cn0(const View& view, const Channel& channel) const;
  bool track(const View& view, const Eigen::Vector3d& velocity, double time, Channel& channel) const;
  [[nodiscard]] double echoes(const std::vector<SignalPath>& paths, const Eigen::Vector3d& velocity) const;
  void add_errors(const Channel& channel, const Noise& noise, SatelliteObservation& observation) const;

  RawReceiverParameters parameters_;
  std::vector<Satellite> satellites_;
  SkyView sky_;
  LocalFrame map_;
  std::uint64_t seed_;
  std::uint32_t epochs_ = 0;
  double last_ = 0.0;  ///< time of the last epoch [s]
  ReceiverClock clock_;
  std::array<double, kConstellations> inter_system_{};  ///< [m]
  std::vector<Channel> channels_;
};

}  // namespace multipath_localization
