#include "ros/localization_node/pose_persistence.hpp"

#include <ros/console.h>

#include <cmath>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

constexpr double kSaveEvery = 1.0;    ///< [s]
constexpr double kTellSaving = 60.0;  ///< [s]
constexpr double kSameDatum = 0.01;   ///< two are one within this [m]

void write(const std::string& file, const SavedPose& pose) {
  try {
    write_saved_pose(file, pose);
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(kTellSaving, "the pose is not saved: %s", error.what());
  }
}

}  // namespace

std::optional<PosePersistence::Start> PosePersistence::start(const OdometryState& now,
                                                             const LocalFrame* map) const {
  if (file_.empty()) return std::nullopt;
  const std::optional<SavedPose> saved = read_saved_pose(file_);
  if (!saved) return std::nullopt;
  const auto answer = resumed(*saved, now, max_age_);
  if (const auto* why = std::get_if<std::string>(&answer)) throw ParameterError(*why);
  if (map != nullptr && map->to_map(saved->datum).norm() > kSameDatum) {
    throw ParameterError("its map has another datum");
  }
  return Start{std::get<PosePrior>(answer), saved->datum};
}

bool PosePersistence::due(double stamp) const {
  return !file_.empty() && std::abs(stamp - saved_) >= kSaveEvery;
}

void PosePersistence::save(const SavedPose& pose) {
  saved_ = pose.odometry.stamp;
  writer_.write([file = file_, pose] { write(file, pose); });
}

}  // namespace multipath_localization
