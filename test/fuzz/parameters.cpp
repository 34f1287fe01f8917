#include "multipath_localization/core/parameters.hpp"

#include <sstream>

#include "evaluation/parameter_overrides.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "oracle.hpp"
#include "ros/localization_node/localization_parameters.hpp"
#include "ros/steering_node/steering_settings.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

/// A metre driven, a fix, a pseudorange that no estimator can use: whatever the parameters, no number is
/// lost.
void check(Estimator& estimator) {
  estimator.start(PosePrior{});
  estimator.predict({1.0, 1.0, 1.0, 0.1});
  estimator.update(GnssFix{1.0, {1.0, 0.5}});
  estimator.update(PseudorangeEpoch{1.0, {SatelliteObservation{}}});
  const PoseEstimate estimate = estimator.estimate();
  if (!estimate.valid) return;
  require_finite(estimate.pose, "the pose");
  require(estimate.covariance.allFinite(), "the covariance is not finite");
}

/// Lines `key=value` for the estimator that the first byte is the number of.
void on_command_line(const std::string& bytes) {
  const std::vector<std::string>& names = estimator_names();
  if (bytes.empty()) return;
  const std::string& name = names[static_cast<unsigned char>(bytes.front()) % names.size()];
  std::vector<std::string> lines;
  std::istringstream rest(bytes.substr(1));
  for (std::string line; std::getline(rest, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  const auto estimator = unless_refused<ParameterError>([&] {
    const ParameterOverrides overrides(lines, names);
    return make_estimator(name, overrides.over(YAML::Node(), name), 1);
  });
  if (estimator) check(**estimator);
}

void in_a_file(const std::string& bytes) {
  const auto source = unless_refused<ParameterError>([&] { return read_yaml(written("node.yaml", bytes)); });
  if (!source) return;
  const auto localization =
      unless_refused<ParameterError>([&] { return LocalizationSettings::from(*source); });
  if (localization) require_described(localization->parameters, "a localisation's parameters");
  const auto steering = unless_refused<ParameterError>([&] { return SteeringSettings::from(*source); });
  if (steering) require_described(steering->parameters, "a steering's parameters");
}

}  // namespace

void parameters(const std::string& bytes) {
  on_command_line(bytes);
  in_a_file(bytes);
}

}  // namespace multipath_localization::fuzz
