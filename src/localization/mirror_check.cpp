#include "multipath_localization/localization/mirror_check.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace multipath_localization {

namespace {

constexpr double kSpacing = 1.0;     ///< of pairs, at least [m]
constexpr double kWindow = 40.0;     ///< [m]
constexpr std::size_t kFewest = 15;  ///< pairs that tell
constexpr double kBadFit = 2.0;      ///< of the way as it is, at least [m]
constexpr double kBetter = 4.0;      ///< times, by which it fits better turned over

using Complex = std::complex<double>;

Complex complex_of(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

}  // namespace

void MirrorCheck::clear() { *this = MirrorCheck(); }

void MirrorCheck::add(const OdometryIncrement& u) {
  base_in_odom_ = base_in_odom_ * displacement(u);
  driven_ += ground_speed(u) * u.duration;
}

void MirrorCheck::add(const GnssFix& fix) {
  if (!pairs_.empty() && driven_ - pairs_.back().driven < kSpacing) return;
  pairs_.push_back({driven_, base_in_odom_ * fix.antenna_in_base, fix.position});
  while (pairs_.front().driven < driven_ - kWindow) pairs_.pop_front();
  if (pairs_.size() >= kFewest) decide();
}

/// Laid on each other by the best turn, with both middles at zero, n rms^2 = sum |z|^2 + |w|^2 - 2 |sum z
/// w'|, w' the conjugate of w, or, turned over, w itself.
void MirrorCheck::decide() {
  const auto count = static_cast<double>(pairs_.size());
  Complex z_middle;
  Complex w_middle;
  for (const Pair& pair : pairs_) {
    z_middle += complex_of(pair.in_map) / count;
    w_middle += complex_of(pair.in_odom) / count;
  }
  double squares = 0.0;
  Complex as_it_is;
  Complex turned_over;
  for (const Pair& pair : pairs_) {
    const Complex z = complex_of(pair.in_map) - z_middle;
    const Complex w = complex_of(pair.in_odom) - w_middle;
    squares += std::norm(z) + std::norm(w);
    as_it_is += z * std::conj(w);
    turned_over += z * w;
  }
  const auto rms = [&](const Complex& product) {
    return std::sqrt(std::max(0.0, squares - 2.0 * std::abs(product)) / count);
  };
  const double proper = rms(as_it_is);
  const double mirrored = rms(turned_over);
  if (proper > std::max(kBadFit, kBetter * mirrored)) mirrored_ = true;
  if (mirrored > std::max(kBadFit, kBetter * proper)) mirrored_ = false;
}

}  // namespace multipath_localization
