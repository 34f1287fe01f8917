#include "multipath_localization/evaluation/stretch_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "multipath_localization/evaluation/metrics.hpp"
#include "multipath_localization/evaluation/odometry_track.hpp"

namespace multipath_localization {

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t kFewestFixes = 20;
constexpr double kShortestWay = 10.0;  // [m]
constexpr double kLongestDelay = 2.0;  // [s]
constexpr int kIterations = 12;
constexpr double kHuber = 1.5;           // residuals beyond this many sigma count linearly
constexpr double kMadToSigma = 1.4826;   // of a normal distribution
constexpr double kRounding = 1e-6;       // of stamps [s]
constexpr double kSmallestSigma = 1e-3;  // of residuals [m]

/// How far from zero the parameters may be: east, north, yaw, scale - 1, gyro bias, delay.
const Vector6d kPriorSigma = (Vector6d() << 1e6, 1e6, 1e3, 0.3, 0.2, 1.0).finished();
/// Steps for the derivatives.
const Vector6d kStep = (Vector6d() << 1e-3, 1e-3, 1e-5, 1e-5, 1e-6, 1e-3).finished();

/// Residuals of the fixes by the six parameters.
class Stretch {
 public:
  Stretch(const std::vector<OdometryIncrement>& increments, const std::vector<GnssFix>& fixes)
      : increments_(increments), fixes_(fixes) {}

  [[nodiscard]] Eigen::VectorXd residuals(const Vector6d& p) const {
    std::vector<OdometryIncrement> corrected = increments_;
    for (OdometryIncrement& increment : corrected) {
      increment.speed *= 1.0 + p[3];
      increment.yaw_rate -= p[4];
    }
    const OdometryTrack track(corrected);
    const Pose2 odom_in_map{p[0], p[1], p[2]};
    Eigen::VectorXd all(2 * fixes_.size());
    for (std::size_t i = 0; i < fixes_.size(); ++i) {
      const Pose2 base = odom_in_map * *track.pose(fixes_[i].stamp - p[5]);
      all.segment<2>(static_cast<Eigen::Index>(2 * i)) =
          fixes_[i].position - base * fixes_[i].antenna_in_base;
    }
    return all;
  }

  /// Turned and moved as a whole on to the fixes (Procrustes in the plane).
  [[nodiscard]] Vector6d start() const {
    const OdometryTrack track(increments_);
    Eigen::Vector2d fix_mean = Eigen::Vector2d::Zero(), base_mean = Eigen::Vector2d::Zero();
    for (const GnssFix& fix : fixes_) {
      fix_mean += fix.position / static_cast<double>(fixes_.size());
      base_mean += track.pose(fix.stamp)->position() / static_cast<double>(fixes_.size());
    }
    double along = 0.0, across = 0.0;
    for (const GnssFix& fix : fixes_) {
      const Eigen::Vector2d a = track.pose(fix.stamp)->position() - base_mean;
      const Eigen::Vector2d b = fix.position - fix_mean;
      along += a.dot(b);
      across += a.x() * b.y() - a.y() * b.x();
    }
    Vector6d p = Vector6d::Zero();
    p[2] = std::atan2(across, along);
    p.head<2>() = fix_mean - rotation(p[2]) * base_mean;
    return p;
  }

 private:
  const std::vector<OdometryIncrement>& increments_;
  const std::vector<GnssFix>& fixes_;
};

double sigma_of(const Eigen::VectorXd& residuals) {
  std::vector<double> lengths;
  for (const double r : residuals) lengths.push_back(std::abs(r));
  return std::max(kMadToSigma * quantile(lengths, 0.5), kSmallestSigma);
}

bool without_gaps(const std::vector<OdometryIncrement>& increments) {
  for (std::size_t i = 1; i < increments.size(); ++i) {
    const double start = increments[i].stamp - increments[i].duration;
    if (std::abs(start - increments[i - 1].stamp) > kRounding) return false;
  }
  return true;
}

struct Solution {
  Vector6d parameters;
  Matrix6d covariance;
};

Solution solve(const Stretch& stretch) {
  Solution solution{stretch.start(), Matrix6d::Identity()};
  Vector6d& p = solution.parameters;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Eigen::VectorXd r = stretch.residuals(p);
    const double sigma = sigma_of(r);
    Eigen::MatrixXd J(r.size(), 6);
    for (Eigen::Index i = 0; i < 6; ++i) {
      Vector6d shifted = p;
      shifted[i] += kStep[i];
      J.col(i) = (stretch.residuals(shifted) - r) / kStep[i];
    }
    const Eigen::ArrayXd w = (kHuber * sigma / r.array().abs().max(1e-9)).min(1.0) / (sigma * sigma);
    const Vector6d prior = kPriorSigma.array().square().inverse();
    const Matrix6d H = J.transpose() * w.matrix().asDiagonal() * J + Matrix6d(prior.asDiagonal());
    const Vector6d g = J.transpose() * (w * r.array()).matrix() + prior.cwiseProduct(p);
    const Eigen::LDLT<Matrix6d> factor(H);
    p -= factor.solve(g);
    p[3] = std::clamp(p[3], -0.9, 9.0);
    p[5] = std::clamp(p[5], -0.9 * kLongestDelay, 0.9 * kLongestDelay);
    solution.covariance = factor.solve(Matrix6d::Identity());
  }
  return solution;
}

}  // namespace

std::optional<StretchFit> fit_stretch(const std::vector<OdometryIncrement>& increments,
                                      const std::vector<GnssFix>& fixes) {
  if (fixes.size() < kFewestFixes || !without_gaps(increments)) return std::nullopt;
  const OdometryTrack track(increments);
  const auto from = track.distance(fixes.front().stamp - kLongestDelay);
  const auto to = track.distance(fixes.back().stamp + kLongestDelay);
  if (!from || !to || *to - *from < kShortestWay) return std::nullopt;

  const Stretch stretch(increments, fixes);
  const Solution solution = solve(stretch);
  StretchFit fit;
  fit.duration = fixes.back().stamp - fixes.front().stamp;
  fit.way = *track.distance(fixes.back().stamp) - *track.distance(fixes.front().stamp);
  fit.scale = 1.0 + solution.parameters[3];
  fit.gyro_bias = solution.parameters[4];
  fit.delay = solution.parameters[5];
  fit.covariance = solution.covariance.bottomRightCorner<3, 3>();
  const Eigen::VectorXd r = stretch.residuals(solution.parameters);
  fit.rms = std::sqrt(r.squaredNorm() / static_cast<double>(r.size()));
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    fit.residuals.push_back({fixes[i].stamp, r.segment<2>(static_cast<Eigen::Index>(2 * i))});
  }
  return fit;
}

}  // namespace multipath_localization
