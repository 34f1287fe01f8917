#include "guidance/json_file.hpp"

#include <fstream>

namespace multipath_localization {

namespace {

constexpr int kDeepest = 64;

}  // namespace

nlohmann::json read_json(const std::string& file) {
  using nlohmann::json;
  std::ifstream in(file);
  if (!in) throw FilePlace{file}.error("cannot be read");
  const auto shallow = [&](int depth, json::parse_event_t /*event*/, json& /*parsed*/) {
    if (depth > kDeepest) throw FilePlace{file}.error("nested over 64 deep");
    return true;
  };
  try {
    return json::parse(in, shallow);
  } catch (const json::exception& error) {
    throw FilePlace{file}.error(error.what());
  }
}

const nlohmann::json& member(const nlohmann::json& object, const std::string& name) {
  static const nlohmann::json nothing;
  const auto found = object.find(name);
  return found == object.end() ? nothing : *found;
}

const nlohmann::json& items(const nlohmann::json& list, const std::string& name, const FilePlace& place) {
  if (!list.is_array()) throw place.error("no list of " + name);
  return list;
}

double number_at(const nlohmann::json& list, std::size_t index, const FilePlace& place) {
  const bool there = list.is_array() && index < list.size() && list[index].is_number();
  if (!there) throw place.error("a coordinate is not a number");
  return list[index].get<double>();
}

}  // namespace multipath_localization
