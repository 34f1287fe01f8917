#pragma once

#include <rosbag/bag.h>

#include <functional>
#include <string>

namespace multipath_localization {

/// Calls `use` with a bag opened to read. Throws DriveError that names the file and says why it cannot be
/// read, of one without its index or cut off with the command that mends it.
void with_bag(const std::string& file, const std::function<void(const rosbag::Bag&)>& use);

/// Whether messages of the connection are of a type that is read of bags, but not of this machine's version
/// of it (by md5sum): these cannot be read.
bool of_another_version(const rosbag::ConnectionInfo& connection);

}  // namespace multipath_localization
