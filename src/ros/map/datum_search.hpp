#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "multipath_localization/core/geodesy.hpp"
#include "ros/messages/gnss_message.hpp"

namespace multipath_localization {

/// Finds a map's origin by the first measurements, so that none that is alone in what it says decides it.
///
/// The origin is the oldest of three places that agree: no further from the latest than 20 m, three times
/// what both declare, and what a robot can drive meanwhile. Until there are three all wait; then those that
/// agree count, and the others are contradicted. A place that fixes have not driven away from may still be
/// nonsense, as that where a receiver was switched off: measurements over 200 m from those before are
/// contradicted, but when as many in a row agree (3 at least, 20 at most) as have told the first place,
/// theirs is the origin. Once three in a row are 10 m from the origin, it is proven and all pass.
class DatumSearch {
 public:
  /// `max_speed`: of the robot [m/s]. `averaging`: the origin is the median of the places of this time [s],
  /// measurements within it do not count; 0: the first place.
  DatumSearch(const GnssParameters& gnss, double max_speed, double averaging)
      : gnss_(gnss), max_speed_(max_speed), averaging_(averaging) {}

  struct Decided {
    GnssMessage message;
    Reason reason = Reason::kAccepted;  ///< or contradicted, or not started
  };
  /// Takes a message that passed `check`. Returns what is decided by now, in the order it came in.
  std::vector<Decided> add(const GnssMessage& message);

  /// Gives up those that still wait.
  std::vector<GnssMessage> take_waiting();

  /// The origin as far as it is known; it may still move until it is proven.
  [[nodiscard]] const std::optional<Geodetic>& place() const { return place_; }
  [[nodiscard]] bool proven() const { return proven_; }

 private:
  struct Sighting {
    GnssMessage message;
    double stamp = 0.0;
    Geodetic place;
    Eigen::Vector3d in_earth = Eigen::Vector3d::Zero();  ///< at height 0 [m]
    double sigma = 0.0;                                  ///< [m]
  };
  [[nodiscard]] std::optional<Sighting> sighting(const GnssMessage& message) const;
  [[nodiscard]] bool near(const Sighting& a, const Sighting& b, double slack) const;
  std::vector<Decided> follow(const Sighting& seen);
  std::vector<Decided> compare(const Sighting& seen);
  [[nodiscard]] std::size_t needed() const;
  void average(const Sighting& seen);

  GnssParameters gnss_;
  double max_speed_, averaging_;
  std::deque<Sighting> waiting_;    ///< that agree with too few others as yet
  std::optional<Sighting> latest_;  ///< of those that agree
  std::size_t support_ = 0;         ///< how many of these there are
  std::size_t driven_ = 0;          ///< how many in a row are off the origin
  std::vector<Geodetic> places_;    ///< to be averaged
  double first_stamp_ = 0.0;        ///< of them
  std::optional<Geodetic> place_;
  std::optional<Eigen::Vector3d> origin_;  ///< of the first that agreed, in ECEF at height 0 [m]
  bool proven_ = false;
};

}  // namespace multipath_localization
