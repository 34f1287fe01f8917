#pragma once

#include <yaml-cpp/yaml.h>

#include <memory>
#include <string>
#include <vector>

#include "multipath_localization/localization/localizer.hpp"
#include "ros/inputs/frame_parameters.hpp"
#include "ros/inputs/odometry_reader.hpp"
#include "ros/localization_node/correction_slew.hpp"
#include "ros/map/datum_parameter.hpp"
#include "ros/messages/gnss_message.hpp"

namespace multipath_localization {

/// What leaves the node, and how often.
struct OutputParameters {
  bool publish_tf = true;
  bool publish_odom_tf = false;
  double transform_tolerance = 0.1;
  double tf_rate = 30.0;
  SlewParameters slew;
  double cloud_rate = 5.0;
  int max_cloud_poses = 500;
  int path_length = 0;
  double path_spacing = 0.5;

  void fields(ParameterVisitor& field);
};

/// Parameters of localization_node beside those of the estimators.
struct LocalizationParameters {
  std::string estimator = "multipath_particle_filter";
  int seed = 1;
  FrameParameters frames;
  OutputParameters outputs;
  DatumParameter datum;
  std::string datum_file;
  std::string pose_file;
  double pose_file_max_age = 60.0;
  double max_lag = 0.3;
  double datum_averaging = 0.0;
  GnssParameters gnss;
  bool tilt = true;
  OdometryParameters odometry;
  LocalizerParameters localizer;

  /// Throws ParameterError on a datum that cannot be used, on a file that is no absolute path, and on both a
  /// datum and a file for it.
  void fields(ParameterVisitor& field);
};

/// All that a node was started with. Throws ParameterError on anything unknown or unusable.
struct LocalizationSettings {
  LocalizationParameters parameters;
  YAML::Node estimator_parameters;  ///< of the chosen estimator, checked

  /// `source` holds LocalizationParameters and one group for each estimator, named as it is.
  static LocalizationSettings from(const YAML::Node& source);

  [[nodiscard]] std::unique_ptr<Estimator> make_estimator() const;

  /// Whether the estimator has a model for each kind of GnssMessage.
  [[nodiscard]] UsedKinds used_kinds() const;
};

}  // namespace multipath_localization
