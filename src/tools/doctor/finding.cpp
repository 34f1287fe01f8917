#include "tools/doctor/finding.hpp"

#include <cstdarg>
#include <cstdio>

namespace multipath_localization {

std::string to_text(const Finding& finding) {
  if (finding.verdict == Finding::Verdict::kPass) return "PASS  " + finding.what + "\n";
  if (finding.verdict == Finding::Verdict::kUntold) return "----  " + finding.what + "\n";
  return "FIX   " + finding.what + "\n      -> " + finding.remedy + "\n";
}

std::string text(const char* format, ...) {
  char buffer[600];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof(buffer), format, arguments);
  va_end(arguments);
  return buffer;
}

}  // namespace multipath_localization
