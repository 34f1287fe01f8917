#include "support/worker_pool.hpp"

namespace multipath_localization {

WorkerPool::WorkerPool(std::size_t threads) {
  for (std::size_t share = 1; share < threads; ++share) {
    threads_.emplace_back([this, share] { serve(share); });
  }
}

WorkerPool::~WorkerPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::for_each(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (threads_.empty()) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = &work;
    count_ = count;
    working_ = threads_.size();
    ++round_;
  }
  wake_.notify_all();
  take_part(0);
  std::unique_lock<std::mutex> lock(mutex_);
  done_.wait(lock, [this] { return working_ == 0; });
}

void WorkerPool::take_part(std::size_t share) {
  const std::size_t shares = threads_.size() + 1;
  const std::size_t end = (share + 1) * count_ / shares;
  for (std::size_t i = share * count_ / shares; i < end; ++i) (*work_)(i);
}

void WorkerPool::serve(std::size_t share) {
  std::size_t served = 0;
  for (;;) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [&] { return ends_ || round_ != served; });
      if (ends_) return;
      served = round_;
    }
    take_part(share);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--working_ == 0) done_.notify_one();
  }
}

}  // namespace multipath_localization
