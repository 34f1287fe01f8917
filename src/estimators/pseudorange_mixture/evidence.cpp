#include "estimators/pseudorange_mixture/evidence.hpp"

#include <algorithm>

namespace multipath_localization {

namespace {

constexpr double kWithinSigmas = 2.0;  // of where the others are, no place is less probable

}  // namespace

double evidence_share(double information, double unseen, double evidence_time) {
  return std::min(1.0, std::max(information, unseen) / evidence_time);
}

double log_probability_of_place(double distance, double sigma, double delay) {
  return -std::max(0.0, distance - kWithinSigmas * sigma) / delay;
}

}  // namespace multipath_localization
