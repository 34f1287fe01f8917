#pragma once

#include <utility>

namespace multipath_localization {

/// What the loops over particles are compiled for. Results differ in their last bits from one to the other
/// (fused multiply-add, order of sums), never from run to run.
enum class InstructionSet {
  kPlain,  ///< what every machine of the architecture has
  kAvx2,   ///< AVX2 and FMA of amd64; plain elsewhere
};

/// The best of this machine.
InstructionSet best_instruction_set();

namespace compiled {

template <auto Stage, class... Arguments>
__attribute__((flatten, noinline)) auto plain(Arguments... arguments) {
  return Stage(arguments...);
}

#if defined(__x86_64__)
template <auto Stage, class... Arguments>
__attribute__((flatten, noinline, target("avx2,fma"))) auto avx2(Arguments... arguments) {
  return Stage(arguments...);
}
#endif

}  // namespace compiled

/// Calls the function `Stage`, compiled, with all that it calls, for one instruction set. Arguments go by
/// value: what is reached through a reference cannot be told apart from what a loop writes, and stops it from
/// being vectorised.
template <auto Stage, class... Arguments>
auto run(InstructionSet set, Arguments... arguments) {
#if defined(__x86_64__)
  if (set == InstructionSet::kAvx2) return compiled::avx2<Stage>(arguments...);
#else
  static_cast<void>(set);
#endif
  return compiled::plain<Stage>(arguments...);
}

}  // namespace multipath_localization
