#include "estimators/nishida/fix_particle_filter.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/random.hpp"
#include "multipath_localization/models/fix/gnss_position.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "simd/block_resampling.hpp"
#include "simd/random_block.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kMostHypotheses = 2000;
constexpr std::uint32_t kResampling = 0xFFFFFFFFU;  ///< random streams beside those of the particles
constexpr std::uint32_t kRing = 0xFFFFFFFEU;
constexpr double kLeastClusterReach = 2.0;  ///< [m]
constexpr double kClusterSigmas = 3.0;
constexpr double kClusterTurn = 0.6;       ///< [rad]
constexpr double kYawSigmaFloor = 0.01;    ///< added to the published heading [rad]
constexpr double kAlignedYawSigma = 0.3;   ///< [rad]
constexpr double kAlignedDominance = 0.5;  ///< probability mass

/// The vector along `direction`, or along x where that has no length.
Eigen::Vector2d of_length(double length, const Eigen::Vector2d& direction) {
  const double norm = direction.norm();
  return norm > 0.0 ? Eigen::Vector2d(length / norm * direction) : Eigen::Vector2d(length, 0.0);
}

/// The share of Eq. (31) in Eq. (33) of [NIS], where the sky is open with probability `open`.
double shadow_weight(const FixParticleFilterParameters& parameters, double open) {
  const double fixed = parameters.ring.shadow_weight;
  return parameters.bias.sky == Sky::kScatter && fixed > 0.0 ? 1.0 - open : fixed;
}

/// The share of the ring in Eq. (22) of [NIS]. It is where the robot may be if the fix is right, so it
/// supposes open sky.
double ring_fraction(const FixParticleFilterParameters& parameters, double open) {
  const double fixed = parameters.ring.ring_fraction;
  return parameters.bias.sky == Sky::kScatter ? fixed * open : fixed;
}

}  // namespace

FixParticleFilter::FixParticleFilter(const FixParticleFilterParameters& parameters, std::uint64_t seed,
                                     InstructionSet set)
    : parameters_(parameters),
      seed_(seed),
      bias_filter_(parameters.bias),
      heading_(parameters.heading),
      particles_(set),
      bins_(parameters.sampling) {}

void FixParticleFilter::start(const std::optional<PosePrior>& prior) {
  particles_.reset(0);
  fix_check_.forget();
  bias_filter_.forget();
  estimate_ = PoseEstimate();
  step_ = 0;
  now_ = last_fix_ = 0.0;
  if (prior && usable(*prior)) start_at(*prior);
}

void FixParticleFilter::start_at(const PosePrior& prior) {
  now_ = last_fix_ = prior.stamp;
  particles_.reset(most_particles(parameters_.sampling));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(prior.covariance);
  const Eigen::Matrix3d root =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw(seed_, step_, static_cast<std::uint32_t>(i));
    const Eigen::Vector3d d = root * normals<3>(draw);
    particles_.set_pose(i, {prior.pose.x + d.x(), prior.pose.y + d.y(), wrap_angle(prior.pose.yaw + d.z())});
  }
  cluster_reach_ = std::max(kLeastClusterReach, kClusterSigmas * root.topRows<2>().norm());
  begin_tracking();
}

void FixParticleFilter::start_at(const GnssFix& fix) {
  particles_.reset(most_particles(parameters_.sampling));
  const double sigma = std::hypot(parameters_.start_sigma, fix_sigmas(parameters_.likelihood, fix).direct);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    RandomStream draw(seed_, step_, static_cast<std::uint32_t>(i));
    const double yaw = kPi * (2.0 * draw.uniform() - 1.0);
    const Eigen::Vector2d antenna = fix.position + sigma * Eigen::Vector2d(draw.normal(), draw.normal());
    const Eigen::Vector2d base = antenna - rotation(yaw) * fix.antenna_in_base;
    particles_.set_pose(i, {base.x(), base.y(), yaw});
  }
  cluster_reach_ = std::max(kLeastClusterReach, kClusterSigmas * sigma);
  last_fix_ = now_;
  begin_tracking();
}

void FixParticleFilter::begin_tracking() {
  ++step_;
  take_stock();
}

