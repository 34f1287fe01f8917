#include "evaluation/scenario.hpp"

#include <cmath>
#include <filesystem>
#include <set>

#include "core/plain_yaml.hpp"
#include "multipath_localization/guidance/waypoint_file.hpp"

namespace multipath_localization {

namespace {

const std::set<std::string> kKeys = {"simulator",    "steering", "steered_on",
                                     "localization", "sequence", "duration"};

double seconds(const YAML::Node& source, const std::string& path) {
  try {
    const auto value = yaml_number<double>(source);
    if (std::isfinite(value) && value > 0.0) return value;
  } catch (const YAML::Exception&) {
  }
  throw ParameterError(path + " is not a number of seconds above 0");
}

bool is_truth(const YAML::Node& source) {
  const std::string text = source.IsScalar() ? source.Scalar() : "";
  if (text != "truth" && text != "estimate") {
    throw ParameterError("steered_on is neither truth nor estimate");
  }
  return text == "truth";
}

void refuse_unknown(const YAML::Node& source, const std::string& origin) {
  if (!source.IsMap()) throw ParameterError(origin + " is not a map");
  for (const auto& entry : source) {
    const std::string& key = text_of_key(entry.first, origin);
    if (kKeys.count(key) == 0) throw ParameterError("unknown key " + key + " in " + origin);
  }
}

}  // namespace

void SequenceLeg::fields(ParameterVisitor& field) {
  field("duration", duration, {0.0, 1e9}, "s", "of the leg");
  field("speed", speed, {-100.0, 100.0}, "m/s", "forwards");
  field("yaw_rate", yaw_rate, {-10.0, 10.0}, "rad/s", "counter-clockwise");
}

MotionCommand command_at(const std::vector<SequenceLeg>& sequence, double time, double wheelbase) {
  double end = -1e-9;  // a step of the simulator past its start belongs to the leg that begins there
  for (const SequenceLeg& leg : sequence) {
    end += leg.duration;
    if (time < end) return motion_command(leg.speed, leg.yaw_rate, wheelbase);
  }
  return {};
}

Scenario load_scenario(const std::string& file) {
  return parse_scenario(read_yaml(file), std::filesystem::path(file).stem().string(), file);
}

Scenario parse_scenario(const YAML::Node& source, const std::string& name, const std::string& origin) {
  refuse_unknown(source, origin);
  Scenario scenario;
  scenario.name = name;
  load(source["simulator"], scenario.simulator, "simulator");
  YAML::Node steering;
  if (source["steering"]) steering = YAML::Clone(source["steering"]);
  if (steering.IsMap() && steering["waypoints"]) {
    scenario.waypoints = load_points(steering["waypoints"], "steering/waypoints");
    steering.remove("waypoints");
  }
  WaypointFollowerParameters::refuse_former(steering, "steering/");
  load(steering, scenario.steering, "steering");
  if (scenario.steering.limits.differential()) {
    throw ParameterError("steering/base is differential, but simulated robots do not turn on the spot");
  }
  if (source["sequence"]) {
    YAML::Node sequence;
    sequence["sequence"] = source["sequence"];
    const auto fields = [&](ParameterVisitor& field) {
      field.list("sequence", scenario.sequence, "commands in turn, instead of steering");
    };
    load_fields(sequence, fields, "");
  }
  if (source["duration"]) scenario.duration = seconds(source["duration"], "duration");
  if (source["steered_on"]) scenario.steered_on_truth = is_truth(source["steered_on"]);
  if (source["localization"]) scenario.localization = source["localization"];
  return scenario;
}

}  // namespace multipath_localization
