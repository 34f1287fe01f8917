#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace multipath_localization {

/// Threads that sleep until there is work. Which thread does what is left to chance: results must not depend
/// on it.
class WorkerPool {
 public:
  /// The calling thread is one of them, so that 1 starts none.
  explicit WorkerPool(std::size_t threads);
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  ~WorkerPool();

  /// Calls `work(i)` for all i below `count` and returns when all are done. `work` must not throw.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void serve();
  void take_part();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  std::size_t round_ = 0;    ///< of work, counted
  std::size_t working_ = 0;  ///< threads that are not through with this round
  bool ends_ = false;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::vector<std::thread> threads_;
};

}  // namespace multipath_localization
