#pragma once

#include <sensor_msgs/NavSatFix.h>

#include <cstdint>
#include <deque>
#include <optional>

namespace multipath_localization {

/// The fixes that came in and whose outcome is open, so that each is reported once and with its own header.
class FixLedger {
 public:
  struct Entry {
    sensor_msgs::NavSatFix fix;
    std::uint32_t sequence = 0;  ///< counts from 1
  };

  /// Numbers a fix and keeps it.
  void open(const sensor_msgs::NavSatFix& fix);

  /// Takes out the oldest entry with this stamp [s].
  std::optional<Entry> close(double stamp);

  /// Stamp of the oldest entry [s], nothing when none is open.
  [[nodiscard]] std::optional<double> oldest() const;

 private:
  std::deque<Entry> entries_;
  std::uint32_t sequence_ = 0;
};

}  // namespace multipath_localization
