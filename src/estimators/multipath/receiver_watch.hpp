#pragma once

#include <optional>

#include "estimators/multipath/explanations.hpp"
#include "estimators/multipath/fix_block.hpp"
#include "multipath_localization/core/fix_check.hpp"

namespace multipath_localization::multipath {

/// Without a fix for longer, wheels are judged without one; the slowest receivers in use send one in two
/// seconds [s].
constexpr double kOutage = 3.0;
constexpr double kShortestTime = 1e-3;  ///< between two fixes of one stamp [s]

/// Collects the fixes of a receiver until they are weighed, and tells when it begins anew.
class ReceiverWatch {
 public:
  /// `now`: since when its errors go on [s].
  explicit ReceiverWatch(double now) : weighed_(now) {}

  /// Why a fix is unusable, or nothing.
  std::optional<Reason> defect(const GnssFix& fix) { return check_.defect(fix); }
  /// Takes a usable fix `now` [s].
  void add(const GnssFix& fix, double now) { block_.add(fix), added_ = now; }
  /// The base has moved on by that, in its own frame.
  void move(const Pose2& step) { block_.move(step); }
  /// A first fix has been used otherwise.
  void begin(double now) { weighed_ = now; }

  /// Whether its fixes are to be weighed now [s].
  [[nodiscard]] bool due(double now) const;
  /// Whether fixes wait for others that do not come. Carried on through an outage they would speak for its
  /// odometry instead of the first fixes after it.
  [[nodiscard]] bool overdue(double now) const;
  /// Its fixes as one, those that agree by a heading of `yaw` [rad], and what led up to it as far as it is
  /// this receiver's; `known`: sigma of the position by then without it [m].
  Sighting take(double now, double yaw, double known);
  /// Variance of what the receiver may still be wrong by since it began anew, an axis [m^2].
  [[nodiscard]] double doubt(double now) const;
  /// Of its last fix that was weighed.
  [[nodiscard]] FixStatus status() const { return status_; }
  /// How many fixes the last one was: so much whiter is their mean than each.
  [[nodiscard]] double fixes_in_block() const { return fixes_in_block_; }

 private:
  /// Whether it has fixed its ambiguities anew, by the level that it tells or else by what it declares.
  [[nodiscard]] bool refixed(FixLevel level, double declared) const;

  static constexpr double kSettling = 5.0;  ///< a receiver that begins anew settles within this time [s]

  FixCheck check_;
  FixBlock block_;
  double weighed_;                         ///< last [s]
  double added_ = 0.0;                     ///< the last fix [s]
  double declared_ = 0.0;                  ///< last [m]
  FixLevel level_ = FixLevel::kUntold;     ///< last
  FixStatus status_ = FixStatus::kSingle;  ///< last
  double reacquired_ = -kSettling;         ///< when it began anew [s]
  double wrong_by_ = 0.0;                  ///< sigma of what it may have begun wrong by [m]
  double fixes_in_block_ = 1.0;
};

}  // namespace multipath_localization::multipath
