#pragma once

#include <cstddef>
#include <vector>

#include "tools/doctor/odometry_track.hpp"

namespace multipath_localization {

/// How the way by odometry lies on that by the fixes, piece by piece of some metres, each moved, turned and
/// scaled as suits it best.
struct ShapeFit {
  std::size_t pieces = 0;
  double error = 1.0;  ///< median of what then is left over the extent of the piece; 1: nothing alike
  double mirrored_error = 1.0;  ///< the same turned over
  double rigid_error = 1.0;     ///< as it is, without scaling
  double scale = 1.0;           ///< median of the way by fixes over that by odometry
  double scale_spread = 0.0;    ///< half of what lies between the quartiles of these
  std::size_t alike = 0;        ///< pieces that fit as they are and not turned over
  std::size_t opposite = 0;     ///< pieces that fit turned over and not as they are

  /// Enough pieces for anything below.
  [[nodiscard]] bool has_enough() const;
  /// Enough pieces that have the same shape: then their scale means something.
  [[nodiscard]] bool same_shape() const;
  /// The same shape, and all pieces of one scale.
  [[nodiscard]] bool tells_scale() const;
  /// Enough pieces that have the same shape turned over.
  [[nodiscard]] bool mirrored_shape() const;
  /// Of the same shape and size.
  [[nodiscard]] bool fits() const;
};

ShapeFit fit_shape(const std::vector<GnssFix>& fixes, const OdometryTrack& track);

}  // namespace multipath_localization
