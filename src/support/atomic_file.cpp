#include "support/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace multipath_localization {

namespace {

std::system_error failure(int reason, const std::string& file) {
  return {reason, std::generic_category(), file};
}

/// An open file or folder, closed in the end.
class Descriptor {
 public:
  Descriptor(const std::string& file, int flags) : file_(file), number_(open(file.c_str(), flags, 0644)) {
    if (number_ < 0) throw failure(errno, file_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(number_); }

  void write_all(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t written = write(number_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw failure(errno, file_);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// Waits until all is on the disk, where the file system knows of that.
  void sync() const {
    if (fsync(number_) != 0 && errno != EINVAL) throw failure(errno, file_);
  }

 private:
  const std::string& file_;
  int number_;
};

void write_through(const std::string& file, const std::string& content) {
  const Descriptor descriptor(file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
  descriptor.write_all(content);
  descriptor.sync();
}

}  // namespace

void replace_file(const std::string& file, const std::string& content) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty()) fs::create_directories(folder);
  const std::string fresh = file + ".new";
  try {
    write_through(fresh, content);
    fs::rename(fresh, file);
  } catch (const std::system_error&) {
    unlink(fresh.c_str());
    throw;
  }
  const std::string place = folder.empty() ? "." : folder.string();
  Descriptor(place, O_RDONLY | O_DIRECTORY | O_CLOEXEC).sync();  // the new name is in the folder
}

}  // namespace multipath_localization
