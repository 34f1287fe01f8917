#pragma once

#include <vector>

#include "simd/instruction_set.hpp"

namespace multipath_localization {

/// All that this machine can run.
inline std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets = {InstructionSet::kPlain};
  if (best_instruction_set() != InstructionSet::kPlain) sets.push_back(best_instruction_set());
  return sets;
}

}  // namespace multipath_localization
