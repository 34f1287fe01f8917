#include "rinex/satellite_record.hpp"

#include <algorithm>

#include "rinex/observation_codes.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kNumber = 14;
constexpr std::size_t kDecimals = 3;

/// The signal of a code under another first letter: "C1C" to "D1C", "P1" to "D1".
std::string same_signal(char letter, const std::string& code) { return letter + code.substr(1); }

/// The middle of what a digit of signal strength stands for [dB-Hz].
double cn0_of_digit(char digit) { return 6.0 * (digit - '0') + 2.5; }

/// Of a line that ends within the cell: a number that may lack digits.
bool cut_off(std::string_view cell) {
  if (cell.size() >= kNumber || cell.find_first_not_of(' ') == std::string_view::npos) return false;
  const std::size_t point = cell.find('.');
  return point == std::string_view::npos || cell.size() - point - 1 < kDecimals;
}

}  // namespace

std::optional<RawObservation> SatelliteRecord::observation(const SatelliteId& satellite) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& code : pseudorange_codes(satellite.constellation, header_.version())) {
    const std::optional<double> pseudorange = number(code);
    if (!pseudorange) continue;
    RawObservation taken;
    taken.satellite = satellite;
    taken.pseudorange = *pseudorange;
    taken.doppler = number(same_signal('D', code)).value_or(kNone);
    const auto by_digit = strength(code) ? strength(code) : strength(same_signal('L', code));
    taken.cn0 = number(same_signal('S', code)).value_or(by_digit.value_or(kNone));
    taken.b1c = satellite.constellation == Constellation::kBeidou && on_b1c(code, header_.version());
    return taken;
  }
  return std::nullopt;
}

std::vector<std::string> SatelliteRecord::pseudoranges() const {
  std::vector<std::string> all;
  for (const std::string& type : header_.types(system_)) {
    const bool pseudorange = type.front() == 'C' || type.front() == 'P';
    if (pseudorange && cell(type).find_first_not_of(' ') != std::string_view::npos) all.push_back(type);
  }
  return all;
}

std::string_view SatelliteRecord::cell(const std::string& type) const {
  const std::vector<std::string>& types = header_.types(system_);
  const auto place = static_cast<std::size_t>(std::find(types.begin(), types.end(), type) - types.begin());
  if (place == types.size() || place * kCell >= text_.size()) return {};
  return text_.substr(place * kCell, kCell);
}

/// Nothing where it is blank or 0, which are the two ways to say that there is none.
std::optional<double> SatelliteRecord::number(const std::string& type) const {
  const std::string_view its = cell(type);
  if (cut_off(its)) throw in_.error("'" + std::string(its) + "' is cut off");
  const std::optional<double> printed = in_.number(its.substr(0, kNumber));
  if (!printed || *printed == 0.0) return std::nullopt;
  return *printed / header_.scale(system_, type);
}

std::optional<double> SatelliteRecord::strength(const std::string& type) const {
  const std::string_view its = cell(type);
  if (its.size() < kCell || its.back() < '1' || its.back() > '9') return std::nullopt;
  return cn0_of_digit(its.back());
}

}  // namespace multipath_localization
