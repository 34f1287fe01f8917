#include "multipath_localization/core/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/plain_yaml.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/// The shortest text that YAML reads back as the same number.
std::string text(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0.0 ? ".inf" : "-.inf";
  PlainStream out;
  for (int digits = 6; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    out.str("");
    out.precision(digits);
    out << value;
    if (parse_number(out.str()) == value) break;
  }
  return out.str();
}

/// Quoted where YAML would not read it as that text otherwise.
std::string text(const std::string& value) {
  YAML::Emitter out;
  out << value;
  return out.c_str();
}

std::string interval(Range range) { return text(range.low) + ".." + text(range.high); }

std::string joined(const std::vector<std::string>& choices) {
  std::string all;
  for (const std::string& choice : choices) all += (all.empty() ? "" : " | ") + choice;
  return all;
}

class Loader : public ParameterVisitor {
 public:
  Loader(const YAML::Node& source, std::string path) : source_(source), path_(std::move(path)) {
    if (source_ && !source_.IsNull() && !source_.IsMap()) throw ParameterError(name("") + " is not a map");
  }

  void operator()(const std::string& key, double& value, Range range, std::string_view,
                  std::string_view) override {
    if (const YAML::Node node = find(key)) value = number<double>(node, key, range);
  }

  void operator()(const std::string& key, int& value, Range range, std::string_view,
                  std::string_view) override {
    if (const YAML::Node node = find(key)) value = number<int>(node, key, range);
  }

  void operator()(const std::string& key, bool& value, std::string_view) override {
    if (const YAML::Node node = find(key)) value = scalar<bool>(node, key, "true or false");
  }

  void operator()(const std::string& key, std::string& value, const std::vector<std::string>& choices,
                  std::string_view) override {
    const YAML::Node node = find(key);
    if (!node) return;
    value = scalar<std::string>(node, key, "a text");
    if (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end()) {
      throw ParameterError(name(key) + " is '" + value + "', not one of " + joined(choices));
    }
  }

  void operator()(const std::string& key, std::vector<double>& value, Range range, std::string_view,
                  std::string_view) override {
    const YAML::Node node = find(key);
    if (!node) return;
    if (!node.IsSequence()) throw ParameterError(name(key) + " is not a list of numbers");
    value.clear();
    for (const YAML::Node& item : node) value.push_back(number<double>(item, key, range));
  }

  void finish() const {
    if (!source_ || source_.IsNull()) return;
    std::set<std::string> given;
    for (const auto& entry : source_) {
      const std::string& key = text_of_key(entry.first, name(""));
      if (known_.count(key) == 0) throw ParameterError("unknown parameter " + name(key) + nearest(key));
      if (!given.insert(key).second) throw ParameterError(name(key) + " is given twice");
    }
  }

 protected:
  void visit_group(const std::string& key, std::string_view, const Fields& fields) override {
    const YAML::Node node = find(key);
    load_fields(node ? node : YAML::Node(), fields, name(key));
  }

  void visit_list(const std::string& key, std::string_view, const std::function<void(std::size_t)>& resize,
                  const std::function<std::size_t()>&,
                  const std::function<void(std::size_t, ParameterVisitor&)>& fields) override {
    const YAML::Node node = find(key);
    if (!node) return;
    if (!node.IsSequence()) throw ParameterError(name(key) + " is not a list");
    resize(0);
    resize(node.size());
    for (std::size_t i = 0; i < node.size(); ++i) {
      load_fields(
          node[i], [&](ParameterVisitor& field) { fields(i, field); },
          name(key) + "[" + std::to_string(i) + "]");
    }
  }

 private:
  [[nodiscard]] std::string name(const std::string& key) const {
    return path_.empty() || key.empty() ? path_ + key : path_ + "/" + key;
  }

  /// The entry of that name, or a node that tests false.
  YAML::Node find(const std::string& key) {
    known_.insert(key);
    if (!source_ || source_.IsNull()) return YAML::Node(YAML::NodeType::Undefined);
    return static_cast<const YAML::Node&>(source_)[key];
  }

