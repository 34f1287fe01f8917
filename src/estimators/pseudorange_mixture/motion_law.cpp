#include "estimators/pseudorange_mixture/motion_law.hpp"

#include <cmath>

namespace multipath_localization {

MotionLaws::Matrix MotionLaws::transitions(double dt) const {
  Matrix result{};
  for (std::size_t i = 0; i < kMotionLaws; ++i) {
    double others = 0.0;
    for (std::size_t j = 0; j < kMotionLaws; ++j) others += j == i ? 0.0 : entering[j];
    const double stay = std::exp(-dt * leaving[i]);
    for (std::size_t j = 0; j < kMotionLaws; ++j) {
      result[i][j] = j == i ? stay : (1.0 - stay) * entering[j] / others;
    }
  }
  return result;
}

const MotionLaws& laws_of_wheels() {
  // A slip lasts some seconds; a wheel that says nothing is a fault that ends, its noise a habit that stays.
  static const MotionLaws laws{{{{0.03, 2.0, 0.0, false},
                                 {0.15, 2.0, 0.015, false},
                                 {0.75, 2.0, 0.075, false},
                                 {3.75, 2.0, 0.3, true}}},
                               {0.9, 0.06, 0.03, 0.01},
                               {0.003, 0.003, 0.003, 0.3},
                               {1.0, 1.0, 1.0, 1.5}};
  return laws;
}

const MotionLaws& laws_without_wheels() {
  // Velocity sigma and time give accelerations of 0.3, 1 and 3 m/s in the root of a second.
  static const MotionLaws laws{
      {{{0.02, 0.5, 0.0, true}, {1.6, 60.0, 0.05, true}, {5.5, 60.0, 0.3, true}, {16.0, 60.0, 0.5, true}}},
      {0.25, 0.25, 0.25, 0.25},
      {0.1, 0.1, 0.1, 0.2},
      {1.0, 1.0, 1.0, 0.5}};
  return laws;
}

}  // namespace multipath_localization
