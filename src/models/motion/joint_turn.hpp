#pragma once

#include <limits>
#include <optional>

namespace multipath_localization {

/// What a driver tells of one joint; NaN: not told.
struct JointReading {
  double position = std::numeric_limits<double>::quiet_NaN();  ///< [rad]
  double velocity = std::numeric_limits<double>::quiet_NaN();  ///< [rad/s]

  [[nodiscard]] bool told() const;
};

/// How far a wheel has turned from one reading to the next: by its positions, which lose nothing where
/// readings are lost, or else by its velocity.
///
/// Positions that never leave one turn and have leapt by more than half of one begin anew with each turn of
/// the wheel: of the turns that two of them may stand for, that counts which is nearest to what the velocity
/// says, or to how the wheel turned before.
class JointTurn {
 public:
  /// The turn since the reading before, `duration` [s] ago [rad]; nothing for a first reading, and where the
  /// two do not tell.
  std::optional<double> take(const JointReading& reading, double duration);

 private:
  [[nodiscard]] std::optional<double> turn_to(const JointReading& reading, double duration);

  std::optional<JointReading> before_;
  bool begins_anew_ = false;
  double rate_ = 0.0;                                        ///< over the last turn [rad/s]
  double lowest_ = std::numeric_limits<double>::infinity();  ///< position so far [rad]
  double highest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace multipath_localization
