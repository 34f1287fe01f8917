#include "ros/localization_node/report_ledger.hpp"

#include <algorithm>

namespace multipath_localization {

FixReport ReportLedger::numbered(FixReport report) {
  report.sequence = ++sequence_;
  return report;
}

std::optional<FixReport> ReportLedger::close(std::string_view kind, double stamp) {
  const auto report = std::find_if(open_.begin(), open_.end(), [&](const FixReport& r) {
    return r.kind == kind && r.header.stamp.toSec() == stamp;
  });
  if (report == open_.end()) return {};
  std::optional<FixReport> closed(*report);
  open_.erase(report);
  return closed;
}

std::optional<FixReport> ReportLedger::close_oldest() {
  if (open_.empty()) return {};
  std::optional<FixReport> closed(open_.front());
  open_.pop_front();
  return closed;
}

}  // namespace multipath_localization
