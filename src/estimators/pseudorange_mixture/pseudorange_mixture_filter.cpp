#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "estimators/pseudorange_mixture/evidence.hpp"
#include "estimators/pseudorange_mixture/hypothesis_bank.hpp"
#include "multipath_localization/core/epoch_check.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/filters/resampling.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kLongestFlush = 1.0;    // [s]
constexpr double kFirstDuration = 0.2;   // data that the first epoch counts for [s]
constexpr double kLeastDuration = 1e-3;  // [s]
constexpr double kFullSpeed = 1.0;       // from here on errors change at their full pace [m/s]
constexpr double kAtRest = 0.1;          // of that pace
constexpr double kLeastWeight = 0.03;  // of what new hypotheses get together: who is lighter has lost to them
constexpr double kSlotTime = 300.0;    // unseen for so long, a satellite's bias has changed [s]
constexpr std::size_t kCloud = 200;

/// GPS's clock is the reference.
bool has_offset(Constellation constellation) { return constellation != Constellation::kGps; }

/// Offsets first: without its constellation's a satellite is of no use.
std::vector<SlotOwner> owners_of(const std::vector<SatelliteObservation>& observations) {
  std::vector<SlotOwner> owners;
  for (const SatelliteObservation& observation : observations) {
    if (has_offset(observation.constellation)) owners.push_back({observation.constellation, std::nullopt});
  }
  for (const SatelliteObservation& observation : observations) {
    owners.push_back({observation.constellation, observation.satellite});
  }
  return owners;
}

/// A satellite with its slots; nothing when there was no room for it.
std::optional<SlottedObservation> slotted_observation(const SatelliteObservation& observation,
                                                      const SatelliteSlots& slots,
                                                      const RangeErrorParameters& errors) {
  SlottedObservation satellite;
  const auto bias = slots.find({observation.constellation, observation.satellite});
  const auto offset = slots.find({observation.constellation, std::nullopt});
  const bool with_offset = has_offset(observation.constellation);
  if (!bias || (with_offset && !offset)) return std::nullopt;
  satellite.observation = observation;
  satellite.prior = line_of_sight_prior(observation, errors.mixture);
  satellite.sigma = line_of_sight_sigma(observation, errors);
  satellite.delay = mean_nlos_delay(observation.elevation, errors.mixture);
  if (with_offset) satellite.offset_slot = *offset;
  satellite.bias_slot = *bias;
  return satellite;
}

/// Increments made of the range rates tell an epoch no motion beside them.
void set_motion(SlottedEpoch& epoch, const OdometryIncrement& last) {
  epoch.wheels = !last.from_range_rates;
  if (!epoch.wheels) return;
  epoch.speed = last.speed;
  epoch.lateral_speed = last.lateral_speed;
  epoch.yaw_rate = last.yaw_rate;
}

}  // namespace

PseudorangeMixtureFilter::PseudorangeMixtureFilter(const PseudorangeMixtureFilterParameters& parameters,
                                                   std::uint64_t seed)
    : parameters_(parameters), seed_(seed), bank_(parameters.odometry, parameters.receiver) {}

void PseudorangeMixtureFilter::start(const std::optional<PosePrior>& prior) {
  bank_.clear();
  slots_ = SatelliteSlots();
  signal_ = SignalScale();
  last_ = OdometryIncrement();
  step_ = 0;
  last_epoch_ = last_seeding_ = moved_ = 0.0;
  has_clock_ = false;
  alignment_.restart(std::nullopt);
  if (!prior || !usable(*prior)) return;
  last_.stamp = last_epoch_ = last_seeding_ = prior->stamp;
  PseudorangeBelief belief = unknown_belief();
  belief.mean.head<3>() << prior->pose.x, prior->pose.y, wrap_angle(prior->pose.yaw);
  belief.covariance.topLeftCorner<3, 3>() = prior->covariance;
  bank_.add({PseudorangeHypothesis(belief, laws())});
  alignment_.restart(prior->covariance(kYaw, kYaw));
  bank_.refresh(alignment_.aligned());
}

void PseudorangeMixtureFilter::predict(const OdometryIncrement& u) {
  if (!usable(u)) return;
  last_ = u;
  if (bank_.empty()) return;
  const double summed_up =
      bank_.add(u.from_range_rates ? OdometryIncrement{u.stamp, u.duration, 0.0, 0.0} : u);
  if (!standing(u)) moved_ += ground_speed(u) * u.duration;
  if (summed_up > kLongestFlush) {
    bank_.move(laws(), slots_);
    bank_.refresh(alignment_.aligned());
  }
}

Innovation PseudorangeMixtureFilter::update(const Measurement& z) {
  const auto* epoch = std::get_if<PseudorangeEpoch>(&z);
  if (epoch == nullptr) return refused(Reason::kUnused);
  if (const auto reason = defect(*epoch)) return refused(*reason);
  return weigh(*epoch);
}

Innovation PseudorangeMixtureFilter::weigh(const PseudorangeEpoch& epoch) {
  bank_.move(laws(), slots_);
  const SlottedEpoch slotted_epoch = slotted(epoch);
  const bool seen = !slotted_epoch.satellites.empty();
  if (!seen || (!has_clock_ && !seed(slotted_epoch, parameters_.hypotheses, 1.0))) {
    if (!bank_.empty()) bank_.refresh(alignment_.aligned());
    return refused(Reason::kTooFewSatellites);
  }
  reseed(slotted_epoch);
  bank_.update(slotted_epoch, laws(), parameters_.errors, kLeastWeight * reseed_probability());
  bank_.refresh(alignment_.aligned());
  update_alignment(slotted_epoch);
  bank_.follow(slots_.retire(last_.stamp - kSlotTime));
  last_epoch_ = last_.stamp;
  moved_ = 0.0;
  ++step_;
  Innovation result;
  result.reason = Reason::kAccepted;
  return result;
}

