#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tools/doctor/finding.hpp"

namespace multipath_localization {

/// Whether there is a finding to fix that says `what` and whose remedy says `remedy`.
inline testing::AssertionResult ToFix(const Findings& findings, const std::string& what,
                                      const std::string& remedy) {
  std::string all;
  for (const Finding& finding : findings) {
    const bool said = finding.what.find(what) != std::string::npos;
    const bool helped = finding.remedy.find(remedy) != std::string::npos;
    if (finding.verdict == Finding::Verdict::kFix && said && helped) return testing::AssertionSuccess();
    all += to_text(finding);
  }
  return testing::AssertionFailure() << "found:\n" << all;
}

/// Whether there is nothing to fix, and something that passed.
inline testing::AssertionResult Passes(const Findings& findings) {
  std::string to_fix;
  bool passed = false;
  for (const Finding& finding : findings) {
    if (finding.verdict == Finding::Verdict::kFix) to_fix += to_text(finding);
    passed = passed || finding.verdict == Finding::Verdict::kPass;
  }
  if (passed && to_fix.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << to_fix << (passed ? "" : "nothing passed");
}

/// Whether the messages do not tell.
inline bool Untold(const Findings& findings) {
  return findings.size() == 1 && findings.front().verdict == Finding::Verdict::kUntold;
}

}  // namespace multipath_localization
