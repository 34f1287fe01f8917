#include "evaluation/suite.hpp"

#include <set>

#include "evaluation/layered_maps.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

void refuse_what_is_no_suite(const YAML::Node& source, const std::string& file) {
  if (!source.IsMap()) throw ParameterError(file + " is not a map");
  for (const auto& entry : source) {
    const std::string& key = text_of_key(entry.first, file);
    if (key != "base" && key != "rows") throw ParameterError("unknown key " + key + " in " + file);
  }
  if (!source["rows"] || !source["rows"].IsMap() || source["rows"].size() == 0) {
    throw ParameterError("rows of " + file + " is not a map of scenarios by name");
  }
}

}  // namespace

std::vector<Scenario> load_suite(const std::string& file) {
  const YAML::Node source = read_yaml(file);
  refuse_what_is_no_suite(source, file);
  std::vector<Scenario> rows;
  std::set<std::string> names;
  for (const auto& row : source["rows"]) {
    const std::string& name = text_of_key(row.first, "rows of " + file);
    const std::string origin = "rows/" + name + " of " + file;
    if (!names.insert(name).second) throw ParameterError(origin + " is there twice");
    if (!row.second.IsMap() && !row.second.IsNull()) throw ParameterError(origin + " is not a map");
    try {
      rows.push_back(parse_scenario(laid_over(source["base"], row.second), name, origin));
    } catch (const ParameterError& error) {
      throw ParameterError(origin + ": " + error.what());
    }
  }
  return rows;
}

}  // namespace multipath_localization
