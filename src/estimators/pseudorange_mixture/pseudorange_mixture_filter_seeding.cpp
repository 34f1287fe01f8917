#include <algorithm>
#include <cmath>

#include "estimators/pseudorange_mixture/evidence.hpp"
#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"
#include "multipath_localization/models/motion/odometry_motion.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kUpClockCorrelation = 0.8;
constexpr double kUpSigma = 25.0;      // of height and clock by one epoch among reflections [m]
constexpr double kDriftSigma = 100.0;  // of a clock whose quartz is off by a third of a millionth [m/s]
constexpr double kGoldenRatio = 0.6180339887498949;
constexpr double kLeastYawStrata = 12.0;
constexpr std::uint32_t kSeeding = 0xFFFFFFFEU;  // random streams beside those of hypotheses
constexpr double kSeedSigma = 5.0;               // [m]
constexpr double kSeedLogScale = 3.0;            // tempers the choice of seeds: errors of one epoch mislead
constexpr double kAnyYaw = 1.8;                  // of any heading [rad]
constexpr double kZenithDelaySigma = 4.0;        // without coefficients of the day, or of what they leave [m]
constexpr double kAnySpeed = 10.0;               // of a robot without wheels [m/s]
constexpr double kNewView = 2.0;                 // satellites come into view: the sky is another one
// Hypotheses tried anew, first until one cluster has won, then once it has, when they are to cost little.
constexpr double kReseedInterval = 2.0;       // the view of a street has changed by then [s]
constexpr double kWatchInterval = 5.0;        // [s]
constexpr double kReseedProbability = 0.005;  // they win by evidence, not by being many
constexpr double kWatchProbability = 0.001;
constexpr int kReseedPart = 4;  // of the hypotheses at the start
constexpr int kWatchPart = 8;

/// Whether satellites have come into view that tell wrong places from right ones.
bool is_new_view(const SlottedEpoch& epoch) {
  double sum = 0.0;
  for (const SlottedObservation& satellite : epoch.satellites) sum += satellite.share;
  return sum > kNewView;
}

/// Of a receiver that was switched on just now.
ReceiverPrior unknown_receiver(const ReceiverStateNoise& receiver) {
  ReceiverPrior prior;
  prior.up_variance = square(kUpSigma);
  prior.offset_variance.fill(square(receiver.offset_sigma));
  prior.zenith_delay_variance = square(kZenithDelaySigma);
  return prior;
}

}  // namespace

PseudorangeBelief PseudorangeMixtureFilter::unknown_belief() const {
  using State = PseudorangeBelief;
  PseudorangeBelief belief;
  auto& P = belief.covariance;
  P.diagonal().head<2>().setConstant(square(parameters_.start_sigma));
  P(kYaw, kYaw) = square(kPi / std::max(kLeastYawStrata, static_cast<double>(parameters_.hypotheses)));
  P(kScale, kScale) = square(parameters_.odometry.scale_sigma);
  P(kGyroBias, kGyroBias) = square(parameters_.odometry.gyro_bias_sigma);
  // What lengthens all ranges alike is known better than height and clock.
  const double up = square(kUpSigma);
  P(State::kUp, State::kUp) = P(State::kClock, State::kClock) = up;
  P(State::kUp, State::kClock) = P(State::kClock, State::kUp) = kUpClockCorrelation * up;
  P(State::kZenithDelay, State::kZenithDelay) = square(kZenithDelaySigma);
  P(State::kDrift, State::kDrift) = square(kDriftSigma);
  if (last_.from_range_rates) {
    P(kYaw, kYaw) = square(kAnyYaw);
    P.diagonal().segment<2>(State::kVelocityEast).setConstant(square(kAnySpeed));
  }
  return belief;
}

