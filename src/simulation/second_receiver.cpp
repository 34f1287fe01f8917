#include "simulation/second_receiver.hpp"

namespace multipath_localization {

namespace {

constexpr std::uint64_t kOwnSeed = 0x8CB92BA72F3D8DD7U;  ///< its errors are not those of the first receiver

ReceiverParameters as_receiver(const SecondReceiverParameters& parameters) {
  ReceiverParameters receiver;
  receiver.rate = parameters.rate;
  receiver.antenna_x = parameters.antenna_x;
  receiver.antenna_y = parameters.antenna_y;
  receiver.sigma_open = parameters.sigma_open;
  receiver.sigma_shadow = parameters.sigma_shadow;
  receiver.declared_sigma_open = receiver.declared_sigma_shadow = parameters.declared_sigma;
  return receiver;
}

}  // namespace

void SecondReceiverParameters::fields(ParameterVisitor& field) {
  field("rate", rate, {0.0, 1e4}, "Hz", "of fixes, at most one per simulation step; 0: none");
  field("antenna_x", antenna_x, {-100.0, 100.0}, "m", "antenna in base, forwards");
  field("antenna_y", antenna_y, {-100.0, 100.0}, "m", "antenna in base, to the left");
  field("sigma_open", sigma_open, {0.0, 1e3}, "m", "white noise of each component under open sky");
  field("sigma_shadow", sigma_shadow, {0.0, 1e3}, "m", "white noise of each component in a zone");
  field("declared_sigma", declared_sigma, {0.0, 1e6}, "m", "what the receiver claims everywhere");
  field.list("zones", zones, "regions in which this receiver is in a shadow, and the other one is not");
}

SecondReceiver::SecondReceiver(const SecondReceiverParameters& parameters,
                               const std::vector<OutageParameters>& outages, std::uint64_t seed)
    : receiver_(as_receiver(parameters), outages, seed ^ kOwnSeed),
      zones_(parameters.zones, seed ^ kOwnSeed) {}

std::vector<GnssFix> SecondReceiver::step(const Pose2& base_in_map, double time, double duration) {
  zones_.step(duration);
  const Eigen::Vector2d antenna_in_map = base_in_map * receiver_.antenna_in_base();
  const Reception around = zones_.around(antenna_in_map);
  std::vector<GnssFix> fixes = receiver_.step(antenna_in_map, around, time, duration);
  for (GnssFix& fix : fixes) fix.receiver = 1;
  return fixes;
}

}  // namespace multipath_localization
