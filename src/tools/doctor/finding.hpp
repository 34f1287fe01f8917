#pragma once

#include <string>
#include <vector>

namespace multipath_localization {

/// What a check found: all is well, there is something to fix, or these messages cannot tell.
struct Finding {
  enum class Verdict { kPass, kFix, kUntold };

  Verdict verdict = Verdict::kPass;
  std::string what;    ///< one sentence on what was seen
  std::string remedy;  ///< of something to fix: the line to add or change
};

using Findings = std::vector<Finding>;

inline Finding pass(const std::string& what) { return {Finding::Verdict::kPass, what, ""}; }
inline Finding fix(const std::string& what, const std::string& remedy) {
  return {Finding::Verdict::kFix, what, remedy};
}
inline Finding untold(const std::string& what) { return {Finding::Verdict::kUntold, what, ""}; }

/// "PASS", "FIX" or "----" and the sentence, the remedy on a line of its own.
std::string to_text(const Finding& finding);

/// As printf.
std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace multipath_localization
