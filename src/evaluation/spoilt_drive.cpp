#include "evaluation/spoilt_drive.hpp"

#include <algorithm>
#include <limits>

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

/// Of the measurements the headings, whose third number they are.
std::vector<RecordedMeasurement> headings_through(SensorFaults faults,
                                                  const std::vector<RecordedMeasurement>& all) {
  std::vector<RecordedMeasurement> out;
  for (RecordedMeasurement recorded : all) {
    if (auto* heading = std::get_if<Heading>(&recorded.measurement)) {
      const auto spoilt = faults.spoil(heading->stamp, {0.0, 0.0, heading->yaw});
      if (!spoilt) continue;
      heading->yaw = wrap_angle(spoilt->value.z());
      recorded.arrival += spoilt->delay;
    }
    out.push_back(recorded);
  }
  sort_by_arrival(out);
  return out;
}

/// Of the measurements the velocities.
std::vector<RecordedMeasurement> through(SensorFaults faults, const std::vector<RecordedMeasurement>& all) {
  std::vector<RecordedMeasurement> out;
  for (RecordedMeasurement recorded : all) {
    if (auto* velocity = std::get_if<GnssVelocity>(&recorded.measurement)) {
      const Eigen::Vector3d told(velocity->velocity.x(), velocity->velocity.y(), 0.0);
      const auto spoilt = faults.spoil(velocity->stamp, told);
      if (!spoilt) continue;
      velocity->velocity = spoilt->value.head<2>();
      recorded.arrival += spoilt->delay;
    }
    out.push_back(recorded);
  }
  sort_by_arrival(out);
  return out;
}

}  // namespace

Drive spoilt(const Drive& drive, const FaultParameters& faults, std::uint64_t seed) {
  Drive result = drive;
  result.odometry = through(OdometryFaults(faults.odometry, seed, drive.start()), drive.odometry);
  result.measurements = through(FixFaults(faults.fix, seed, drive.start()), drive.measurements);
  result.measurements =
      through(SensorFaults(faults.velocity, "velocity", seed, kVelocityFaultStream, drive.start()),
              result.measurements);
  result.measurements = headings_through(
      SensorFaults(faults.heading, "heading", seed, kHeadingFaultStream, drive.start()), result.measurements);
  result.yaw_rates =
      through(SensorFaults(faults.gyro, "gyro", seed, kGyroFaultStream, drive.start()), drive.yaw_rates);
  return result;
}

}  // namespace multipath_localization