void FixParticleFilter::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  estimate_.stamp = now_ = u.stamp;
  if (particles_.empty() || standing(u)) return;
  if (particles_are_fresh_ && parameters_.propagate_from == PropagateFrom::kEstimate) {
    for (std::size_t i = 0; i < particles_.size(); ++i) particles_.set_pose(i, predicted_);
  }
  particles_are_fresh_ = false;
  predicted_ = predicted_ * displacement(u);
  const SteeringMotion motion(u, parameters_.motion);
  const InstructionSet set = particles_.instruction_set();
  const PoseSums sums = particles_.move(predicted_, [&](const PoseBlock& poses, std::uint32_t first) {
    RandomWords words;
    Normals normals;
    random_words(set, seed_, step_, first, words);
    standard_normals(set, words, normals);
    motion.move(set, poses, normals);
  });
  describe(sums, predicted_);
  heading_.add(u);
  ++step_;
}

Innovation FixParticleFilter::update(const Measurement& z) {
  const auto* fix = std::get_if<GnssFix>(&z);
  if (fix == nullptr) return refused(Reason::kUnused);
  if (const auto reason = fix_check_.defect(*fix)) return refused(*reason);
  if (particles_.empty()) {
    start_at(*fix);
    Innovation first;
    first.reason = Reason::kAccepted;
    return first;
  }
  const Innovation result = compare(*fix);
  const FixSigmas sigma = fix_sigmas(parameters_.likelihood, *fix);
  const Eigen::Vector2d bias =
      bias_filter_.update(fix->position, predicted_ * fix->antenna_in_base, sigma, now_ - last_fix_);
  if (estimate_.aligned && parameters_.ring.ring_fraction > 0.0) sample_ring(bias.norm(), sigma);
  const bool vector = parameters_.ring.shadow_place == ShadowPlace::kVector;
  const GnssLikelihood likelihood(
      parameters_.likelihood, *fix, shadow_weight(parameters_, bias_filter_.open_probability()),
      vector ? ShadowRing{bias, 0.0} : ShadowRing{Eigen::Vector2d::Zero(), bias.norm()},
      heading_.heading(fix->position - rotation(predicted_.yaw) * fix->antenna_in_base));
  particles_.weigh([&](const PoseBlock& poses, double* log_weight, double* factor, float* shadow_share) {
    likelihood.add_to(particles_.instruction_set(), poses, log_weight, factor, shadow_share);
  });
  cluster_reach_ = std::max(kLeastClusterReach, kClusterSigmas * sigma.direct);
  take_stock();
  if (parameters_.ring.shadow_weight > 0.0) {
    estimate_.bias =
        vector ? bias : of_length(bias.norm(), fix->position - predicted_ * fix->antenna_in_base);
    estimate_.bias_covariance = bias_filter_.covariance();
  }
  if (estimate_.effective_sample_size < parameters_.ess_threshold) resample();
  last_fix_ = now_;
  ++step_;
  return result;
}

/// Eqs. (27)-(33) of [NIS].
Innovation FixParticleFilter::compare(const GnssFix& fix) const {
  const PoseEstimate before = estimate();
  const Eigen::Matrix<double, 2, 3> H = antenna_jacobian(before.pose, fix.antenna_in_base);
  Innovation result;
  result.reason = Reason::kAccepted;
  result.innovation = fix.position - before.pose * fix.antenna_in_base;
  result.covariance = H * before.covariance * H.transpose() +
                      square(fix_sigmas(parameters_.likelihood, fix).direct) * Eigen::Matrix2d::Identity();
  result.nis = result.innovation.dot(result.covariance.llt().solve(result.innovation));
  return result;
}

/// p_r of [NIS], Eqs. (22)-(26), for particles at equal steps. Departs: Eq. (24) prints r_s for the mean
/// r_hat.
void FixParticleFilter::sample_ring(double radius, const FixSigmas& sigma) {
  const bool printed = parameters_.ring.ring_weight == RingWeight::kPrinted;
  const auto size = static_cast<double>(particles_.size());
  const double log_scale = -std::log(size) - 0.5 * std::log(2.0 * kPi * square(sigma.shadow));
  RandomStream draw(seed_, step_, kRing);
  const double count =
      std::floor(ring_fraction(parameters_, bias_filter_.open_probability()) * size + draw.uniform());
  const double offset = draw.uniform();
  RandomWords words;
  Normals normals;
  for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(count); ++k) {
    const std::size_t lane = k % kBlockSize;
    if (lane == 0) {
      random_words(particles_.instruction_set(), seed_, step_, k, words);
      standard_normals(particles_.instruction_set(), words, normals);
    }
    // The direction of two normals is uniform.
    const double rho = radius + sigma.direct * static_cast<double>(normals.third()[lane]);
    const Eigen::Vector2d to_ring =
        of_length(rho, Eigen::Vector2f(normals.first()[lane], normals.second()[lane]).cast<double>());
    const auto i = static_cast<std::size_t>((k + offset) * size / count);
    particles_.set_pose(i, {predicted_.x + to_ring.x(), predicted_.y + to_ring.y(), predicted_.yaw});
    // Departs, unless "printed": Eq. (26) has rho in the place of rho - r_hat, which kills the ring once it
    // is wide.
    particles_.set_log_weight(i, log_scale - 0.5 * square((printed ? rho : rho - radius) / sigma.shadow));
  }
}

