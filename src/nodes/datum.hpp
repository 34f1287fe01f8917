#pragma once

#include <optional>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// Where map has its origin: configured, or the median of the first measurements' places. Once set it stays,
/// whatever restarts.
class Datum {
 public:
  /// `configured` is empty or [latitude, longitude, altitude?] in degrees and metres; `averaging` in seconds.
  Datum(const std::vector<double>& configured, double averaging);

  /// Takes where the antenna was at `stamp` [s] while no datum is set.
  void add(double stamp, const Geodetic& place);

  /// The map frame, null before the datum is set.
  [[nodiscard]] const LocalFrame* map() const { return map_ ? &*map_ : nullptr; }

 private:
  std::optional<LocalFrame> map_;
  double averaging_;
  double first_stamp_ = 0.0;
  std::vector<Geodetic> places_;
};

}  // namespace multipath_localization
