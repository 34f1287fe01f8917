#pragma once

#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"

namespace multipath_localization {

/// Where map has its origin: configured, saved before, or the median of the first measurements' places. It
/// stays until it is set anew, whatever restarts.
class Datum {
 public:
  /// `configured`: the place told, or nothing; `averaging` in seconds.
  /// Where nothing is configured the datum is that of `file`, and one that comes later is saved there; empty:
  /// no file. Throws ParameterError when the file is damaged.
  Datum(const std::optional<Geodetic>& configured, double averaging, std::string file = "");

  /// Takes where the antenna was at `stamp` [s] while no datum is set.
  void add(double stamp, const Geodetic& place);

  /// Moves map's origin there. Throws std::invalid_argument when the place is not valid.
  void set(const Geodetic& place);

  /// The map frame, null before the datum is set.
  [[nodiscard]] const LocalFrame* map() const { return map_ ? &*map_ : nullptr; }

 private:
  std::optional<LocalFrame> map_;
  double averaging_;
  std::string file_;
  double first_stamp_ = 0.0;
  std::vector<Geodetic> places_;
};

}  // namespace multipath_localization
