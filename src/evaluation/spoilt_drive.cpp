#include "multipath_localization/evaluation/spoilt_drive.hpp"

#include <algorithm>
#include <limits>

namespace multipath_localization {

namespace {

std::vector<OdometryIncrement> through(OdometryFaults faults, const std::vector<OdometryIncrement>& all) {
  std::vector<OdometryIncrement> out;
  for (const OdometryIncrement& increment : all) {
    if (const auto spoilt = faults.spoil(increment)) out.push_back(*spoilt);
  }
  return out;
}

std::vector<RecordedMeasurement> through(FixFaults faults, const std::vector<RecordedMeasurement>& all) {
  std::vector<RecordedMeasurement> out;
  const auto release = [&](double now) {
    for (const SpoiltFix& spoilt : faults.release(now)) {
      if (faults.status(spoilt.fix.stamp).value_or(0) >= 0) out.push_back({spoilt.fix, spoilt.arrival});
    }
  };
  for (const RecordedMeasurement& recorded : all) {
    if (const auto* fix = std::get_if<GnssFix>(&recorded.measurement)) {
      faults.take(*fix, recorded.arrival);
      release(recorded.arrival);
    } else {
      out.push_back(recorded);
    }
  }
  release(std::numeric_limits<double>::max());
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return a.arrival < b.arrival; });
  return out;
}

}  // namespace

Drive spoilt(const Drive& drive, const FaultParameters& faults, std::uint64_t seed) {
  Drive result = drive;
  result.odometry = through(OdometryFaults(faults.odometry, seed, drive.start()), drive.odometry);
  result.measurements = through(FixFaults(faults.fix, seed, drive.start()), drive.measurements);
  return result;
}

}  // namespace multipath_localization
