#include "evaluation/spoilt_drive.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "multipath_localization/core/angle.hpp"
#include "simulation/streams.hpp"

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
  sort_by_arrival(out);
  return out;
}

std::vector<RecordedYawRate> through(SensorFaults faults, const std::vector<RecordedYawRate>& all) {
  std::vector<RecordedYawRate> out;
  for (const auto& [yaw_rate, arrival] : all) {
    const auto spoilt = faults.spoil(yaw_rate.stamp, {0.0, 0.0, yaw_rate.rate});
    if (spoilt) out.push_back({{yaw_rate.stamp, spoilt->value.z()}, arrival + spoilt->delay});
  }
  sort_by_arrival(out);
  return out;
}

/// Of the measurements those of one kind, which are told as `read` gives them; `write` puts back what became
/// of that.
template <class Kind, class Read, class Write>
std::vector<RecordedMeasurement> through(SensorFaults faults, const std::vector<RecordedMeasurement>& all,
                                         Read read, Write write) {
  std::vector<RecordedMeasurement> out;
  for (RecordedMeasurement recorded : all) {
    if (auto* told = std::get_if<Kind>(&recorded.measurement)) {
      const auto spoilt = faults.spoil(told->stamp, read(*told));
      if (!spoilt) continue;
      write(*told, spoilt->value);
      recorded.arrival += spoilt->delay;
    }
    out.push_back(recorded);
  }
  sort_by_arrival(out);
  return out;
}

std::vector<RecordedMeasurement> velocities_through(SensorFaults faults,
                                                    const std::vector<RecordedMeasurement>& all) {
  return through<GnssVelocity>(
      std::move(faults), all,
      [](const GnssVelocity& told) { return Eigen::Vector3d(told.velocity.x(), told.velocity.y(), 0.0); },
      [](GnssVelocity& told, const Eigen::Vector3d& value) { told.velocity = value.head<2>(); });
}

std::vector<RecordedMeasurement> headings_through(SensorFaults faults,
                                                  const std::vector<RecordedMeasurement>& all) {
  return through<Heading>(
      std::move(faults), all, [](const Heading& told) { return Eigen::Vector3d(0.0, 0.0, told.yaw); },
      [](Heading& told, const Eigen::Vector3d& value) { told.yaw = wrap_angle(value.z()); });
}

}  // namespace

Drive spoilt(const Drive& drive, const FaultParameters& faults, std::uint64_t seed) {
  Drive result = drive;
  result.odometry = through(OdometryFaults(faults.odometry, seed, drive.start()), drive.odometry);
  result.measurements = through(FixFaults(faults.fix, seed, drive.start()), drive.measurements);
  result.measurements =
      velocities_through(SensorFaults(faults.velocity, "velocity", seed, kVelocityFaultStream, drive.start()),
                         result.measurements);
  result.measurements = headings_through(
      SensorFaults(faults.heading, "heading", seed, kHeadingFaultStream, drive.start()), result.measurements);
  result.yaw_rates =
      through(SensorFaults(faults.gyro, "gyro", seed, kGyroFaultStream, drive.start()), drive.yaw_rates);
  return result;
}

}  // namespace multipath_localization
