#include "support/background_writer.hpp"

#include <utility>

namespace multipath_localization {

BackgroundWriter::~BackgroundWriter() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void BackgroundWriter::write(std::function<void()> job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    next_ = std::move(job);
  }
  changed_.notify_one();
}

void BackgroundWriter::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ends_ || next_; });
    if (!next_) return;
    const std::function<void()> job = std::exchange(next_, nullptr);
    lock.unlock();
    job();
    lock.lock();
  }
}

}  // namespace multipath_localization
