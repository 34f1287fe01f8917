#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rinex/point_positioning.hpp"

namespace multipath_localization {

/// Corrects what a receiver measures while it is measured, by the navigation data known at that moment.
class LivePositioning {
 public:
  /// What the last epoch was made of.
  struct Standing {
    std::size_t heard = 0;           ///< satellites
    std::size_t with_ephemeris = 0;  ///< of them, with one that may be used
    std::size_t used = 0;            ///< of these, above the mask
    std::string shortage;            ///< why nothing came of it; empty where something did
  };

  explicit LivePositioning(const PositioningSettings& settings) : positioning_(navigation_, settings) {}
  LivePositioning(const LivePositioning&) = delete;
  LivePositioning& operator=(const LivePositioning&) = delete;
  ~LivePositioning() = default;

  /// To be added to as satellites broadcast.
  [[nodiscard]] Navigation& navigation() { return navigation_; }

  /// Nothing as long as too few ephemerides are known for a first position, and without satellites above the
  /// mask: `standing` says why.
  std::optional<CorrectedEpoch> correct(const RawEpoch& raw);

  [[nodiscard]] const Standing& standing() const { return standing_; }

 private:
  Navigation navigation_;
  PointPositioning positioning_;
  Standing standing_;
};

}  // namespace multipath_localization
