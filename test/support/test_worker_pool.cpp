#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <thread>
#include <vector>

#include "support/worker_pool.hpp"

namespace multipath_localization {
namespace {

TEST(WorkerPool, DoesEachPieceOfWorkOnceWhateverTheNumberOfThreads) {
  for (const std::size_t threads : {1U, 2U, 5U}) {
    WorkerPool pool(threads);
    for (const std::size_t count : {0U, 1U, 3U, 1000U}) {
      std::vector<std::atomic<int>> done(count);
      for (int round = 0; round < 20; ++round) pool.for_each(count, [&](std::size_t i) { ++done[i]; });
      for (const auto& times : done) EXPECT_EQ(times, 20);
    }
  }
}

TEST(WorkerPool, AThreadDoesTheSameShareOfAsMuchWorkEveryTime) {
  WorkerPool pool(3);
  std::vector<std::thread::id> first(100);
  pool.for_each(first.size(), [&](std::size_t i) { first[i] = std::this_thread::get_id(); });
  EXPECT_EQ(std::set<std::thread::id>(first.begin(), first.end()).size(), 3U);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::thread::id> doer(first.size());
    pool.for_each(doer.size(), [&](std::size_t i) { doer[i] = std::this_thread::get_id(); });
    EXPECT_EQ(doer, first);
  }
}

}  // namespace
}  // namespace multipath_localization
