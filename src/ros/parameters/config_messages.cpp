#include "ros/parameters/config_messages.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace multipath_localization {

namespace {

constexpr char kGroup[] = "Default";  ///< the one there has to be

/// Visits groups as part of the names in them.
class FlatVisitor : public ParameterVisitor {
 public:
  void operator()(const std::string& /*key*/, std::vector<double>& /*value*/, Range /*range*/,
                  std::string_view /*unit*/, std::string_view /*meaning*/) override {}
  using ParameterVisitor::operator();

 protected:
  [[nodiscard]] std::string name(const std::string& key) const { return path_ + key; }

  void visit_group(const std::string& key, std::string_view /*meaning*/, const Fields& fields) override {
    const std::string outer = path_;
    path_ += key + "/";
    fields(*this);
    path_ = outer;
  }

  void visit_list(const std::string& /*key*/, std::string_view /*meaning*/,
                  const std::function<void(std::size_t)>& /*resize*/,
                  const std::function<std::size_t()>& /*size*/,
                  const std::function<void(std::size_t, ParameterVisitor&)>& /*fields*/) override {}

 private:
  std::string path_;
};

template <class Parameter, class Value>
void put(std::vector<Parameter>& values, const std::string& name, const Value& value) {
  Parameter parameter;
  parameter.name = name;
  parameter.value = value;
  values.push_back(parameter);
}

dynamic_reconfigure::Config empty_config() {
  dynamic_reconfigure::Config config;
  dynamic_reconfigure::GroupState group;
  group.name = kGroup;
  group.state = true;
  config.groups.push_back(group);
  return config;
}

/// The choices in the words that rqt_reconfigure reads them by.
std::string enumeration(const std::vector<std::string>& choices) {
  std::ostringstream text;
  for (const std::string& choice : choices) {
    text << (text.tellp() == 0 ? "{'enum_description': '', 'enum': [" : ", ") << "{'name': '" << choice
         << "', 'value': '" << choice << "', 'type': 'str', 'description': '', 'srcline': 0, 'srcfile': '', "
         << "'ctype': 'std::string', 'cconsttype': 'const char * const'}";
  }
  return choices.empty() ? "" : text.str() + "]}";
}

class Describer : public FlatVisitor {
 public:
  using FlatVisitor::operator();

  void operator()(const std::string& key, double& value, Range range, std::string_view unit,
                  std::string_view meaning) override {
    put(described.min.doubles, name(key), range.low);
    put(described.max.doubles, name(key), range.high);
    put(described.dflt.doubles, name(key), value);
    add(key, "double", with_unit(unit, meaning));
  }

  void operator()(const std::string& key, int& value, Range range, std::string_view unit,
                  std::string_view meaning) override {
    put(described.min.ints, name(key), static_cast<int>(range.low));
    put(described.max.ints, name(key), static_cast<int>(range.high));
    put(described.dflt.ints, name(key), value);
    add(key, "int", with_unit(unit, meaning));
  }

  void operator()(const std::string& key, bool& value, std::string_view meaning) override {
    put(described.min.bools, name(key), false);
    put(described.max.bools, name(key), true);
    put(described.dflt.bools, name(key), value);
    add(key, "bool", std::string(meaning));
  }

  void operator()(const std::string& key, std::string& value, const std::vector<std::string>& choices,
                  std::string_view meaning) override {
    put(described.min.strs, name(key), "");
    put(described.max.strs, name(key), "");
    put(described.dflt.strs, name(key), value);
    add(key, "str", std::string(meaning));
    group.parameters.back().edit_method = enumeration(choices);
  }

  dynamic_reconfigure::ConfigDescription described;
  dynamic_reconfigure::Group group;

 private:
  static std::string with_unit(std::string_view unit, std::string_view meaning) {
    return "[" + std::string(unit) + "] " + std::string(meaning);
  }

  void add(const std::string& key, const char* type, const std::string& description) {
    dynamic_reconfigure::ParamDescription parameter;
    parameter.name = name(key);
    parameter.type = type;
    parameter.description = description;
    group.parameters.push_back(parameter);
  }
};

class Setter : public FlatVisitor {
 public:
  explicit Setter(const dynamic_reconfigure::Config& config) : config_(config) {
    const auto note = [this](const auto& parameters) {
      for (const auto& parameter : parameters) unused_.insert(parameter.name);
    };
    note(config.bools);
    note(config.ints);
    note(config.strs);
    note(config.doubles);
  }

  using FlatVisitor::operator();

  void operator()(const std::string& key, double& value, Range range, std::string_view /*unit*/,
                  std::string_view /*meaning*/) override {
    const auto* given = find(config_.doubles, key);
    if (given == nullptr || std::isnan(given->value)) return;
    value = std::clamp(given->value, range.low, range.high);
    unused_.erase(name(key));
  }

  void operator()(const std::string& key, int& value, Range range, std::string_view /*unit*/,
                  std::string_view /*meaning*/) override {
    const auto* given = find(config_.ints, key);
    if (given == nullptr) return;
    value = std::clamp(given->value, static_cast<int>(range.low), static_cast<int>(range.high));
    unused_.erase(name(key));
  }

  void operator()(const std::string& key, bool& value, std::string_view /*meaning*/) override {
    const auto* given = find(config_.bools, key);
    if (given == nullptr) return;
    value = given->value != 0;
    unused_.erase(name(key));
  }

  void operator()(const std::string& key, std::string& value, const std::vector<std::string>& choices,
                  std::string_view /*meaning*/) override {
    const auto* given = find(config_.strs, key);
    if (given == nullptr) return;
    if (!choices.empty() && std::count(choices.begin(), choices.end(), given->value) == 0) return;
    value = given->value;
    unused_.erase(name(key));
  }

  [[nodiscard]] std::vector<std::string> unused() const { return {unused_.begin(), unused_.end()}; }

 private:
  template <class Parameter>
  const Parameter* find(const std::vector<Parameter>& given, const std::string& key) const {
    const auto found = std::find_if(given.begin(), given.end(),
                                    [full = name(key)](const Parameter& p) { return p.name == full; });
    return found == given.end() ? nullptr : &*found;
  }

  const dynamic_reconfigure::Config& config_;
  std::set<std::string> unused_;
};

Describer described(const VisitParameters& visit) {
  Describer describer;
  describer.described.min = describer.described.max = describer.described.dflt = empty_config();
  describer.group.name = kGroup;
  visit(describer);
  return describer;
}

}  // namespace

dynamic_reconfigure::ConfigDescription to_description(const VisitParameters& visit) {
  Describer describer = described(visit);
  describer.described.groups.push_back(describer.group);
  return describer.described;
}

dynamic_reconfigure::Config to_config(const VisitParameters& visit) {
  return described(visit).described.dflt;
}

std::vector<std::string> set_parameters(const dynamic_reconfigure::Config& config,
                                        const VisitParameters& visit) {
  Setter setter(config);
  visit(setter);
  return setter.unused();
}

}  // namespace multipath_localization
