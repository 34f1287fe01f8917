#pragma once

#include <cstddef>
#include <functional>

namespace multipath_localization {

/// Calls `work(i)` once for every i below `count`, in up to `jobs` threads. `work` must not throw and shares
/// nothing between calls, so that the number of threads changes no result.
void for_each_index(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& work);

/// Processor time this thread has used [s].
double thread_cpu_time();

}  // namespace multipath_localization
