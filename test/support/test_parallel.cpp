#include <gtest/gtest.h>

#include <vector>

#include "support/parallel.hpp"

namespace multipath_localization {
namespace {

TEST(ForEachIndex, CallsEachOnceInAnyNumberOfThreads) {
  for (const std::size_t jobs : {std::size_t{1}, std::size_t{3}, std::size_t{100}}) {
    std::vector<int> calls(17, 0);
    for_each_index(calls.size(), jobs, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(17, 1));
  }
  for_each_index(0, 2, [](std::size_t) { FAIL(); });
}

TEST(ThreadCpuTime, DoesNotGoBack) {
  const double before = thread_cpu_time();
  EXPECT_GE(thread_cpu_time(), before);
}

}  // namespace
}  // namespace multipath_localization