SlottedEpoch PseudorangeMixtureFilter::slotted(const PseudorangeEpoch& epoch) {
  SlottedEpoch result;
  result.antenna_in_base = epoch.antenna_in_base;
  result.age = std::max(0.0, last_.stamp - epoch.stamp);
  result.duration = has_clock_ ? std::max(kLeastDuration, last_.stamp - last_epoch_) : kFirstDuration;
  const double change = pace(result.duration) / kFullSpeed;
  result.information =
      result.duration * (has_clock_ && !alignment_.in_doubt() ? std::clamp(change, kAtRest, 1.0) : 1.0);
  result.bias_variance = square(parameters_.receiver.bias_sigma);
  set_motion(result, last_);
  std::vector<SatelliteObservation> observations = usable_observations(epoch);
  signal_.add(observations, result.duration);
  for (SatelliteObservation& observation : observations) observation.cn0 -= signal_.strong();
  result.has_rates = std::any_of(observations.begin(), observations.end(),
                                 [](const auto& observation) { return observation.has_doppler(); });
  std::vector<double> shares;
  for (const SatelliteObservation& observation : observations) {
    const double unseen =
        has_clock_ ? slots_.unseen({observation.constellation, observation.satellite}, last_epoch_) : 0.0;
    shares.push_back(evidence_share(result.information, unseen, parameters_.errors.evidence_time));
  }
  bank_.follow(slots_.admit(owners_of(observations), last_.stamp));
  for (std::size_t i = 0; i < observations.size(); ++i) {
    auto satellite = slotted_observation(observations[i], slots_, parameters_.errors);
    if (!satellite) continue;
    satellite->share = shares[i];
    result.satellites.push_back(*satellite);
  }
  // The surest first: the others are then judged against what these say.
  std::stable_sort(result.satellites.begin(), result.satellites.end(),
                   [](const auto& a, const auto& b) { return a.prior > b.prior; });
  return result;
}

double PseudorangeMixtureFilter::pace(double duration) const {
  if (!last_.from_range_rates) return moved_ / duration;
  if (bank_.empty()) return 0.0;
  return bank_.heaviest().likeliest().mean.segment<2>(PseudorangeBelief::kVelocityEast).norm();
}

void PseudorangeMixtureFilter::update_alignment(const SlottedEpoch& epoch) {
  double expected = 0.0;
  for (const SlottedObservation& satellite : epoch.satellites) expected += satellite.prior;
  const double found = bank_.line_of_sight_share() * static_cast<double>(epoch.satellites.size());
  alignment_.compare(found, expected, epoch.duration);
  const DominantCluster& cluster = bank_.cluster();
  alignment_.update(cluster.mass, cluster.belief.covariance(kYaw, kYaw), moved_);
}

PoseEstimate PseudorangeMixtureFilter::estimate() const {
  PoseEstimate result;
  result.stamp = last_.stamp;
  if (bank_.empty()) return result;
  Belief belief = bank_.current(bank_.cluster().belief);
  if (!alignment_.aligned()) {
    const Belief place = bank_.current(bank_.place().belief);
    belief.mean.head<2>() = place.mean.head<2>();
    belief.covariance.topLeftCorner<3, 3>() = place.covariance.topLeftCorner<3, 3>();
  }
  const double factor = square(parameters_.sigma_factor);
  const Eigen::Matrix2d common =
      (square(parameters_.position_sigma_floor) + square(parameters_.uncorrected_sigma)) *
      Eigen::Matrix2d::Identity();
  result.valid = true;
  result.aligned = alignment_.aligned();
  result.pose = belief.pose();
  result.covariance = factor * belief.covariance.topLeftCorner<3, 3>();
  result.covariance.topLeftCorner<2, 2>() += common;
  result.dominance = bank_.cluster().mass;
  result.position_covariance_overall = factor * bank_.place().overall_position_covariance + common;
  result.shadow_probability = bank_.cluster().shadow;
  double squares = 0.0;
  for (const double weight : weights_of(bank_.hypotheses())) squares += square(weight);
  result.effective_sample_size = 1.0 / squares;
  return result;
}

std::vector<Hypothesis> PseudorangeMixtureFilter::hypotheses() const {
  std::vector<Hypothesis> cloud;
  if (bank_.empty()) return cloud;
  const std::vector<WeightedBelief> particles = planar(bank_.hypotheses());
  const std::vector<double> weights = weights_of(bank_.hypotheses());
  const auto ancestors = systematic_resampling(weights, kCloud, 0.5);
  for (std::size_t i = 0; i < ancestors.size(); ++i) {
    const Belief belief = bank_.current(particles[ancestors[i]].belief);
    const Eigen::Matrix3d root = belief.covariance.topLeftCorner<3, 3>().llt().matrixL();
    RandomStream random(seed_, step_, static_cast<std::uint32_t>(i));
    const Eigen::Vector3d d = root * normals<3>(random);
    const Pose2 pose{belief.mean(kX) + d.x(), belief.mean(kY) + d.y(), wrap_angle(belief.mean(kYaw) + d.z())};
    cloud.push_back({pose, 1.0 / static_cast<double>(kCloud),
                     particles[ancestors[i]].in_shadow ? Mode::kShadow : Mode::kOpen});
  }
  return cloud;
}

}  // namespace multipath_localization
