#include <algorithm>
#include <cmath>

#include "multipath_localization/core/numbers.hpp"
#include "multipath_localization/estimators/multipath_particle_filter.hpp"

/// When the filter doubts its odometry, its pose, and a bias.
namespace multipath_localization {

namespace {

constexpr double kSuspicion = 10.0;  ///< wheels that stand after a jump may be locked this long [s]
constexpr double kSlipRatioSquared = 1.0 / 3.0;  ///< of a slip by any part of the speed, on average
constexpr double kSettledProbability = 0.95;     ///< of the canyon, and of one cluster in it
constexpr double kMajority = 0.5;                ///< probability above which something is taken for so
constexpr double kSettledYawSigma = 0.35;        ///< of a heading that is known [rad]

}  // namespace

template <class Property>
double MultipathParticleFilter::probability(Property property) const {
  double sum = 0.0;
  for (const BeliefParticle& particle : particles_) {
    if (property(particle)) sum += particle.weight;
  }
  return sum;
}

bool MultipathParticleFilter::suspect_wheels(double duration) {
  const bool jump = odometry_jump_.take();
  const double believed = probability([](const BeliefParticle& particle) {
    return particle.mode.slipping || particle.receiver == kWheelFault;
  });
  if (believed < kMajority) suspected_for_ = std::max(0.0, suspected_for_ - duration);
  if (jump) suspected_for_ = kSuspicion;
  return jump;
}

void MultipathParticleFilter::doubt_odometry() {
  if (suspect_wheels(0.0)) {
    change_classes(0.0, true);
    ++step_;
  }
  const double unseen = unseen_variance();
  const double slip_time_squared = 2.0 / square(parameters_.slip_end_rate);  // exponential durations
  const double way =
      odometry_.displacement(cluster_.belief.mean(kScale), cluster_.belief.mean(kGyroBias)).norm();
  const double slip = kSlipRatioSquared * slip_time_squared * square(way) / odometry_.duration();
  for (BeliefParticle& particle : particles_) {
    const ReceiverClass& receiver = parameters_.classes[particle.receiver];
    const double yaw = particle.belief.mean(kYaw);
    const Eigen::Vector2d along(std::cos(yaw), std::sin(yaw));
    particle.belief.covariance.topLeftCorner<2, 2>() +=
        square(receiver.unseen_motion) * unseen * Eigen::Matrix2d::Identity() +
        receiver.slip_rate * slip * along * along.transpose();
  }
  doubted_until_ = now_;
}

double MultipathParticleFilter::unseen_variance() const {
  return square(usual_speed_) * (square(now_ - last_fix_) - square(doubted_until_ - last_fix_));
}

/// The bias of the dominant cluster where no street has one as large: it is rather the pose that is wrong.
double MultipathParticleFilter::doubtful_bias() const {
  const double bias = cluster_.belief.mean.tail<2>().norm();
  const bool doubtful = bias > parameters_.largest_bias && class_probability_[kCanyon] < kMajority;
  return doubtful ? bias : 0.0;
}

/// Whether the pose may be anywhere, outside a canyon, where that is usual.
bool MultipathParticleFilter::scattered() const {
  const double variance = cluster_.overall_position_covariance.trace();
  return variance > square(parameters_.doubtful_sigma) && class_probability_[kCanyon] < kMajority;
}

/// The pose is to be found and confirmed anew.
void MultipathParticleFilter::unconfirm() {
  confirmed_ = false;
  confirmed_over_ = settled_over_ = 0.0;
}

void MultipathParticleFilter::update_confirmation() {
  if (class_probability_[kWheelFault] > kMajority) {
    alignment_.clear();
    return unconfirm();
  }
  if (doubtful_bias() > 0.0 || scattered()) return unconfirm();
  const bool headed = cluster_.belief.covariance(kYaw, kYaw) < square(kSettledYawSigma);
  const double open_sky = probability([](const BeliefParticle& particle) {
    return !particle.mode.shadow && !particle.mode.noisy && particle.receiver != kWheelFault;
  });
  const bool open = open_sky > parameters_.confirm_probability && cluster_.mass > kMajority;
  const bool settled =
      class_probability_[kCanyon] > kSettledProbability && cluster_.mass > kSettledProbability;
  const double way = way_since_fix();
  const auto count = [way](double& distance, bool holds) {
    distance = std::max(0.0, distance + (holds ? way : -way));
  };
  count(confirmed_over_, open && headed);
  count(settled_over_, settled && headed);
  confirmed_ = confirmed_ || confirmed_over_ > parameters_.confirm_distance;
}

void MultipathParticleFilter::doubt_steady_bias(double moving_time) {
  const bool biased = cluster_.shadow > kMajority && class_probability_[kCanyon] < kMajority;
  if (!biased) return steady_bias_.clear();
  const double way = moving_time > 0.0 ? way_since_fix() : 0.0;
  steady_bias_.add(cluster_.belief.mean.tail<2>(), way, moving_time, parameters_.steady_bias);
  if (steady_bias_.probability(parameters_.steady_bias) < kMajority) return;
  for (BeliefParticle& particle : particles_) {
    if (particle.receiver == kCanyon) continue;
    particle.belief.move_by_bias(square(parameters_.classes[particle.receiver].open_bias_sigma));
    particle.mode = {};
  }
  steady_bias_.clear();
  unconfirm();
  refresh_cluster();
}

}  // namespace multipath_localization
