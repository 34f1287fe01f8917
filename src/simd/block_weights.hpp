#pragma once

#include <cstddef>
#include <vector>

#include "simd/block.hpp"
#include "simd/instruction_set.hpp"

namespace multipath_localization {

/// Weights of any number of particles, from logarithms that may lie anywhere. Each block is kept relative to
/// its largest logarithm, so that one pass over a block does all; blocks are joined in their order, so that
/// the result does not depend on who worked on which.
class BlockWeights {
 public:
  /// `size` equal weights.
  void set_equal(std::size_t size);

  /// Takes the weights of a block, `factor` e^`log_weight`, up to a constant that all blocks share; factors
  /// are 1..1e3. A logarithm that is NaN counts as no weight. Different blocks may be set at the same time.
  void set(InstructionSet set, std::size_t block, const double* log_weight, const double* factor);

  /// Joins the blocks after all were set: weights then sum to 1, Eq. (34) of [NIS]. When no particle has any
  /// weight all become equal, and the answer is false: the measurement excluded every particle.
  bool normalise();

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double operator[](std::size_t i) const {
    return relative(i / kBlockSize)[i % kBlockSize] * blocks_[i / kBlockSize].scale;
  }

  /// log of the sum of the weights as given: subtracting it from their logarithms normalises these.
  [[nodiscard]] double log_sum() const { return log_sum_; }

  /// 1 / sum w^2, Eq. (39) of [NIS]: 1 .. size.
  [[nodiscard]] double effective_sample_size() const { return effective_sample_size_; }

  /// Weights of a block up to the factor `scale(block)`; zeros fill the last block up.
  [[nodiscard]] const double* relative(std::size_t block) const { return &relative_[kept_at(block)]; }
  [[nodiscard]] double scale(std::size_t block) const { return blocks_[block].scale; }

  /// Sum of the weights of a block up to each of its particles, up to the same factor; and of all blocks
  /// before.
  [[nodiscard]] const double* cumulated(std::size_t block) const { return &cumulated_[kept_at(block)]; }
  [[nodiscard]] double base(std::size_t block) const { return blocks_[block].base; }

  /// Sum of all weights as the cumulated sums give it: 1 but for rounding.
  [[nodiscard]] double total() const;

 private:
  struct Block {
    double log_largest = 0.0;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    double scale = 0.0;
    double base = 0.0;
  };

  void join(double log_largest);

  /// Where the weights of a block are: while all are equal, the first stands for every block that is full.
  [[nodiscard]] std::size_t kept_at(std::size_t block) const {
    return equal_ && block + 1 < blocks_.size() ? 0 : block_begin(block);
  }

  std::size_t size_ = 0;
  bool equal_ = true;
  double log_sum_ = 0.0;
  double effective_sample_size_ = 1.0;
  std::vector<double> relative_;
  std::vector<double> cumulated_;
  std::vector<Block> blocks_;
};

}  // namespace multipath_localization
