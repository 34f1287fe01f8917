#include "simulation/dual_receiver.hpp"

#include "multipath_localization/core/random.hpp"
#include "simulation/periods.hpp"
#include "simulation/streams.hpp"

namespace multipath_localization {

void DualReceiverParameters::fields(ParameterVisitor& field) {
  field("rate", rate, {0.0, 1e4}, "Hz", "of pairs of fixes, at most one per simulation step; 0: none");
  field("latency", latency, {0.0, 60.0}, "s", "from measurement to delivery");
  field("baseline", baseline, {0.01, 100.0}, "m", "between the antennas, half of it to either side");
  field("antenna_x", antenna_x, {-100.0, 100.0}, "m", "antennas in base, forwards");
  field.group("pose_error", pose_error, "white error of the base's pose as the pair tells it");
  field("baseline_sigma", baseline_sigma, {0.0, 100.0}, "m", "white error of the distance in the pair");
  field("declared_sigma", declared_sigma, {0.0, 1e6}, "m", "what either receiver claims");
}

DualReceiver::DualReceiver(const DualReceiverParameters& parameters,
                           const std::vector<OutageParameters>& outages, std::uint64_t seed)
    : parameters_(parameters), outages_(outages), error_(parameters.pose_error), seed_(seed) {}

DualAntennaFix DualReceiver::measure(const Pose2& base_in_map, const BiasAt& bias_at, double time) const {
  RandomStream random(seed_, steps_, kDualReceiverStream);
  const Eigen::Vector3d error = error_.mean + error_.root * normals<3>(random);
  const Pose2 told{base_in_map.x + error.x(), base_in_map.y + error.y(), base_in_map.yaw + error.z()};
  const double half = 0.5 * parameters_.baseline;
  const double stretched = half + 0.5 * parameters_.baseline_sigma * random.normal();
  const auto fix_at = [&](double side) {
    GnssFix fix;
    fix.stamp = time;
    fix.antenna_in_base = {parameters_.antenna_x, side * half};
    fix.position = told * Eigen::Vector2d(parameters_.antenna_x, side * stretched) +
                   bias_at(base_in_map * fix.antenna_in_base);
    fix.covariance = parameters_.declared_sigma * parameters_.declared_sigma * Eigen::Matrix2d::Identity();
    return fix;
  };
  return {time, fix_at(1.0), fix_at(-1.0)};
}

std::vector<DualAntennaFix> DualReceiver::step(const Pose2& base_in_map, const BiasAt& bias_at, double time) {
  ++steps_;
  const auto due = periods(time, parameters_.rate);
  if (due > emitted_ && !outage_at(outages_, time)) {
    under_way_.push_back(measure(base_in_map, bias_at, time));
  }
  emitted_ = due;

  std::vector<DualAntennaFix> delivered;
  while (!under_way_.empty() && under_way_.front().stamp + parameters_.latency <= time + 1e-9) {
    delivered.push_back(under_way_.front());
    under_way_.pop_front();
  }
  return delivered;
}

}  // namespace multipath_localization
