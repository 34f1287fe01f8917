#include "multipath_localization/localization/last_accepted.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/measurement_kinds.hpp"

namespace multipath_localization {

namespace {

constexpr std::array<const char*, std::variant_size_v<Measurement>> kKinds = {
    "fixes", "pairs of fixes", "pseudoranges", "velocities", "headings"};

}  // namespace

void LastAccepted::note(const Measurement& measurement) {
  if (!tells_position(measurement.index())) return;
  std::optional<double>& last = stamps_[measurement.index()];
  last = std::max(last.value_or(stamp_of(measurement)), stamp_of(measurement));
}

std::size_t LastAccepted::latest() const {
  return static_cast<std::size_t>(std::max_element(stamps_.begin(), stamps_.end()) - stamps_.begin());
}

double LastAccepted::stamp() const {
  return stamps_[latest()].value_or(-std::numeric_limits<double>::infinity());
}

std::string LastAccepted::kind() const { return kKinds[latest()]; }

std::string LastAccepted::missed(double now, double longest) const {
  std::string text;
  for (std::size_t kind = latest() + 1; kind < stamps_.size(); ++kind) {
    const double age = now - stamps_[kind].value_or(now);
    if (age <= longest) continue;
    text += std::string(", no ") + kKinds[kind] + " for " + std::to_string(std::lround(age)) + " s";
  }
  return text;
}

}  // namespace multipath_localization
