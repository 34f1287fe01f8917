#include "evaluation/doppler_odometry.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"
#include "multipath_localization/core/twist_sample.hpp"
#include "multipath_localization/models/pseudorange/doppler_velocity.hpp"
#include "multipath_localization/models/pseudorange/robust_position.hpp"

namespace multipath_localization {

namespace {

constexpr double kLeastStandstill = 0.1;  // below it a velocity is none [m/s]
constexpr double kMostStandstill = 1.5;   // above it it is one, however uncertain [m/s]
constexpr double kStandstillSigmas = 5.0;
constexpr double kSlow = 0.5;            // slower, the course is noise [m/s]
constexpr double kFastestReverse = 4.0;  // [m/s]

bool standing(const VelocitySample& sample) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(sample.covariance, Eigen::EigenvaluesOnly);
  const double sigma = std::sqrt(std::max(axes.eigenvalues().maxCoeff(), 0.0));
  return sample.velocity.norm() < std::clamp(kStandstillSigmas * sigma, kLeastStandstill, kMostStandstill);
}

/// Speed and heading of a robot that follows the velocity.
struct Track {
  double speed = 0.0;  ///< negative in reverse [m/s]
  double heading = 0.0;
  bool started = false;

  void follow(const VelocitySample& sample) {
    speed = 0.0;
    if (standing(sample)) return;
    double course = std::atan2(sample.velocity.y(), sample.velocity.x());
    speed = sample.velocity.norm();
    if (started && speed < kSlow) {
      speed = sample.velocity.dot(Eigen::Vector2d(std::cos(heading), std::sin(heading)));
      return;
    }
    if (started && speed < kFastestReverse && std::abs(angle_difference(course, heading)) > kPi / 2.0) {
      course = wrap_angle(course + kPi);
      speed = -speed;
    }
    heading = course;
    started = true;
  }
};

}  // namespace

DopplerTrack doppler_track(const std::vector<PseudorangeEpoch>& epochs) {
  DopplerTrack track;
  Eigen::Vector3d antenna = Eigen::Vector3d::Zero();
  double measured = 0.0;
  for (const PseudorangeEpoch& epoch : epochs) {
    const auto position = robust_position(epoch.observations, antenna);
    if (position) antenna = position->position;
    const auto doppler = doppler_velocity(epoch.observations, antenna);
    if (doppler) {
      measured = epoch.stamp;
      track.samples.push_back(
          {epoch.stamp, doppler->velocity.head<2>(), doppler->covariance.topLeftCorner<2, 2>()});
    } else if (!track.samples.empty()) {
      track.samples.push_back(track.samples.back());
      track.samples.back().stamp = epoch.stamp;
      ++track.held;
      track.longest_hold = std::max(track.longest_hold, epoch.stamp - measured);
    }
  }
  return track;
}

std::vector<OdometryIncrement> odometry_of(const std::vector<VelocitySample>& samples) {
  std::vector<OdometryIncrement> all;
  Track track;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Track before = track;
    track.follow(samples[i]);
    if (i == 0) {
      all.push_back({samples[i].stamp, kFirstInterval, track.speed, 0.0, 0.0, true});
      continue;
    }
    const double duration = samples[i].stamp - samples[i - 1].stamp;
    const double turn = before.started ? angle_difference(track.heading, before.heading) : 0.0;
    all.push_back(
        {samples[i].stamp, duration, 0.5 * (before.speed + track.speed), turn / duration, 0.0, true});
  }
  return all;
}

}  // namespace multipath_localization