PseudorangeHypothesis PseudorangeMixtureFilter::hypothesis_at(
    const PseudorangeSeed& seed, double yaw, const Eigen::Vector2d& antenna_in_base,
    const std::optional<ReceiverPrior>& receiver) const {
  using State = PseudorangeBelief;
  PseudorangeBelief belief =
      has_clock_ || bank_.empty() ? unknown_belief() : bank_.hypotheses().front().likeliest();
  if (has_clock_ || bank_.empty()) {
    belief.mean.head<2>() = seed.position.head<2>() - rotation(yaw) * antenna_in_base;
    belief.mean(kYaw) = yaw;
  }
  belief.mean(State::kUp) = seed.position.z();
  belief.mean(State::kClock) = seed.clock;
  for (int slot = 0; slot < slots_.size(); ++slot) {
    const SlotOwner& owner = slots_.owner(slot);
    const int state = State::state_of(slot);
    if (state == belief.mean.size()) belief.append(bank_.unknown_variance(owner));
    if (!owner.satellite) belief.mean(state) = seed.offset[static_cast<std::size_t>(owner.constellation)];
  }
  if (receiver) make_as_sure(belief, slots_, *receiver);
  PseudorangeHypothesis hypothesis(belief, laws());
  if (has_clock_ && !bank_.empty()) hypothesis.learn_from(bank_.heaviest());
  return hypothesis;
}

std::optional<AntennaPrior> PseudorangeMixtureFilter::antenna_prior(
    const Eigen::Vector2d& antenna_in_base) const {
  if (has_clock_ || bank_.empty()) return std::nullopt;
  const AntennaPrediction antenna(bank_.hypotheses().front().planar(), antenna_in_base);
  return AntennaPrior{antenna.position, antenna.covariance};
}

bool PseudorangeMixtureFilter::seed(const SlottedEpoch& epoch, int count, double probability) {
  std::vector<SatelliteObservation> observations;
  for (const SlottedObservation& satellite : epoch.satellites) observations.push_back(satellite.observation);
  const int subsets = has_clock_ ? std::max(1, parameters_.subsets / kReseedPart) : parameters_.subsets;
  const PseudorangeSeedingParameters settings{subsets, kSeedSigma, parameters_.receiver.offset_sigma,
                                              kSeedLogScale};
  const bool known = has_clock_ && !alignment_.in_doubt();
  const double variance = bank_.place().overall_position_covariance.trace();
  SeedPrior prior{antenna_prior(epoch.antenna_in_base), std::nullopt};
  if (known) {
    prior.receiver = receiver_prior(bank_.heaviest().likeliest(), slots_,
                                    unknown_receiver(parameters_.receiver), variance);
  }
  RandomStream random(seed_, step_, kSeeding);
  const auto seeds = pseudorange_seeds(observations, prior, static_cast<std::size_t>(count),
                                       parameters_.errors.mixture, settings, random);
  if (seeds.empty()) return false;
  // Headings by the golden ratio: evenly over the circle for each stretch of the seeds.
  double turn = random.uniform();
  const double delay = parameters_.errors.mixture.nlos_delay;
  std::vector<PseudorangeHypothesis> newcomers;
  for (const PseudorangeSeed& seed : seeds) {
    const bool keeps_heading = alignment_.aligned() && newcomers.size() % 2 == 1;
    const double yaw = keeps_heading ? bank_.cluster().belief.mean(kYaw) : kPi * (2.0 * turn - 1.0);
    newcomers.push_back(hypothesis_at(seed, yaw, epoch.antenna_in_base, prior.receiver));
    newcomers.back().log_weight = std::log(probability / static_cast<double>(count));
    if (known) {
      const double distance = (seed.position.head<2>() - bank_.place().belief.mean.head<2>()).norm();
      newcomers.back().log_weight += log_probability_of_place(distance, std::sqrt(variance), delay);
    }
    turn = std::fmod(turn + kGoldenRatio, 1.0);
  }
  if (!has_clock_) bank_.clear();
  bank_.add(newcomers);
  has_clock_ = true;
  last_seeding_ = last_.stamp;
  return true;
}

double PseudorangeMixtureFilter::reseed_probability() const {
  return alignment_.aligned() ? kWatchProbability : kReseedProbability;
}

void PseudorangeMixtureFilter::reseed(const SlottedEpoch& epoch) {
  const bool aligned = alignment_.aligned();
  const double interval = aligned ? kWatchInterval : kReseedInterval;
  const bool of_use = aligned || moved_ > 0.0 || alignment_.in_doubt();
  if (!is_new_view(epoch) && (!of_use || last_.stamp - last_seeding_ <= interval)) return;
  seed(epoch, std::max(1, parameters_.hypotheses / (aligned ? kWatchPart : kReseedPart)),
       reseed_probability());
}

}  // namespace multipath_localization
