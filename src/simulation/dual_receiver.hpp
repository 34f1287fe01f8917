#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "multipath_localization/core/measurements.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/models/fix/dual_antenna.hpp"
#include "simulation/receiver.hpp"

namespace multipath_localization {

struct DualReceiverParameters {
  double rate = 0.0;
  double latency = 0.0;
  double baseline = 0.3;
  double antenna_x = 0.0;
  PoseErrorParameters pose_error;
  double baseline_sigma = 0.0056;
  double declared_sigma = 0.004;

  void fields(ParameterVisitor& field);
};

/// Two RTK receivers, their antennas to the left and right of the base's x axis, Fig. 1 of [KAM]. The errors
/// of the two are such that the pose of the base they tell is off by white noise of a given mean and
/// covariance, Eqs. (11) and (12), as in section 4 of [KAM]; the distance between them errs by itself.
class DualReceiver {
 public:
  /// Bias of a fix taken at a point in map [m].
  using BiasAt = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

  /// Throws ParameterError on a mean or a covariance that is none.
  DualReceiver(const DualReceiverParameters& parameters, const std::vector<OutageParameters>& outages,
               std::uint64_t seed);

  /// Watches one step that ended at `time` [s] with the base at `base_in_map`. Returns the pairs delivered by
  /// now: each arrives its latency after its stamp.
  std::vector<DualAntennaFix> step(const Pose2& base_in_map, const BiasAt& bias_at, double time);

 private:
  [[nodiscard]] DualAntennaFix measure(const Pose2& base_in_map, const BiasAt& bias_at, double time) const;

  DualReceiverParameters parameters_;
  std::vector<OutageParameters> outages_;
  PoseError error_;
  std::uint64_t seed_;
  std::uint32_t steps_ = 0;
  std::int64_t emitted_ = 0;
  std::deque<DualAntennaFix> under_way_;
};

}  // namespace multipath_localization
