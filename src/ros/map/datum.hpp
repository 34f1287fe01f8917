#pragma once

#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "ros/map/datum_search.hpp"

namespace multipath_localization {

/// Where map has its origin: configured, saved before, or found by the first measurements (DatumSearch). It
/// stays until it is set anew, whatever restarts.
class Datum {
 public:
  /// `configured`: the place told, or nothing. Where nothing is configured the datum is that of `file`, and
  /// one that comes later is saved there, a found one once it is proven; empty: no file. Throws
  /// ParameterError when the file is damaged.
  Datum(const std::optional<Geodetic>& configured, DatumSearch search, std::string file = "");

  /// What became of measurements, and whether map's origin has left where it was before.
  struct Admission {
    std::vector<DatumSearch::Decided> decided;
    bool moved = false;
  };
  /// Looks for the datum by a message that passed `check`. With one that was told, all are accepted.
  Admission admit(const GnssMessage& message);
  /// Forgets the measurements that wait for others to agree with.
  void drop_waiting() { search_.take_waiting(); }

  /// Moves map's origin there. Throws std::invalid_argument when the place is not valid.
  void set(const Geodetic& place);

  /// The map frame, null before the datum is set.
  [[nodiscard]] const LocalFrame* map() const { return map_ ? &*map_ : nullptr; }
  /// Whether it will stay: told, or proven by measurements.
  [[nodiscard]] bool settled() const { return told_ || search_.proven(); }
  /// Says how far the datum is from a place where a measurement is, and what to do when it is wrong.
  [[nodiscard]] std::string distance_to(const Geodetic& place) const;

 private:
  void save() const;

  DatumSearch search_;
  std::string file_;
  std::optional<LocalFrame> map_;
  bool told_ = false;       ///< not found
  bool from_file_ = false;  ///< saved by a run before
};

/// "[latitude, longitude]" with as many decimals as a datum needs.
std::string to_text(const Geodetic& place);

/// How far it is from a datum to a place in a straight line, heights left out [m].
double distance(const Geodetic& datum, const Geodetic& place);

}  // namespace multipath_localization
