#include "estimators/multipath/rival.hpp"

#include <algorithm>
#include <cmath>

#include "support/numbers.hpp"

namespace multipath_localization::multipath {

namespace {

constexpr int kHypotheses = 512;     // eight for each heading: the fixes decide between headings at once
constexpr double kWrong = 1e-3;      // a cloud in a shadow is wrong altogether in one case of a thousand
constexpr double kDoubtful = 0.5;    // a cloud is doubted where it doubts the fixes: probability of a shadow
constexpr double kNearest = 6.0;     // nearer than this the explanations of the cloud itself reach [m]
constexpr double kLogOfReach = 4.6;  // and a hundred times as far all orders of magnitude are as likely
constexpr double kWorthTaking = 0.03;  // share of the whole that leaves a rival some hypotheses
constexpr double kMostTaken = 0.999;   // a logarithm of the rest has to be finite
constexpr double kYouth = 5.0;         // to find the heading, in which any fix may look like a shadow [s]
constexpr double kPatience = 60.0;     // one that has not won by then began with a wrong fix [s]

CloudSettings with_few_particles(CloudSettings settings) {
  settings.particles = kHypotheses;
  return settings;
}

}  // namespace

Rival::Rival(CloudSettings settings, std::uint64_t seed) : cloud_(with_few_particles(settings), seed) {}

void Rival::propagate(const OdometrySum& odometry) {
  if (!cloud_.empty()) cloud_.propagate(odometry);
}

void Rival::start(const Sighting& sighting, double log_density, const HypothesisCloud& cloud) {
  const GnssFix& fix = sighting.fix;
  cloud_.start(fix, cloud, sighting.largest_bias);
  age_ = 0.0;
  const Eigen::Vector2d antenna = pose_of(cloud.mixture().mean) * fix.antenna_in_base;
  const double distance = std::max(kNearest, (fix.position - antenna).norm());
  const double log_own_density = -std::log(2.0 * kPi * kLogOfReach * square(distance));
  log_odds_ = std::log(kWrong) + log_own_density - log_density;
}

bool Rival::pointless(const HypothesisCloud& cloud) const {
  const bool beside_a_shadow = age_ > kYouth && cloud_.mixture().least_shadow() > kDoubtful;
  return cloud.mixture().least_shadow() < kDoubtful || beside_a_shadow || age_ > kPatience;
}

void Rival::weigh(const Sighting& sighting, double log_density, HypothesisCloud& cloud) {
  if (cloud_.empty()) {
    if (!sighting.standing && cloud.mixture().least_shadow() > kDoubtful) start(sighting, log_density, cloud);
    return;
  }
  const double log_own_density = cloud_.weigh(sighting);
  if (!sighting.standing) {
    age_ += sighting.unseen();
    log_odds_ += evidence_share(cloud.mixture(), sighting.duration) * (log_own_density - log_density);
  }
  const double share = 1.0 / (1.0 + std::exp(-log_odds_));
  const bool worth_taking = share > kWorthTaking;
  if (worth_taking) cloud.take_in(cloud_, std::min(share, kMostTaken));
  if (worth_taking || pointless(cloud)) cloud_.clear();
}

}  // namespace multipath_localization::multipath
