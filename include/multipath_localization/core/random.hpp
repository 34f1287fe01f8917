#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace multipath_localization {

/// Random numbers by counter: a pure function of (seed, step, particle), so that the same seed gives the same
/// bytes whatever the order or thread of evaluation. Threefry4x32 with 12 rounds (Salmon et al., SC 2011).
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint32_t step, std::uint32_t particle)
      : seed_(seed), step_(step), particle_(particle) {}

  /// 32 uniform bits.
  std::uint32_t word();

  /// Uniform in [0, 1), 53 bits.
  double uniform();

  /// Standard normal, by Box-Muller.
  double normal();

 private:
  std::uint64_t seed_;
  std::uint32_t step_;
  std::uint32_t particle_;
  std::uint32_t block_ = 0;
  int used_ = 4;
  bool has_spare_ = false;
  double spare_ = 0.0;
  std::array<std::uint32_t, 4> words_{};
};

/// N independent standard normals, the next that the stream gives.
template <int N>
Eigen::Matrix<double, N, 1> normals(RandomStream& random) {
  Eigen::Matrix<double, N, 1> z;
  for (int i = 0; i < N; ++i) z(i) = random.normal();
  return z;
}

/// The Threefry4x32 bijection: four words of output per counter and key. Instantiated for 12 rounds and for
/// the 20 that published vectors are for.
template <int Rounds = 12>
std::array<std::uint32_t, 4> threefry4x32(const std::array<std::uint32_t, 4>& counter,
                                          const std::array<std::uint32_t, 4>& key);

}  // namespace multipath_localization
