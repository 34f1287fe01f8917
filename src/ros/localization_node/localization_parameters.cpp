#include "ros/localization_node/localization_parameters.hpp"

#include <limits>

#include "multipath_localization/estimators/make_estimator.hpp"

namespace multipath_localization {

namespace {

void refuse_relative(const std::string& name, const std::string& file) {
  if (!file.empty() && file.front() != '/')
    throw ParameterError(name + " " + file + " is not an absolute path");
}

}  // namespace

void OutputParameters::fields(ParameterVisitor& field) {
  field("publish_tf", publish_tf, "whether to broadcast map -> odom");
  field("publish_odom_tf", publish_odom_tf,
        "whether to broadcast odom -> base_link from the odometry as long as nobody else does");
  field("transform_tolerance", transform_tolerance, {0.0, 10.0}, "s", "map -> odom is dated this far ahead");
  field("tf_rate", tf_rate, {20.0, 200.0}, "Hz",
        "map -> odom is repeated at this rate where odometry is slower");
  slew.fields(field);
  field("cloud_rate", cloud_rate, {0.1, 100.0}, "Hz", "of particlecloud, state, markers and path, at most");
  field("max_cloud_poses", max_cloud_poses, {1, 1000000}, "1", "in particlecloud and markers, at most");
  field("path_length", path_length, {0, 1000000}, "1", "poses that path goes back, 0: no path");
  field("path_spacing", path_spacing, {0.0, 1000.0}, "m", "between the poses of path, at least");
}

void LocalizationParameters::fields(ParameterVisitor& field) {
  field("estimator", estimator, {}, "name of the estimator");
  field("seed", seed, {0, std::numeric_limits<int>::max()}, "1",
        "of the random numbers: same seed, same bytes");
  frames.fields(field);
  outputs.fields(field);
  datum.fields(field);
  field("datum_file", datum_file, {},
        "absolute path where the datum is saved once fixes have driven 10 m from it, and read at the next "
        "start; empty: nowhere. Not beside `datum`");
  field("pose_file", pose_file, {},
        "absolute path where the pose is saved every second, and read at the next start, so that a node that "
        "died goes on where it was; empty: nowhere");
  field("pose_file_max_age", pose_file_max_age, {0.0, 1e6}, "s", "an older pose does not count");
  field("max_lag", max_lag, {0.05, 10.0}, "s",
        "messages that have waited longer than this for their turn are not weighed, odometry is summed up "
        "meanwhile");
  field(
      "datum_averaging", datum_averaging, {0.0, 600.0}, "s",
      "without a datum, map's origin is the median of the fixes (of raw epochs the least-squares solutions) "
      "of this time, 0: the first; either begins with three that agree");
  gnss.fields(field);
  field("tilt", tilt,
        "whether roll and pitch of imu/data level antennas and the way driven, where tf has its mounting");
  field.group("odometry", odometry, "how odometry is read");
  field.group("localizer", localizer, "how late and missing measurements are treated");
  refuse_relative("datum_file", datum_file);
  refuse_relative("pose_file", pose_file);
  if (!datum_file.empty() && datum.given())
    throw ParameterError("datum and datum_file are both given: which one counts?");
}

LocalizationSettings LocalizationSettings::from(const YAML::Node& source) {
  LocalizationSettings settings;
  YAML::Node own = source ? YAML::Clone(source) : YAML::Node();
  YAML::Node groups(YAML::NodeType::Map);
  for (const std::string& name : estimator_names()) {
    if (!own.IsMap() || !own[name]) continue;
    groups[name] = own[name];
    own.remove(name);
  }
  load(own, settings.parameters);
  for (const auto& group : groups) {
    const auto name = group.first.as<std::string>();
    try {
      multipath_localization::make_estimator(name, group.second, 0);
    } catch (const ParameterError& error) {
      throw ParameterError(name + ": " + error.what());
    }
  }
  const YAML::Node chosen = groups[settings.parameters.estimator];
  if (chosen) settings.estimator_parameters = chosen;
  static_cast<void>(settings.make_estimator());  // throws where the name is unknown
  return settings;
}

UsedKinds LocalizationSettings::used_kinds() const {
  const std::unique_ptr<Estimator> estimator = make_estimator();
  UsedKinds used{};
  for (std::size_t kind = 0; kind < used.size(); ++kind) used[kind] = estimator->uses(kind);
  return used;
}

std::unique_ptr<Estimator> LocalizationSettings::make_estimator() const {
  return multipath_localization::make_estimator(parameters.estimator, estimator_parameters,
                                                static_cast<std::uint64_t>(parameters.seed));
}

}  // namespace multipath_localization
