#include <gtest/gtest.h>

#include "multipath_localization/core/worker_pool.hpp"

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

}  // namespace
}  // namespace multipath_localization
