#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "tools/benchmark/workload.hpp"

namespace multipath_localization {

inline constexpr char kPerParticle[] = "ns/particle";

/// Counts what an iteration does to `state.range(0)` particles as time per particle.
inline void count_particles(benchmark::State& state) {
  const double done = static_cast<double>(state.iterations()) * static_cast<double>(state.range(0));
  state.counters[kPerParticle] =
      benchmark::Counter(1e-9 * done, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Motion, weights, moments and resampling by a filter that has `step(increment, fix)` and `x()`.
template <class Filter>
void full_step(benchmark::State& state) {
  Filter filter(static_cast<std::size_t>(state.range(0)));
  int step = 0;
  for (auto unused : state) {
    filter.step(workload::increment(step), workload::fix(step));
    ++step;
  }
  benchmark::DoNotOptimize(filter.x());
  count_particles(state);
}

template <class Filter>
void register_full_step(const std::string& name) {
  auto* full = benchmark::RegisterBenchmark(name.c_str(), full_step<Filter>);
  for (const int size : {1000, 10000, 100000}) full->Arg(size);
  full->MinTime(0.05)->Repetitions(15);
}

/// The filters of other libraries, a file each: their headers do not bear each other. Defined where the
/// library is installed.
void register_bfl();
void register_mrpt();

}  // namespace multipath_localization
