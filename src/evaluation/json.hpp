#pragma once

#include <string>

namespace multipath_localization {

/// A text as JSON has it, in quotes.
std::string quoted(const std::string& text);

}  // namespace multipath_localization
