#pragma once

#include <string>

namespace multipath_localization {

/// Writes a file as a whole, by way of `file`.new: content and name are on the disk afterwards, and no moment
/// leaves half of it behind. Missing folders are made. Throws std::system_error where it cannot: the old file
/// is left, and no `file`.new.
void replace_file(const std::string& file, const std::string& content);

}  // namespace multipath_localization
