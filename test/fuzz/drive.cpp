#include "evaluation/drive.hpp"

#include <filesystem>

#include "oracle.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

namespace fs = std::filesystem;

/// The files of a drive one after the other, each below a line `== NAME`. Returns their folder.
std::string unpacked(const std::string& bytes) {
  static const TemporaryFolder folder;
  for (const auto& old : fs::directory_iterator(folder.path())) fs::remove(old);
  for (const std::string name : {"fix.csv", "odometry.csv", "pseudoranges.csv", "truth.csv", "gyro.csv",
                                 "velocity.csv", "heading.csv"}) {
    const std::string title = "== " + name + "\n";
    const std::size_t begin = bytes.find(title);
    if (begin == std::string::npos) continue;
    const std::size_t from = begin + title.size();
    const std::size_t end = bytes.find("== ", from);
    folder.write(name, bytes.substr(from, end == std::string::npos ? end : end - from));
  }
  return folder.path();
}

void check(const GnssFix& fix) {
  require_finite(fix.stamp, "a fix's stamp");
  require(fix.position.allFinite() && fix.covariance.allFinite(), "a fix is not finite");
}

void check(const DualAntennaFix& fixes) {
  check(fixes.left);
  check(fixes.right);
}

void check(const PseudorangeEpoch& epoch) {
  require(!epoch.observations.empty(), "an epoch without satellites");
  for (const SatelliteObservation& observation : epoch.observations) {
    require(static_cast<std::size_t>(observation.constellation) < kConstellations, "no constellation");
    require(observation.position.allFinite(), "a satellite's place is not finite");
    require_finite(observation.pseudorange + observation.elevation, "a pseudorange or elevation");
    require(std::isfinite(observation.sigma) && observation.sigma > 0.0, "a sigma is not above 0");
    require(!std::isinf(observation.range_rate) && !std::isinf(observation.cn0), "an infinity");
    require(std::isnan(observation.range_rate) || observation.has_doppler(), "a range rate without velocity");
  }
}

void check(const GnssVelocity& velocity) {
  require_finite(velocity.stamp, "a velocity's stamp");
  require(velocity.velocity.allFinite() && velocity.covariance.allFinite(), "a velocity is not finite");
}

void check(const Heading& heading) {
  require_finite(heading.stamp + heading.yaw + heading.variance + heading.turn, "a heading");
}

void check(const Drive& drive) {
  require(valid(drive.datum), "the datum is no place");
  for (std::size_t i = 0; i < drive.odometry.size(); ++i) {
    const OdometryIncrement& u = drive.odometry[i];
    require_finite(u.stamp + u.speed + u.yaw_rate, "odometry");
    require(std::isfinite(u.duration) && u.duration > 0.0, "the duration of odometry is not above 0");
    require(i == 0 || u.stamp > drive.odometry[i - 1].stamp, "odometry out of order");
  }
  for (std::size_t i = 0; i < drive.measurements.size(); ++i) {
    require_finite(drive.measurements[i].arrival, "an arrival");
    require(i == 0 || drive.measurements[i].arrival >= drive.measurements[i - 1].arrival, "out of order");
    std::visit([](const auto& measurement) { check(measurement); }, drive.measurements[i].measurement);
  }
  for (const RecordedYawRate& recorded : drive.yaw_rates)
    require_finite(recorded.arrival, "a yaw rate's arrival");
  for (const TruthSample& sample : drive.truth) require_finite(sample.base_in_map, "the truth");
  require_finite(drive.start(), "the start");
}

}  // namespace

void drive(const std::string& bytes) {
  const std::string folder = unpacked(bytes);
  const auto read = unless_refused<DriveError>([&] { return read_drive(folder); });
  if (read) check(*read);
}

}  // namespace multipath_localization::fuzz
