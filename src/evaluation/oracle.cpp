#include "evaluation/oracle.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/filters/kalman.hpp"

namespace multipath_localization {

namespace {

/// The state: pose; scale of speed, gyro bias, scale of turns, curvature offset; of a fix the constant, the
/// slow and the biased error.
enum State { kX, kY, kYaw, kScale, kGyro, kTurn, kCurvature, kConstant, kSlow = 9, kBias = 11, kStates = 13 };

using Belief = Gaussian<kStates>;
using Matrix = Eigen::Matrix<double, kStates, kStates>;

constexpr double kShortest = 0.02;        ///< increments are joined to this [s]
constexpr double kUnknownPosition = 1e3;  ///< at the start [m]
constexpr double kKnownHeading = 0.02;    ///< at the start [rad]
constexpr double kStill = 1e-9;           ///< [m/s]
constexpr double kUnseenTurning = 0.05;   ///< change of yaw rate within an increment that nobody sees [rad/s]

double squared(double value) { return value * value; }

std::vector<OdometryIncrement> coarse(const std::vector<OdometryIncrement>& fine) {
  std::vector<OdometryIncrement> all;
  for (const OdometryIncrement& increment : fine) {
    if (!all.empty() && all.back().duration + increment.duration <= kShortest + 1e-9) {
      all.back() = joined(all.back(), increment);
    } else {
      all.push_back(increment);
    }
  }
  return all;
}

class Oracle {
 public:
  explicit Oracle(const RandomDrive& told)
      : odometry_(told.robot.odometry),
        receiver_(told.robot.receiver),
        increments_(coarse(told.without_faults)) {
    const Pose2 start = told.drive.truth.front().base_in_map;
    now_ = told.drive.truth.front().stamp;
    belief_.mean << start.x, start.y, start.yaw, Eigen::Matrix<double, kStates - 3, 1>::Zero();
    belief_.mean[kTurn] = odometry_.turn_scale_mean / (1.0 + odometry_.turn_scale_mean);
    const double scale = std::hypot(odometry_.speed_scale_sigma, odometry_.scale_drift_sigma);
    Eigen::Matrix<double, kStates, 1> sigma;
    sigma << kUnknownPosition, kUnknownPosition, kKnownHeading, scale, odometry_.gyro_bias_sigma,
        odometry_.turn_scale_sigma, odometry_.curvature_offset_sigma, Eigen::Matrix<double, 6, 1>::Zero();
    belief_.covariance = sigma.cwiseAbs2().asDiagonal();
  }

  void advance_to(double stamp) {
    while (now_ < stamp && next_ < increments_.size()) {
      const OdometryIncrement& increment = increments_[next_];
      const double end = std::min(stamp, increment.stamp);
      if (end > now_) move(increment, end - now_);
      now_ = std::max(now_, end);
      if (increment.stamp <= stamp) {
        last_ = increment;
        ++next_;
      }
    }
  }

  void weigh(const GnssFix& fix, const FixTruth& truth) {
    settle(truth, fix.stamp - last_fix_);
    last_fix_ = fix.stamp;
    if (truth.fault == FixFault::kOutlier) return;
    Eigen::Matrix<double, 2, kStates> H = Eigen::Matrix<double, 2, kStates>::Zero();
    for (const State part : {kX, kConstant, kSlow}) H.block<2, 2>(0, part).setIdentity();
    H.block<2, 2>(0, kBias) = truth.bias_part * Eigen::Matrix2d::Identity();
    const double round = squared(truth.extra_white_sigma) + squared(odometry_.tick) / 12.0;
    const Eigen::Matrix2d R = shaped(errors(truth).white_sigma) + round * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d y = fix.position - H * belief_.mean;
    kalman::correct<kStates, 2>(belief_, y, H, R);
    valid_ = true;
  }

  [[nodiscard]] Epoch epoch(const TruthSample& truth) const {
    Epoch epoch;
    epoch.truth = truth;
    epoch.valid = epoch.aligned = valid_;
    epoch.estimate = {belief_.mean[kX], belief_.mean[kY], wrap_angle(belief_.mean[kYaw])};
    epoch.position_covariance = belief_.covariance.topLeftCorner<2, 2>();
    return epoch;
  }

 private:
  [[nodiscard]] const FixErrors& errors(const FixTruth& truth) const { return receiver_.levels[truth.level]; }

  [[nodiscard]] Eigen::Matrix2d shaped(double sigma) const {
    return squared(sigma) * receiver_.shape * receiver_.shape.transpose();
  }