/// Eqs. (34), (35), (39) of [NIS]. Departs, unless "mean": Eq. (35) averages over clusters as well.
void FixParticleFilter::take_stock() {
  PoseNeighbourhood within{predicted_, std::numeric_limits<double>::infinity(), 2.0 * kPi};
  if (parameters_.point_estimate == PointEstimate::kCluster) {
    within = particles_.dominant_neighbourhood(cluster_reach_, kClusterTurn);
  } else {
    within.centre = member_moments(particles_.choose_members(within), within.centre).mean;
  }
  describe(particles_.choose_members(within), within.centre);
  estimate_.shadow_probability = std::min(1.0, particles_.mean_label());
  estimate_.effective_sample_size = particles_.weights().effective_sample_size();
  predicted_ = estimate_.pose;
  particles_are_fresh_ = true;
  if (heading_.due() || step_ == 1) heading_.restart(predicted_.position());
}

void FixParticleFilter::describe(const PoseSums& sums, const Pose2& reference) {
  const PoseMoments within = member_moments(sums, reference);
  const double floor = square(parameters_.position_sigma_floor);
  estimate_.valid = true;
  estimate_.stamp = now_;
  estimate_.pose = within.mean;
  estimate_.covariance = within.covariance;
  estimate_.covariance.diagonal() += Eigen::Vector3d(floor, floor, square(kYawSigmaFloor));
  estimate_.covariance.topLeftCorner<2, 2>() += bias_filter_.moved_unseen();
  estimate_.position_covariance_overall = floor * Eigen::Matrix2d::Identity() + bias_filter_.moved_unseen() +
                                          position_spread(sums, reference, within.mean.position());
  estimate_.dominance = std::min(1.0, sums.members.w);
  estimate_.aligned =
      estimate_.dominance > kAlignedDominance && estimate_.covariance(2, 2) < square(kAlignedYawSigma);
}

/// Eqs. (40)-(43) of [NIS].
void FixParticleFilter::resample() {
  const double uniform = RandomStream(seed_, step_, kResampling).uniform();
  const auto draw = [&](std::size_t count) {
    systematic_resampling(particles_.instruction_set(), particles_.weights(), count, uniform, ancestors_);
  };
  draw(particles_.size());
  const std::size_t needed = needed_particles();
  if (needed != particles_.size()) draw(needed);
  particles_.select(ancestors_);
}

/// By the bins that the ancestors fall into.
std::size_t FixParticleFilter::needed_particles() {
  if (most_particles(parameters_.sampling) == static_cast<std::size_t>(parameters_.sampling.min_particles)) {
    return particles_.size();
  }
  bins_.clear();
  for (std::size_t i = 0; i < ancestors_.size(); ++i) {
    if (i == 0 || ancestors_[i] != ancestors_[i - 1]) bins_.add(particles_.pose(ancestors_[i]));
  }
  return kld_sample_size(bins_.count(), parameters_.sampling);
}

std::vector<Hypothesis> FixParticleFilter::hypotheses() const {
  const std::size_t stride = (particles_.size() + kMostHypotheses - 1) / kMostHypotheses;
  std::vector<Hypothesis> all;
  double total = 0.0;
  for (std::size_t i = 0; i < particles_.size(); i += stride) {
    const double weight = particles_.weights()[i];
    all.push_back({particles_.pose(i), weight, particles_.label(i) > 0.5F ? Mode::kShadow : Mode::kOpen});
    total += weight;
  }
  for (Hypothesis& hypothesis : all) hypothesis.weight /= total;
  return all;
}

}  // namespace multipath_localization
