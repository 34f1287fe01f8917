#include "simd/block_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "simd/elementary.hpp"

namespace multipath_localization {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largest_of(const double* values, std::size_t size) {
  double largest = -kInfinity;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < size; ++i) largest = values[i] > largest ? values[i] : largest;
  return largest;
}

/// Weights relative to the largest logarithm; gives the sum of their squares.
double exponentiate(const double* log_weight, const double* factor, double log_largest, double* weight,
                    std::size_t size) {
  double sum_of_squares = 0.0;
#pragma omp simd reduction(+ : sum_of_squares)
  for (std::size_t i = 0; i < size; ++i) {
    const double w = factor[i] * elementary::exp(log_weight[i] - log_largest);
    weight[i] = w;
    sum_of_squares += w * w;
  }
  return sum_of_squares;
}

/// Prefix sums of a block: of each of eight stretches first, side by side, then each raised by those before
/// it. They never fall, and stand still where a weight is zero.
double cumulate(const double* weight, double* cumulated) {
  constexpr std::size_t kStretches = 8;
  constexpr std::size_t kLength = kBlockSize / kStretches;
  std::array<double, kStretches> reached{};
  for (std::size_t i = 0; i < kLength; ++i) {
    for (std::size_t k = 0; k < kStretches; ++k) {
      reached[k] += weight[k * kLength + i];
      cumulated[k * kLength + i] = reached[k];
    }
  }
  double before = reached[0];
  for (std::size_t k = 1; k < kStretches; ++k) {
#pragma omp simd
    for (std::size_t i = 0; i < kLength; ++i) cumulated[k * kLength + i] += before;
    before += reached[k];
  }
  return before;
}

/// A block of which `length` weights are 1 and the others 0.
void count_up(std::size_t length, double* weight, double* cumulated) {
  const auto ones = static_cast<std::int32_t>(length);
#pragma omp simd
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(kBlockSize); ++i) {
    weight[i] = i < ones ? 1.0 : 0.0;
    cumulated[i] = i < ones ? i + 1 : ones;
  }
}

}  // namespace

void BlockWeights::set_equal(std::size_t size) {
  size_ = size;
  equal_ = true;
  blocks_.assign(blocks_of(size), {});
  relative_.resize(blocks_.size() * kBlockSize);
  cumulated_.resize(relative_.size());
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const std::size_t length = block_length(block, size);
    if (kept_at(block) == block_begin(block))
      count_up(length, &relative_[block_begin(block)], &cumulated_[block_begin(block)]);
    blocks_[block].sum = blocks_[block].sum_of_squares = static_cast<double>(length);
  }
  if (size > 0) join(0.0);
}

void BlockWeights::set(InstructionSet set, std::size_t block, const double* log_weight,
                       const double* factor) {
  const std::size_t length = block_length(block, size_);
  double* weight = &relative_[block_begin(block)];
  Block& result = blocks_[block];
  result.log_largest = run<largest_of>(set, log_weight, length);
  result.sum_of_squares = run<exponentiate>(set, log_weight, factor, result.log_largest, weight, length);
  result.sum = run<cumulate>(set, weight, &cumulated_[block_begin(block)]);
}

bool BlockWeights::normalise() {
  equal_ = false;
  double largest = -kInfinity;
  for (const Block& block : blocks_) largest = std::max(largest, block.log_largest);
  if (!std::isfinite(largest)) {
    set_equal(size_);
    return false;
  }
  join(largest);
  return true;
}

void BlockWeights::join(double log_largest) {
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (Block& block : blocks_) {
    block.scale = std::exp(block.log_largest - log_largest);
    sum += block.scale * block.sum;
    sum_of_squares += block.scale * block.scale * block.sum_of_squares;
  }
  log_sum_ = log_largest + std::log(sum);
  effective_sample_size_ = sum * sum / sum_of_squares;
  double base = 0.0;
  for (Block& block : blocks_) {
    block.scale /= sum;
    block.base = base;
    base += block.scale * block.sum;
  }
}

double BlockWeights::total() const {
  return blocks_.empty() ? 0.0 : blocks_.back().base + blocks_.back().scale * blocks_.back().sum;
}

}  // namespace multipath_localization
