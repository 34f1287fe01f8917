#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace multipath_localization {

/// Threads that sleep until there is work. Of as much work each does the same share every time, so that what
/// it works on stays in its processor's cache.
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
  void serve(std::size_t share);
  void take_part(std::size_t share);

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  std::size_t round_ = 0;    ///< of work, counted
  std::size_t working_ = 0;  ///< threads that are not through with this round
  bool ends_ = false;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace multipath_localization