  void move(const OdometryIncrement& u, double duration) {
    const double scale = 1.0 - belief_.mean[kScale];
    const double turn = 1.0 - belief_.mean[kTurn];
    const double v = u.speed * scale;
    const double read = u.yaw_rate - belief_.mean[kGyro] - belief_.mean[kCurvature] * v;
    const double w = read * turn;
    const double middle = belief_.mean[kYaw] + 0.5 * w * duration;
    const Eigen::Vector2d along(std::cos(middle), std::sin(middle));
    const Eigen::Vector2d across(-along.y(), along.x());

    Eigen::Matrix<double, kStates, 1> mean = belief_.mean;
    mean.head<2>() += v * duration * along;
    mean[kYaw] += w * duration;

    Eigen::Matrix<double, 1, kStates> dw = Eigen::Matrix<double, 1, kStates>::Zero();
    dw[kScale] = turn * belief_.mean[kCurvature] * u.speed;
    dw[kGyro] = -turn;
    dw[kTurn] = -read;
    dw[kCurvature] = -turn * v;
    Matrix F = Matrix::Identity();
    F.row(kYaw) += duration * dw;
    F.block<2, kStates>(kX, 0) += 0.5 * v * duration * duration * across * dw;
    F.block<2, 1>(kX, kYaw) += v * duration * across;
    F.block<2, 1>(kX, kScale) -= u.speed * duration * along;
    kalman::predict<kStates>(belief_, mean, F, noise(u, v, duration, along, across));
  }

  [[nodiscard]] Matrix noise(const OdometryIncrement& u, double v, double duration,
                             const Eigen::Vector2d& along, const Eigen::Vector2d& across) const {
    Matrix Q = Matrix::Zero();
    const bool doppler = odometry_.yaw == YawSource::kDoppler;
    const bool rests = odometry_.yaw != YawSource::kGyro && std::abs(u.speed) + std::abs(u.yaw_rate) < kStill;
    const double bend = last_ ? std::abs(u.yaw_rate - last_->yaw_rate) : 0.0;
    double along_variance = squared(odometry_.speed_noise) * std::abs(v) * duration;
    double across_variance =
        rests ? 0.0 : squared(v * u.duration * (bend + kUnseenTurning) / 12.0) * duration * u.duration;
    Q(kYaw, kYaw) = rests ? 0.0 : squared(odometry_.yaw_noise) * duration;
    if (doppler) {
      const double way =
          squared(odometry_.doppler_sigma) * duration * std::max(2.0 * odometry_.doppler_time, u.duration);
      const double speed = std::max(std::abs(v), odometry_.doppler_sigma);
      along_variance += way;
      across_variance += rests ? way : 0.0;
      Q(kYaw, kYaw) += 2.0 * squared(odometry_.doppler_sigma / speed) * duration /
                       std::max(odometry_.doppler_time, u.duration);
    }
    Q.topLeftCorner<2, 2>() =
        along_variance * along * along.transpose() + across_variance * across * across.transpose();
    Q(kScale, kScale) = 2.0 * squared(odometry_.scale_drift_sigma) * duration / odometry_.scale_drift_time;
    Q(kGyro, kGyro) = squared(odometry_.gyro_bias_walk) * duration;
    return Q;
  }

  void settle(const FixTruth& truth, double duration) {
    const FixErrors& law = errors(truth);
    const double kept = std::exp(-duration / law.slow_time);
    Matrix F = Matrix::Identity();
    F.block<2, 2>(kSlow, kSlow) *= kept;
    F.block<2, 2>(kBias, kBias) = rotation(truth.bias_turn);
    Matrix Q = Matrix::Zero();
    Q.block<2, 2>(kSlow, kSlow) = (1.0 - kept * kept) * shaped(law.slow_sigma);
    kalman::predict<kStates>(belief_, F * belief_.mean, F, Q);
    if (truth.new_level) {
      renew(kConstant, 0.5 * squared(law.constant) * Eigen::Matrix2d::Identity());
      renew(kSlow, shaped(law.slow_sigma));
    }
    if (truth.new_bias) renew(kBias, squared(truth.bias_sigma) * Eigen::Matrix2d::Identity());
  }

  /// Forgets an error for another one, of which nothing but its covariance is known.
  void renew(State part, const Eigen::Matrix2d& covariance) {
    belief_.mean.segment<2>(part).setZero();
    belief_.covariance.middleRows<2>(part).setZero();
    belief_.covariance.middleCols<2>(part).setZero();
    belief_.covariance.block<2, 2>(part, part) = covariance;
  }

  const RandomOdometry& odometry_;
  const RandomReceiver& receiver_;
  std::vector<OdometryIncrement> increments_;
  std::size_t next_ = 0;
  std::optional<OdometryIncrement> last_;
  double now_ = 0.0;
  double last_fix_ = 0.0;
  bool valid_ = false;
  Belief belief_;
};

}  // namespace

std::vector<Epoch> run_oracle(const RandomDrive& drive) {
  Oracle oracle(drive);
  std::vector<Epoch> epochs;
  std::size_t next = 0;
  const std::vector<GnssFix> fixes = drive.drive.fixes();
  for (const TruthSample& truth : drive.drive.truth) {
    for (; next < fixes.size() && fixes[next].stamp <= truth.stamp; ++next) {
      oracle.advance_to(fixes[next].stamp);
      oracle.weigh(fixes[next], drive.fix_truths[next]);
    }
    oracle.advance_to(truth.stamp);
    epochs.push_back(oracle.epoch(truth));
  }
  return epochs;
}

}  // namespace multipath_localization
