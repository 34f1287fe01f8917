#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace multipath_localization {

/// Particles that are worked on together: what is computed of them on the way stays in the first-level cache.
inline constexpr std::size_t kBlockSize = 256;

/// Blocks that `size` particles fill; the last may be shorter.
constexpr std::size_t blocks_of(std::size_t size) { return (size + kBlockSize - 1) / kBlockSize; }

/// First particle of a block.
constexpr std::size_t block_begin(std::size_t block) { return block * kBlockSize; }

/// Particles of a block among `size`.
constexpr std::size_t block_length(std::size_t block, std::size_t size) {
  return size - block_begin(block) < kBlockSize ? size - block_begin(block) : kBlockSize;
}

/// The poses of one block [m, rad], where they are stored.
struct PoseBlock {
  double* x;
  double* y;
  double* yaw;
  std::size_t size;
};

/// A number per particle of a block.
using BlockValues = std::array<double, kBlockSize>;

}  // namespace multipath_localization
