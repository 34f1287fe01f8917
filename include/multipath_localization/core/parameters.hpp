#pragma once

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace multipath_localization {

/// A parameter that cannot be used: unknown, of the wrong type or out of range. The text names its key.
class ParameterError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Closed interval a number has to lie in.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// Visits the parameters of a struct. Each struct names its parameters once, in
/// `void fields(ParameterVisitor& field)`: key, member (holding the default), range, unit, meaning.
/// Loading, refusal of unknown keys and the commented YAML all come from that one line.
class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;

  virtual void operator()(const std::string& key, double& value, Range range, std::string_view unit,
                          std::string_view meaning) = 0;
  virtual void operator()(const std::string& key, int& value, Range range, std::string_view unit,
                          std::string_view meaning) = 0;
  virtual void operator()(const std::string& key, bool& value, std::string_view meaning) = 0;
  /// Free text when `choices` is empty, else one of them.
  virtual void operator()(const std::string& key, std::string& value, const std::vector<std::string>& choices,
                          std::string_view meaning) = 0;
  virtual void operator()(const std::string& key, std::vector<double>& value, Range range,
                          std::string_view unit, std::string_view meaning) = 0;

  /// One of a few named options: `names` are those of the enumerators, which count from 0.
  template <class Option, class = std::enable_if_t<std::is_enum_v<Option>>>
  void operator()(const std::string& key, Option& value, const std::vector<std::string>& names,
                  std::string_view meaning) {
    std::string name = names.at(static_cast<std::size_t>(value));
    (*this)(key, name, names, meaning);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) value = static_cast<Option>(found - names.begin());
  }

  /// A nested struct with fields of its own.
  template <class Group>
  void group(const std::string& key, Group& value, std::string_view meaning) {
    visit_group(key, meaning, [&value](ParameterVisitor& field) { value.fields(field); });
  }

  /// A list of nested structs.
  template <class Item>
  void list(const std::string& key, std::vector<Item>& items, std::string_view meaning) {
    visit_list(
        key, meaning, [&items](std::size_t size) { items.resize(size); }, [&items] { return items.size(); },
        [&items](std::size_t i, ParameterVisitor& field) { items[i].fields(field); });
  }

 protected:
  using Fields = std::function<void(ParameterVisitor&)>;
  virtual void visit_group(const std::string& key, std::string_view meaning, const Fields& fields) = 0;
  virtual void visit_list(const std::string& key, std::string_view meaning,
                          const std::function<void(std::size_t)>& resize,
                          const std::function<std::size_t()>& size,
                          const std::function<void(std::size_t, ParameterVisitor&)>& fields) = 0;
};

/// Overwrites fields by the entries of `source` (a YAML map, or null for none). Throws ParameterError on an
/// unknown key (naming the nearest known one), a wrong type or a value out of range; `value` is then
/// unspecified.
template <class Parameters>
void load(const YAML::Node& source, Parameters& value, const std::string& path = "");

/// The same for a file. Throws ParameterError when it cannot be read.
YAML::Node read_yaml(const std::string& file);

/// The key of an entry of a map. Throws ParameterError, naming `map`, on one that is not a text.
const std::string& text_of_key(const YAML::Node& key, const std::string& map);

/// The parameters as YAML, each with a comment `[unit] low..high: meaning`; below an empty list, commented
/// out, what an item of it holds.
template <class Parameters>
std::string describe(Parameters value);

/// `load` and `describe` of a fields() function; the templates above call these.
void load_fields(const YAML::Node& source, const std::function<void(ParameterVisitor&)>& fields,
                 const std::string& path);
std::string describe_fields(const std::function<void(ParameterVisitor&)>& fields);

template <class Parameters>
void load(const YAML::Node& source, Parameters& value, const std::string& path) {
  load_fields(
      source, [&value](ParameterVisitor& field) { value.fields(field); }, path);
}

template <class Parameters>
std::string describe(Parameters value) {
  return describe_fields([&value](ParameterVisitor& field) { value.fields(field); });
}

}  // namespace multipath_localization
