#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "simd/block.hpp"
#include "simd/block_weights.hpp"
#include "simd/instruction_set.hpp"
#include "simd/pose_moments.hpp"

namespace multipath_localization {

/// Weighted poses, a thousand or a hundred thousand, worked on block by block: what a particle filter does
/// with them, whatever moves and weighs them.
class ParticleCloud {
 public:
  explicit ParticleCloud(InstructionSet set = best_instruction_set()) : set_(set) {}

  /// `size` particles at the origin, equally weighted, all of them members.
  void reset(std::size_t size);

  [[nodiscard]] std::size_t size() const { return now_.x.size(); }
  [[nodiscard]] bool empty() const { return now_.x.empty(); }
  [[nodiscard]] InstructionSet instruction_set() const { return set_; }
  [[nodiscard]] Pose2 pose(std::size_t i) const { return {now_.x[i], now_.y[i], now_.yaw[i]}; }
  void set_pose(std::size_t i, const Pose2& pose);

  [[nodiscard]] const BlockWeights& weights() const { return weights_; }
  /// Replaces a weight, by the logarithm; in force after the next `weigh`.
  void set_log_weight(std::size_t i, double log_weight);

  /// A number that goes with each particle when resampled, of the caller's choice.
  [[nodiscard]] float label(std::size_t i) const { return now_.label[i]; }

  /// Calls `move(poses, first)` for each block and gives the sums of where its members then are.
  /// `first` is the number of the block's first particle.
  template <class Move>
  PoseSums move(const Pose2& reference, const Move& move) {
    PoseSums sums;
    for (std::size_t block = 0; block < blocks_of(size()); ++block) {
      move(poses(block), static_cast<std::uint32_t>(block_begin(block)));
      add_block(block, reference, sums);
    }
    return sums;
  }

  /// Calls `add(poses, log_weights, factors, labels)` for each block, which multiplies the weights by a
  /// likelihood: adds part of its logarithm and sets the factors to the rest. Normalises. False when no
  /// particle has any weight left: all are equal then.
  template <class Add>
  bool weigh(const Add& add) {
    for (std::size_t block = 0; block < blocks_of(size()); ++block) {
      double* log_weight = &log_weight_[block_begin(block)];
      double* factor = &factor_[block_begin(block)];
      if (has_factors_) take_in(factor, log_weight, block_length(block, size()));
      add(poses(block), log_weight, factor, &now_.label[block_begin(block)]);
      weights_.set(set_, block, log_weight, factor);
    }
    has_factors_ = weights_.normalise();
    if (!has_factors_) std::fill(log_weight_.begin(), log_weight_.end(), 0.0);
    return has_factors_;
  }

  /// Mean of the labels.
  [[nodiscard]] double mean_label() const;

  /// The heaviest of the neighbourhoods, of this size, of 24 particles that stand at equal steps of the
  /// cumulated weight, so that every mode of mass above 1/24 is tried; masses are taken from 512 particles
  /// drawn likewise.
  [[nodiscard]] PoseNeighbourhood dominant_neighbourhood(double distance, double turn) const;

  /// Makes members of those within the neighbourhood, and of no other, and gives their sums.
  PoseSums choose_members(const PoseNeighbourhood& within);

  /// The particles at `ancestors`, equally weighted: Eqs. (40), (41) of [NIS].
  void select(const std::vector<std::uint32_t>& ancestors);

 private:
  /// What goes with each particle when resampled, a column for each.
  struct Columns {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> yaw;
    std::vector<float> member;  ///< 1 or 0
    std::vector<float> label;
  };

  /// Those of a block, where they are stored.
  PoseBlock poses(std::size_t block);
  /// Adds the logarithms of factors to those of weights.
  void take_in(const double* factor, double* log_weight, std::size_t size) const;
  /// Adds where a block's members are, relative to the reference.
  void add_block(std::size_t block, const Pose2& reference, PoseSums& sums);

  InstructionSet set_;
  Columns now_;
  Columns spare_;                   ///< the next ones are gathered in
  std::vector<double> log_weight_;  ///< up to a constant
  std::vector<double> factor_;      ///< of the weights, beside the logarithm, where there are any
  bool has_factors_ = false;
  BlockWeights weights_;
};

}  // namespace multipath_localization
