#include "simulation/random_receiver.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/random_ranges.hpp"

namespace multipath_localization {

namespace {

namespace ranges = random_ranges;

/// A matrix of determinant 1 that makes one axis of a circle `ratio` times as long as the other.
Eigen::Matrix2d stretched(double ratio, double direction) {
  const Eigen::Vector2d axes(std::sqrt(ratio), 1.0 / std::sqrt(ratio));
  return rotation(direction) * axes.asDiagonal() * rotation(-direction);
}

Eigen::Matrix2d draw_shape(RandomStream& random, Span ratio) {
  const double drawn = draw(random, ratio);
  return stretched(drawn, draw(random, Span{0.0, kPi}));
}

FixErrors plain_errors(RandomStream& random) {
  return {draw(random, ranges::kPlainOffset), draw(random, ranges::kPlainSlowSigma),
          draw(random, ranges::kPlainSlowTime), draw(random, ranges::kPlainWhiteSigma)};
}

std::vector<FixErrors> draw_levels(RandomStream& random, ReceiverKind kind) {
  switch (kind) {
    case ReceiverKind::kRtk: {
      const double fixed = draw(random, ranges::kFixedSigma);
      const FixErrors floating{0.0, draw(random, ranges::kFloatSigma), draw(random, ranges::kFloatTime),
                               fixed};
      return {{0.0, 0.0, 1.0, fixed}, floating, plain_errors(random)};
    }
    case ReceiverKind::kGood:
      return {{0.0, draw(random, ranges::kGoodSigma), draw(random, ranges::kGoodTime),
               draw(random, ranges::kGoodSigma)}};
    case ReceiverKind::kPlain: return {plain_errors(random)};
    case ReceiverKind::kSmooth:
      return {{0.0, draw(random, ranges::kSmoothSigma), draw(random, ranges::kSmoothTime),
               draw(random, ranges::kSmoothWhiteSigma)}};
    case ReceiverKind::kDrifting:
      return {{0.0, draw(random, ranges::kDriftSigma), draw(random, ranges::kDriftTime),
               draw(random, ranges::kDriftWhiteSigma)}};
    case ReceiverKind::kWhite: return {{0.0, 0.0, 1.0, draw(random, ranges::kWhiteSigma)}};
  }
  return {};
}

std::vector<FixStatus> draw_statuses(RandomStream& random, ReceiverKind kind) {
  const FixStatus always =
      one_of(random, {FixStatus::kSingle, FixStatus::kSatelliteBased, FixStatus::kGroundBased});
  const FixStatus floating = one_of(random, {FixStatus::kSatelliteBased, FixStatus::kGroundBased});
  const FixStatus good = one_of(random, {FixStatus::kSingle, FixStatus::kSatelliteBased});
  const bool constant = chance(random, ranges::kStatusConstant);
  if (kind == ReceiverKind::kRtk) {
    if (constant) return {always, always, always};
    return {FixStatus::kGroundBased, floating, FixStatus::kSingle};
  }
  if (constant) return {always};
  return {kind == ReceiverKind::kGood ? good : FixStatus::kSingle};
}

void draw_declaration(RandomStream& random, RandomReceiver& receiver) {
  const double optimism = draw(random, ranges::kOptimism);
  const double constant = draw(random, ranges::kConstantSigma);
  const double centimetres = draw(random, ranges::kCentimetres);
  const double metres = draw(random, ranges::kMetres);
  const Declaration wrong =
      receiver.levels.front().sigma() < 1.0 ? Declaration::kMetres : Declaration::kCentimetres;
  receiver.declaration =
      one_of(random, {Declaration::kHonest, Declaration::kHonest, Declaration::kHonest,
                      Declaration::kOptimistic, Declaration::kOptimistic, Declaration::kConstant, wrong});
  if (receiver.declaration == Declaration::kOptimistic) receiver.optimism = optimism;
  if (receiver.declaration == Declaration::kConstant) receiver.declared_sigma = constant;
  if (receiver.declaration == Declaration::kCentimetres) receiver.declared_sigma = centimetres;
  if (receiver.declaration == Declaration::kMetres) receiver.declared_sigma = metres;
  receiver.shape = draw_shape(random, ranges::kShape);
  if (chance(random, ranges::kFullCovariance)) {
    receiver.declared_shape =
        chance(random, 0.5) ? receiver.shape : draw_shape(random, ranges::kDeclaredShape);
  }
  receiver.declares_shadow = chance(random, ranges::kShadowDeclared);
}

/// Half the diagonal of the box the way lies in [m].
double extent(const std::vector<MotionStep>& steps) {
  Eigen::Vector2d low = steps.front().base_in_map.position();
  Eigen::Vector2d high = low;
  for (const MotionStep& step : steps) {
    low = low.cwiseMin(step.base_in_map.position());
    high = high.cwiseMax(step.base_in_map.position());
  }
  return 0.5 * (high - low).norm();
}

RandomShadow draw_shadow(RandomStream& random, const Eigen::Vector2d& centre, double speed, double extent) {
  RandomShadow shadow;
  shadow.centre = centre;
  shadow.radius = std::min(speed * draw(random, ranges::kShadowTime), ranges::kShadowOfWay * extent);
  shadow.bias = draw(random, ranges::kShadowBias);
  shadow.law =
      one_of(random, {ShadowLaw::kConstant, ShadowLaw::kTurning, ShadowLaw::kJumping, ShadowLaw::kWalkingIn});
  const double side = either_sign(random);
  const double turn_rate = side * draw(random, ranges::kShadowTurn);
  const double jump = draw(random, ranges::kShadowJump);
  const double walk_in = draw(random, ranges::kShadowWalkIn);
  if (shadow.law == ShadowLaw::kTurning) shadow.turn_rate = turn_rate;
  if (shadow.law == ShadowLaw::kJumping) shadow.interval = jump;
  if (shadow.law == ShadowLaw::kWalkingIn) shadow.interval = walk_in;
  shadow.noise = draw(random, ranges::kShadowNoise);
  return shadow;
}

void draw_shadows(RandomStream& random, const std::vector<MotionStep>& steps, double speed,
                  RandomReceiver& receiver) {
  const double reach = extent(steps);
  const int count = static_cast<int>(draw(random, Span{0.0, ranges::kMostShadows + 1.0}));
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(random.uniform() * static_cast<double>(steps.size()));
    receiver.shadows.push_back(draw_shadow(random, steps[place].base_in_map.position(), speed, reach));
  }
  if (chance(random, ranges::kStartsInShadow)) {
    receiver.shadows.push_back(draw_shadow(random, steps.front().base_in_map.position(), speed, reach));
  }
}

void draw_outages(RandomStream& random, double duration, RandomReceiver& receiver) {
  const int count = static_cast<int>(draw(random, Span{0.0, ranges::kMostOutages + 1.0}));
  for (int i = 0; i < count; ++i) {
    RandomOutage outage;
    outage.when = {draw(random, Span{0.0, duration}), draw(random, ranges::kOutage)};
    if (chance(random, ranges::kOffAfterOutage)) {
      outage.off_duration = draw(random, ranges::kOffAfterOutageTime);
      outage.off_bias = draw(random, ranges::kOffAfterOutageBias);
    }
    receiver.outages.push_back(outage);
  }
}

}  // namespace

