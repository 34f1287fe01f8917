#include "simd/particle_cloud.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace multipath_localization {

namespace {

constexpr std::size_t kCandidates = 24;
constexpr std::size_t kProbes = 512;

/// Particles of equal weight that stand for all.
struct Probes {
  std::array<double, kProbes> x;
  std::array<double, kProbes> y;
  std::array<double, kProbes> yaw;
};

int count_within(const Probes* probes, PoseNeighbourhood within) {
  int count = 0;
#pragma omp simd reduction(+ : count)
  for (std::size_t i = 0; i < kProbes; ++i) {
    count += static_cast<int>(membership(within, probes->x[i], probes->y[i], probes->yaw[i]));
  }
  return count;
}

/// How many of a block's cumulated weights, in ascending order, are not above `target`: kBlockSize - 1 at
/// most. Without a branch, that many searches run at a time.
std::size_t first_above(const double* cumulated, double target) {
  std::size_t below = 0;
  for (std::size_t step = kBlockSize / 2; step > 0; step /= 2) {
    below += step * static_cast<std::size_t>(cumulated[below + step - 1] <= target);
  }
  return below;
}

/// Where the cumulated weights reach (k + 1/2) / kProbes of their sum, k = 0 .. kProbes - 1.
std::array<std::size_t, kProbes> evenly_drawn(const BlockWeights& weights) {
  std::array<std::size_t, kProbes> drawn{};
  const double spacing = weights.total() / kProbes;
  const auto target = [&](std::size_t k) { return (static_cast<double>(k) + 0.5) * spacing; };
  const std::size_t blocks = blocks_of(weights.size());
  std::size_t k = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t last = block_length(block, weights.size()) - 1;
    const double* cumulated = weights.cumulated(block);
    const double base = weights.base(block);
    const double per_weight = 1.0 / weights.scale(block);
    for (; k < kProbes && (block + 1 == blocks || target(k) < weights.base(block + 1)); ++k) {
      drawn[k] = block_begin(block) + std::min(first_above(cumulated, (target(k) - base) * per_weight), last);
    }
  }
  return drawn;
}

void add_logarithms(const double* factor, double* log_weight, std::size_t size) {
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) log_weight[i] += elementary::log(factor[i]);
}

double dot(const double* weight, const float* label, std::size_t size) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < size; ++i) sum += weight[i] * static_cast<double>(label[i]);
  return sum;
}

}  // namespace

void ParticleCloud::reset(std::size_t size) {
  for (auto* values : {&now_.x, &now_.y, &now_.yaw, &log_weight_}) values->assign(size, 0.0);
  factor_.resize(size);
  has_factors_ = false;
  now_.member.assign(size, 1.0F);
  now_.label.assign(size, 0.0F);
  weights_.set_equal(size);
}

void ParticleCloud::set_pose(std::size_t i, const Pose2& pose) {
  now_.x[i] = pose.x;
  now_.y[i] = pose.y;
  now_.yaw[i] = pose.yaw;
}

void ParticleCloud::set_log_weight(std::size_t i, double log_weight) {
  log_weight_[i] = log_weight + weights_.log_sum();
  factor_[i] = 1.0;
}

void ParticleCloud::take_in(const double* factor, double* log_weight, std::size_t size) const {
  run<add_logarithms>(set_, factor, log_weight, size);
}

PoseBlock ParticleCloud::poses(std::size_t block) {
  const std::size_t first = block_begin(block);
  return {&now_.x[first], &now_.y[first], &now_.yaw[first], block_length(block, size())};
}

void ParticleCloud::add_block(std::size_t block, const Pose2& reference, PoseSums& sums) {
  const float* members = &now_.member[block_begin(block)];
  sums.add(weights_.scale(block),
           pose_sums(set_, poses(block), weights_.relative(block), members, reference));
}

double ParticleCloud::mean_label() const {
  double sum = 0.0;
  for (std::size_t block = 0; block < blocks_of(size()); ++block) {
    sum += weights_.scale(block) * run<dot>(set_, weights_.relative(block), &now_.label[block_begin(block)],
                                            block_length(block, size()));
  }
  return sum;
}

PoseNeighbourhood ParticleCloud::dominant_neighbourhood(double distance, double turn) const {
  Probes probes;
  const auto drawn = evenly_drawn(weights_);
  for (std::size_t k = 0; k < kProbes; ++k) {
    probes.x[k] = now_.x[drawn[k]];
    probes.y[k] = now_.y[drawn[k]];
    probes.yaw[k] = now_.yaw[drawn[k]];
  }
  PoseNeighbourhood dominant;
  int most = -1;
  for (std::size_t c = 0; c < kCandidates; ++c) {
    const std::size_t candidate = drawn[(2 * c + 1) * kProbes / (2 * kCandidates)];
    const PoseNeighbourhood within{pose(candidate), distance, turn};
    const int count = run<count_within>(set_, &probes, within);
    if (count <= most) continue;
    dominant = within;
    most = count;
    if (most == static_cast<int>(kProbes)) break;
  }
  return dominant;
}

PoseSums ParticleCloud::choose_members(const PoseNeighbourhood& within) {
  PoseSums sums;
  for (std::size_t block = 0; block < blocks_of(size()); ++block) {
    mark_members(set_, poses(block), within, &now_.member[block_begin(block)]);
    add_block(block, within.centre, sums);
  }
  return sums;
}

/// In plain code, because the gathering instructions of AVX2 are slower than single loads.
void ParticleCloud::select(const std::vector<std::uint32_t>& ancestors) {
  const std::size_t size = ancestors.size();
  for (auto* values : {&spare_.x, &spare_.y, &spare_.yaw}) values->resize(size);
  for (auto* values : {&spare_.member, &spare_.label}) values->resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t ancestor = ancestors[i];
    spare_.x[i] = now_.x[ancestor];
    spare_.y[i] = now_.y[ancestor];
    spare_.yaw[i] = now_.yaw[ancestor];
    spare_.member[i] = now_.member[ancestor];
    spare_.label[i] = now_.label[ancestor];
  }
  std::swap(now_, spare_);
  log_weight_.assign(size, 0.0);
  factor_.resize(size);
  has_factors_ = false;
  weights_.set_equal(size);
}

}  // namespace multipath_localization
