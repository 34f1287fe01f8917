#include <gtest/gtest.h>

#include "ros/localization_node/report_ledger.hpp"

namespace multipath_localization {
namespace {

FixReport report(const std::string& kind, double stamp) {
  FixReport report;
  report.kind = kind;
  report.header.stamp.fromSec(stamp);
  return report;
}

TEST(ReportLedger, ClosesTheOldestOfAKindAndStampOnce) {
  ReportLedger ledger;
  ledger.open(report("fix", 10.0));
  ledger.open(report("epoch", 10.0));
  ledger.open(report("fix", 10.0));
  EXPECT_EQ(ledger.close("epoch", 10.0)->sequence, 2u);
  EXPECT_EQ(ledger.close("fix", 10.0)->sequence, 1u);
  EXPECT_EQ(ledger.close("fix", 10.0)->sequence, 3u);
  EXPECT_FALSE(ledger.close("fix", 10.0));
}

TEST(ReportLedger, NumbersWhatItDoesNotKeep) {
  ReportLedger ledger;
  EXPECT_EQ(ledger.numbered(report("dual", 1.0)).sequence, 1u);
  ledger.open(report("fix", 2.0));
  EXPECT_EQ(ledger.close_oldest()->sequence, 2u);
  EXPECT_FALSE(ledger.close_oldest());
}

}  // namespace
}  // namespace multipath_localization
