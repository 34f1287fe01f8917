#pragma once

#include <deque>
#include <optional>

#include "multipath_localization/core/tilt.hpp"
#include "multipath_localization/localization/gravity_filter.hpp"

namespace multipath_localization {

/// What becomes of roll and pitch.
enum class TiltStanding {
  kAbsent,       ///< no sample has told them yet
  kUsed,         ///< the base is levelled by them
  kSilent,       ///< nothing new has come for a while
  kImplausible,  ///< by the last sample the base leans as no robot does
};

/// A sentence on it: "roll and pitch used".
const char* to_string(TiltStanding standing);

/// Roll and pitch of the last seconds as an inertial sensor tells them: by its orientation, and where that is
/// missing, or over 30 degrees off gravity as one in NED is, by its accelerations.
///
/// When nothing new comes, the tilt holds for a second and then fades to level within three. A sensor that
/// measures accelerations or rates and says the same to the bit says nothing new. One that leans by over 45
/// degrees is not believed.
class TiltRecord {
 public:
  /// Takes what the base does; increments in order.
  void drive(const OdometryIncrement& motion) { gravity_.drive(motion); }

  /// Takes a sample. One that is not finite is left out, as is one that is not later than the last, unless it
  /// goes back by over a second: then the clock has, and what was before is forgotten.
  void add(const InertialSample& sample);

  /// The tilt at a stamp [s], by the last sample up to then; level where none is near enough.
  [[nodiscard]] Tilt at(double stamp) const;

  /// As of `now` [s].
  [[nodiscard]] TiltStanding standing(double now) const;

 private:
  struct Told {
    double stamp = 0.0;  ///< [s]
    Tilt tilt;
  };
  [[nodiscard]] bool repeats(const InertialSample& sample) const;
  /// Upwards in the base by what is to be believed of the sample.
  [[nodiscard]] std::optional<Eigen::Vector3d> up(const InertialSample& sample) const;

  GravityFilter gravity_;
  std::optional<InertialSample> last_;
  std::deque<Told> told_;
  bool implausible_ = false;
};

}  // namespace multipath_localization