std::string_view to_string(ReceiverKind kind) {
  switch (kind) {
    case ReceiverKind::kRtk: return "rtk";
    case ReceiverKind::kGood: return "good";
    case ReceiverKind::kPlain: return "plain";
    case ReceiverKind::kSmooth: return "smooth";
    case ReceiverKind::kDrifting: return "drifting";
    case ReceiverKind::kWhite: return "white";
  }
  return "";
}

std::string_view to_string(Declaration declaration) {
  switch (declaration) {
    case Declaration::kHonest: return "honest";
    case Declaration::kOptimistic: return "optimistic";
    case Declaration::kConstant: return "constant";
    case Declaration::kCentimetres: return "centimetres";
    case Declaration::kMetres: return "metres";
  }
  return "";
}

std::string_view to_string(ShadowLaw law) {
  switch (law) {
    case ShadowLaw::kConstant: return "constant";
    case ShadowLaw::kTurning: return "turning";
    case ShadowLaw::kJumping: return "jumping";
    case ShadowLaw::kWalkingIn: return "walking in";
  }
  return "";
}

double FixErrors::sigma() const {
  return std::sqrt(0.5 * constant * constant + slow_sigma * slow_sigma + white_sigma * white_sigma);
}

const RandomShadow* shadow_at(const RandomReceiver& receiver, const Eigen::Vector2d& point) {
  const auto found = std::find_if(
      receiver.shadows.begin(), receiver.shadows.end(),
      [&](const RandomShadow& shadow) { return (point - shadow.centre).norm() < shadow.radius; });
  return found == receiver.shadows.end() ? nullptr : &*found;
}

RandomReceiver draw_receiver(RandomStream& random, const std::vector<MotionStep>& steps, double speed) {
  RandomReceiver receiver;
  receiver.kind =
      one_of(random, {ReceiverKind::kRtk, ReceiverKind::kRtk, ReceiverKind::kGood, ReceiverKind::kPlain,
                      ReceiverKind::kSmooth, ReceiverKind::kDrifting, ReceiverKind::kWhite});
  receiver.period_ms = one_of(random, {2000, 1000, 1000, 200, 200, 100, 100, 50});
  receiver.levels = draw_levels(random, receiver.kind);
  receiver.statuses = draw_statuses(random, receiver.kind);
  draw_declaration(random, receiver);
  receiver.fixed_stretch = draw(random, ranges::kFixedStretch);
  receiver.float_stretch = draw(random, ranges::kFloatStretch);
  const double wrong = draw(random, ranges::kWrongFixShare);
  if (chance(random, 0.5)) receiver.wrong_fix_share = wrong;
  const double outliers = draw(random, ranges::kOutlierShare);
  if (chance(random, 0.5)) receiver.outlier_share = outliers;
  draw_shadows(random, steps, speed, receiver);
  draw_outages(random, static_cast<double>(steps.size()) * kWayStep, receiver);
  return receiver;
}

}  // namespace multipath_localization
