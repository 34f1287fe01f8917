#include "oracle.hpp"
#include "ros/localization_node/saved_pose.hpp"
#include "ros/map/datum_file.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

void check(const Geodetic& datum) {
  const LocalFrame map(datum);
  require(map.origin().allFinite(), "map's origin is not finite");
  const std::string file = written("datum_again.yaml", "");
  write_datum(file, datum);
  const auto again = read_datum(file);
  require(again && map.to_map(*again).norm() < 1e-3, "a datum has moved by being written");
}

void check(const SavedPose& saved) {
  require(LocalFrame(saved.datum).origin().allFinite(), "map's origin is not finite");
  require_finite(saved.base_in_map, "the pose");
  require_covariance<3>(saved.covariance, "the covariance");
  const std::string file = written("pose_again.yaml", "");
  write_saved_pose(file, saved);
  const auto again = read_saved_pose(file);
  require(again && again->odometry.stamp == saved.odometry.stamp && again->covariance == saved.covariance &&
              again->base_in_map.x == saved.base_in_map.x && again->base_in_map.yaw == saved.base_in_map.yaw,
          "a pose is another once written and read again");
  for (const Pose2& base_in_odom : {saved.odometry.base_in_odom, Pose2()}) {
    OdometryState now = saved.odometry;
    now.stamp += 1.0;
    now.base_in_odom = base_in_odom;
    const auto prior = resumed(saved, now, 60.0);
    if (!std::holds_alternative<PosePrior>(prior)) return;
    require_finite(std::get<PosePrior>(prior).pose, "the pose to go on from");
    require_covariance<3>(std::get<PosePrior>(prior).covariance, "the covariance to go on from");
  }
}

}  // namespace

void saved(const std::string& bytes) {
  const std::string file = written("saved.yaml", bytes);
  const auto datum = unless_refused<ParameterError>([&] { return read_datum(file); });
  if (datum) check(**datum);
  const auto pose = unless_refused<ParameterError>([&] { return read_saved_pose(file); });
  if (pose) check(**pose);
}

}  // namespace multipath_localization::fuzz
