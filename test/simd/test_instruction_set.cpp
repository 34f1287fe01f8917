#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <vector>

#include "instruction_sets.hpp"
#include "simd/instruction_set.hpp"

namespace multipath_localization {
namespace {

double sum_of_squares(const double* values, std::size_t size) {
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i) sum += values[i] * values[i];
  return sum;
}

TEST(InstructionSet, EachRunsTheSameFunction) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1.0);
  for (const InstructionSet set : instruction_sets()) {
    EXPECT_EQ(run<sum_of_squares>(set, static_cast<const double*>(values.data()), values.size()), 338350.0);
  }
}

}  // namespace
}  // namespace multipath_localization
