#include "multipath_localization/core/random.hpp"

#include <cmath>

#include "core/threefry.hpp"
#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

template <int Rounds>
std::array<std::uint32_t, 4> threefry4x32(const std::array<std::uint32_t, 4>& counter,
                                          const std::array<std::uint32_t, 4>& key) {
  const auto schedule = threefry::schedule(key);
  std::array<std::uint32_t, 4> x{};
  for (std::size_t i = 0; i < 4; ++i) x[i] = counter[i] + schedule[i];
  threefry::rounds<0, Rounds>(x[0], x[1], x[2], x[3], schedule);
  return x;
}

template std::array<std::uint32_t, 4> threefry4x32<12>(const std::array<std::uint32_t, 4>& counter,
                                                       const std::array<std::uint32_t, 4>& key);
template std::array<std::uint32_t, 4> threefry4x32<20>(const std::array<std::uint32_t, 4>& counter,
                                                       const std::array<std::uint32_t, 4>& key);

std::uint32_t RandomStream::word() {
  if (used_ == 4) {
    words_ =
        threefry4x32<12>({particle_, step_, block_++, 0},
                         {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32), 0, 0});
    used_ = 0;
  }
  return words_[static_cast<std::size_t>(used_++)];
}

double RandomStream::uniform() {
  const std::uint64_t high = word();
  const std::uint64_t low = word();
  return static_cast<double>(((high << 32) | low) >> 11) * 0x1p-53;
}

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  const double angle = 2.0 * kPi * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace multipath_localization
