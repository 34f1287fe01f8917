#include "simulation/satellite_receiver.hpp"

#include <algorithm>
#include <utility>

#include "multipath_localization/models/pseudorange/pseudorange.hpp"

namespace multipath_localization {

SatelliteReceiver::SatelliteReceiver(const ReceiverParameters& parameters,
                                     const std::vector<OutageParameters>& outages, RawReceiver raw,
                                     std::uint64_t seed)
    : parameters_(parameters), schedule_(parameters, outages, seed), raw_(std::move(raw)) {}

AntennaState SatelliteReceiver::antenna(const Robot& robot) const {
  const Pose2& base = robot.pose();
  const Eigen::Vector2d lever(parameters_.antenna_x, parameters_.antenna_y);
  const Eigen::Vector2d velocity_in_base(robot.speed() - robot.yaw_rate() * lever.y(),
                                         robot.yaw_rate() * lever.x());
  AntennaState antenna;
  antenna.position << base * lever, parameters_.antenna_z;
  antenna.velocity << Pose2{0.0, 0.0, base.yaw} * velocity_in_base, 0.0;
  return antenna;
}

std::vector<Measurement> SatelliteReceiver::step(const Robot& robot, double time) {
  if (schedule_.due(time)) {
    const AntennaState at = antenna(robot);
    const std::vector<TrackedSignal> signals = raw_.measure(at, time);
    const auto seen = std::count_if(signals.begin(), signals.end(),
                                    [](const TrackedSignal& signal) { return signal.line_of_sight(); });
    reception_.in_shadow = 2 * static_cast<std::size_t>(seen) <= signals.size();

    PseudorangeEpoch epoch{time, {}, {parameters_.antenna_x, parameters_.antenna_y}};
    for (const TrackedSignal& signal : signals) epoch.observations.push_back(signal.observation);
    std::vector<Measurement> measured = {epoch};
    if (const auto solution =
            solve_position(epoch.observations, declared_weights(epoch.observations), last_position_)) {
      last_position_ = solution->position;
      reception_.bias = (solution->position - at.position).head<2>();
      measured.emplace_back(GnssFix{time, solution->position.head<2>(),
                                    solution->covariance.topLeftCorner<2, 2>(), epoch.antenna_in_base});
    }
    schedule_.send(std::move(measured), time);
  }
  return schedule_.take(time);
}

}  // namespace multipath_localization