  template <class T>
  T scalar(const YAML::Node& node, const std::string& key, const std::string& expected) const {
    try {
      if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
        return yaml_number<T>(node);
      } else {
        return node.as<T>();
      }
    } catch (const YAML::Exception&) {
      throw ParameterError(name(key) + " is not " + expected);
    }
  }

  template <class T>
  T number(const YAML::Node& node, const std::string& key, Range range) const {
    const T value = scalar<T>(node, key, std::is_integral_v<T> ? "a whole number" : "a number");
    const auto real = static_cast<double>(value);
    if (!(real >= range.low && real <= range.high)) {
      throw ParameterError(name(key) + " is " + text(real) + ", outside " + interval(range));
    }
    return value;
  }

  [[nodiscard]] std::string nearest(const std::string& key) const {
    const auto best = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
      return edit_distance(key, a) < edit_distance(key, b);
    });
    return best == known_.end() ? "" : "; did you mean " + *best + "?";
  }

  YAML::Node source_;
  std::string path_;
  std::set<std::string> known_;
};

class Describer : public ParameterVisitor {
 public:
  explicit Describer(std::string indent = "") : indent_(std::move(indent)) {}

  void operator()(const std::string& key, double& value, Range range, std::string_view unit,
                  std::string_view meaning) override {
    line(key, text(value), "[" + std::string(unit) + "] " + interval(range), meaning);
  }

  void operator()(const std::string& key, int& value, Range range, std::string_view unit,
                  std::string_view meaning) override {
    line(key, std::to_string(value), "[" + std::string(unit) + "] " + interval(range), meaning);
  }

  void operator()(const std::string& key, bool& value, std::string_view meaning) override {
    line(key, value ? "true" : "false", "true | false", meaning);
  }

  void operator()(const std::string& key, std::string& value, const std::vector<std::string>& choices,
                  std::string_view meaning) override {
    line(key, text(value), choices.empty() ? "text" : joined(choices), meaning);
  }

  void operator()(const std::string& key, std::vector<double>& value, Range range, std::string_view unit,
                  std::string_view meaning) override {
    std::string all;
    for (const double item : value) all += (all.empty() ? "" : ", ") + text(item);
    line(key, "[" + all + "]", "[" + std::string(unit) + "] " + interval(range), meaning);
  }

  [[nodiscard]] std::string take() { return std::move(out_); }

 protected:
  void visit_group(const std::string& key, std::string_view meaning, const Fields& fields) override {
    Describer inner(indent_ + "  ");
    fields(inner);
    out_ += indent_ + key + ":  # " + std::string(meaning) + "\n" + inner.take();
  }

  void visit_list(const std::string& key, std::string_view meaning,
                  const std::function<void(std::size_t)>& resize, const std::function<std::size_t()>& size,
                  const std::function<void(std::size_t, ParameterVisitor&)>& fields) override {
    const std::size_t count = size();
    out_ += indent_ + key + ":" + (count == 0 ? " []" : "") + "  # " + std::string(meaning) + "\n";
    for (std::size_t i = 0; i < count; ++i) out_ += item(indent_, i, fields);
    if (count > 0) return;
    resize(1);  // of the copy that is described: what an item would hold, as a comment
    out_ += item(indent_ + "#", 0, fields);
    resize(0);
  }

 private:
  static std::string item(const std::string& indent, std::size_t i,
                          const std::function<void(std::size_t, ParameterVisitor&)>& fields) {
    Describer inner(indent + "    ");
    fields(i, inner);
    std::string text = inner.take();
    text[indent.size() + 2] = '-';
    return text;
  }

  void line(const std::string& key, const std::string& value, const std::string& allowed,
            std::string_view meaning) {
    out_ += indent_ + key + ": " + value + "  # " + allowed + ": " + std::string(meaning) + "\n";
  }

  std::string indent_;
  std::string out_;
};

}  // namespace

YAML::Node read_yaml(const std::string& file) {
  try {
    return plain(parse_yaml_file(file));
  } catch (const std::exception& error) {
    throw ParameterError(file + ": " + error.what());
  }
}

const std::string& text_of_key(const YAML::Node& key, const std::string& map) {
  if (!key.IsScalar()) throw ParameterError(map + " has a key that is not a text");
  return key.Scalar();
}

void load_fields(const YAML::Node& source, const std::function<void(ParameterVisitor&)>& fields,
                 const std::string& path) {
  Loader loader(source, path);
  fields(loader);
  loader.finish();
}

std::string describe_fields(const std::function<void(ParameterVisitor&)>& fields) {
  Describer describer;
  fields(describer);
  return describer.take();
}

}  // namespace multipath_localization
