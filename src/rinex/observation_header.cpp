#include "rinex/observation_header.hpp"

namespace multipath_localization {

namespace {

constexpr char kEverySystem = ' ';  // version 2 has one list

char letter(const LineReader& in) {
  const std::string text = in.text(0, 1);
  return text.empty() ? kEverySystem : text.front();
}

/// The words of a line, each `stride` columns after the one before.
std::vector<std::string> words(const LineReader& in, std::size_t first, std::size_t stride) {
  std::vector<std::string> all;
  for (std::size_t column = first; column < 60; column += stride) {
    const std::string word = in.text(column, stride);
    if (!word.empty() && column + stride <= 60) all.push_back(word);
  }
  return all;
}

}  // namespace

ObservationHeader::ObservationHeader(const FileKind& kind)
    : version_(kind.version),
      version_2_(kind.version_2()),
      time_scale_(kind.system == 'R'   ? TimeScale::kUtc
                  : kind.system == 'C' ? TimeScale::kBeidou
                                       : TimeScale::kGps) {}

void ObservationHeader::read_line(const LineReader& in) {
  if (in.labelled(version_2_ ? "# / TYPES OF OBSERV" : "SYS / # / OBS TYPES")) read_types(in);
  if (in.labelled("SYS / SCALE FACTOR")) read_scale(in);
  if (in.labelled("TIME OF FIRST OBS")) read_time_scale(in);
  if (in.labelled("LEAP SECONDS") && in.text(24, 3) != "BDS") leap_seconds_ = in.integer(0, 6);
}

void ObservationHeader::read_types(const LineReader& in) {
  const bool begins = !(version_2_ ? in.text(0, 6) : in.text(0, 1)).empty();
  if (begins) begin_types(in);
  if (announced_.empty()) throw in.error("a continuation of no types of observations");
  std::vector<std::string>& types = types_[system_];
  for (const std::string& word : words(in, 6, version_2_ ? 6 : 4)) types.push_back(word);
}

void ObservationHeader::begin_types(const LineReader& in) {
  system_ = version_2_ ? kEverySystem : letter(in);
  announced_[system_] = version_2_ ? in.text(0, 6) : in.text(3, 3);
  types_[system_].clear();
}

void ObservationHeader::read_scale(const LineReader& in) {
  const std::vector<std::string> types = words(in, 10, 4);
  if (!in.text(0, 10).empty()) {
    scaled_system_ = letter(in);
    scale_ = in.integer(2, 4);
    if (!(scale_ > 0.0)) throw in.error("a scale factor that is not above 0");
    if (types.empty()) scales_[scaled_system_][""] = scale_;
  }
  if (scale_ == 0.0) throw in.error("a continuation of no scale factor");
  for (const std::string& type : types) scales_[scaled_system_][type] = scale_;
}

void ObservationHeader::read_time_scale(const LineReader& in) {
  const std::string name = in.text(48, 3);
  if (name == "GPS" || name == "GAL" || name == "QZS") time_scale_ = TimeScale::kGps;
  if (name == "GLO" || name == "UTC") time_scale_ = TimeScale::kUtc;
  if (name == "BDT") time_scale_ = TimeScale::kBeidou;
}

std::vector<std::string> ObservationHeader::check(const LineReader& in) const {
  std::vector<std::string> notices;
  bool any = false;
  for (const auto& [system, types] : types_) {
    any = any || !types.empty();
    const std::string& announced = announced_.at(system);
    if (announced == std::to_string(types.size())) continue;
    const std::string of = version_2_ ? "" : std::string(" of ") + system;
    notices.emplace_back(in.error("the header names " + std::to_string(types.size()) +
                                  " types of observations" + of + " where it announces '" + announced +
                                  "': the names count")
                             .what());
  }
  if (!any) throw in.error("the header names no types of observations");
  return notices;
}

const std::vector<std::string>& ObservationHeader::types(char system) const {
  static const std::vector<std::string> kNone;
  const auto found = types_.find(version_2_ ? kEverySystem : system);
  return found == types_.end() ? kNone : found->second;
}

double ObservationHeader::scale(char system, const std::string& type) const {
  const auto scales = scales_.find(system);
  if (scales == scales_.end()) return 1.0;
  for (const std::string& key : {type, std::string()}) {
    const auto scale = scales->second.find(key);
    if (scale != scales->second.end()) return scale->second;
  }
  return 1.0;
}

}  // namespace multipath_localization
