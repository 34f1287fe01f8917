#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

#include "multipath_localization/FixReport.h"

namespace multipath_localization {

/// The reports on measurements whose outcome is open, so that each is given once and with its own header.
class ReportLedger {
 public:
  /// Numbers a report, counting from 1.
  FixReport numbered(FixReport report);

  /// The same, and keeps it.
  void open(const FixReport& report) { open_.push_back(numbered(report)); }

  /// Takes out the oldest report of this kind and stamp [s].
  std::optional<FixReport> close(std::string_view kind, double stamp);

  /// Takes out the oldest report.
  std::optional<FixReport> close_oldest();

 private:
  std::deque<FixReport> open_;
  std::uint32_t sequence_ = 0;
};

}  // namespace multipath_localization
