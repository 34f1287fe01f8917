#include "ros/gnss_receiver_node/corrected_epoch_message.hpp"

namespace multipath_localization {

namespace {

/// `seen`: as it is from the antenna.
Pseudorange to_message(const TrackedSatellite& tracked, const SatelliteObservation& seen) {
  const Eigen::Vector3d& position = tracked.at_transmission.position;
  const Eigen::Vector3d unknown = Eigen::Vector3d::Constant(SatelliteObservation::kUnknown);
  const Eigen::Vector3d velocity = seen.has_doppler() ? tracked.at_transmission.velocity : unknown;
  Pseudorange message;
  message.constellation = static_cast<std::uint8_t>(tracked.satellite.constellation);
  message.satellite = static_cast<std::uint16_t>(tracked.satellite.number);
  message.pseudorange = seen.pseudorange;
  message.range_rate = seen.range_rate;
  message.cn0 = seen.cn0;
  message.elevation = seen.elevation;
  message.sigma = seen.sigma;
  message.position.x = position.x();
  message.position.y = position.y();
  message.position.z = position.z();
  message.velocity.x = velocity.x();
  message.velocity.y = velocity.y();
  message.velocity.z = velocity.z();
  return message;
}

}  // namespace

GnssEpoch to_message(const CorrectedEpoch& epoch, const std_msgs::Header& header) {
  GnssEpoch message;
  message.header = header;
  message.pseudoranges.reserve(epoch.observations.size());
  for (std::size_t i = 0; i < epoch.observations.size(); ++i) {
    message.pseudoranges.push_back(to_message(epoch.satellites[i], epoch.observations[i]));
  }
  return message;
}

}  // namespace multipath_localization
