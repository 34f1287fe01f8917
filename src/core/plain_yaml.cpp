#include "core/plain_yaml.hpp"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kMost = 50000;

[[noreturn]] void refuse_depth() { throw ParameterError("YAML is nested over 64 deep, or within itself"); }

bool holds_others(const YAML::Node& node) { return node.IsMap() || node.IsSequence(); }

/// Counts what a copy would hold, which is quick where to copy is not.
class Census {
 public:
  void take(const YAML::Node& source) {
    add(source, 0);
    while (!to_do_.empty()) {
      const auto [node, depth] = to_do_.back();
      to_do_.pop_back();
      for (const auto& item : node) {
        if (node.IsSequence()) {
          add(item, depth + 1);
        } else {
          add(item.first, depth + 1);
          add(item.second, depth + 1);
        }
      }
    }
  }

 private:
  void add(const YAML::Node& node, int depth) {
    if (depth > kDeepest) refuse_depth();
    if (++counted_ > kMost) throw ParameterError("YAML holds over 50000 values, those of aliases counted");
    if (holds_others(node)) to_do_.emplace_back(node, depth);
  }

  std::vector<std::pair<YAML::Node, int>> to_do_;
  std::size_t counted_ = 0;
};

/// Copies what a census has found to be little enough.
class Copier {
 public:
  YAML::Node copy(const YAML::Node& source) {
    const YAML::Node result = begun(source);
    while (!to_do_.empty()) {
      auto [from, to] = to_do_.back();
      to_do_.pop_back();
      for (const auto& item : from) {
        if (from.IsSequence()) {
          to.push_back(begun(item));
        } else {
          to.force_insert(YAML::Clone(item.first), begun(item.second));
        }
      }
    }
    return result;
  }

 private:
  /// Maps and lists are empty as yet.
  YAML::Node begun(const YAML::Node& source) {
    if (!holds_others(source)) return YAML::Clone(source);
    const YAML::Node copy(source.Type());
    to_do_.emplace_back(source, copy);
    return copy;
  }

  std::vector<std::pair<YAML::Node, YAML::Node>> to_do_;
};

/// Follows the parser down, which calls itself for each level, and stops it in time.
class DepthWatch : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    descend();
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    descend();
  }
  void OnMapEnd() override { --depth_; }

 private:
  void descend() {
    if (depth_++ == kDeepest) refuse_depth();
  }

  int depth_ = 0;
};

}  // namespace

YAML::Node plain(const YAML::Node& source) {
  Census().take(source);
  return Copier().copy(source);
}

YAML::Node parse_yaml(const std::string& text) {
  // Anywhere, even where quotes or a comment make it harmless: to tell would take a scanner of our own.
  const std::size_t endless = text.find(":]");
  if (endless != std::string::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(endless), '\n');
    throw ParameterError("line " + std::to_string(line) +
                         ": a colon right before a bracket, ':]': write ': ]'");
  }
  const bool open_end = text.empty() || text.back() != '\n';
  const std::string ended = open_end ? text + '\n' : text;
  std::istringstream in(ended);
  DepthWatch watch;
  YAML::Parser(in).HandleNextDocument(watch);
  return YAML::Load(ended);
}

YAML::Node parse_yaml_file(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw ParameterError("cannot be read");
  return parse_yaml({std::istreambuf_iterator<char>(in), {}});
}

template <class Number>
Number yaml_number(const YAML::Node& node) {
  // What is named by letters, .inf and .nan, yaml-cpp compares by itself.
  if (!node.IsScalar() || node.Scalar().find_first_of("nN") != std::string::npos) return node.as<Number>();
  std::istringstream in(node.Scalar());
  in.imbue(std::locale::classic());
  in.unsetf(std::ios::dec);  // 0x10 is 16, as for yaml-cpp
  Number value{};
  if (!(in >> std::noskipws >> value) || !(in >> std::ws).eof()) {
    throw YAML::TypedBadConversion<Number>(node.Mark());
  }
  return value;
}

template double yaml_number<double>(const YAML::Node& node);
template int yaml_number<int>(const YAML::Node& node);

std::vector<double> yaml_numbers(const YAML::Node& list) {
  if (!list.IsSequence()) throw YAML::TypedBadConversion<std::vector<double>>(list.Mark());
  std::vector<double> all;
  for (const YAML::Node& item : list) all.push_back(yaml_number<double>(item));
  return all;
}

}  // namespace multipath_localization
