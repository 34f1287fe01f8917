#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace multipath_localization {

/// Writes in a thread of its own, so that who has something to save need not wait for the disk. Where it does
/// not keep up, the latest counts: what still waits when the next comes is not written.
class BackgroundWriter {
 public:
  BackgroundWriter() : thread_([this] { run(); }) {}
  /// Waits until the last is written.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// Has `job` done soon, which must not throw.
  void write(std::function<void()> job);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> next_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace multipath_localization
