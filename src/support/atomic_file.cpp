#include "support/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace multipath_localization {

namespace {

std::system_error failure(int reason, const std::string& file) {
  return {reason, std::generic_category(), file};
}

/// Writes a file and waits until it is on the disk.
void write_through(const std::string& file, const std::string& content) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) throw failure(errno, file);
  const bool written =
      write(descriptor, content.data(), content.size()) == static_cast<ssize_t>(content.size()) &&
      fsync(descriptor) == 0;
  const int reason = errno;
  close(descriptor);
  if (!written) throw failure(reason, file);
}

}  // namespace

void replace_file(const std::string& file, const std::string& content) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty()) fs::create_directories(folder);
  const std::string fresh = file + ".new";
  write_through(fresh, content);
  fs::rename(fresh, file);
}

}  // namespace multipath_localization
