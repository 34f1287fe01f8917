#include "multipath_localization/guidance/stopover.hpp"

#include <algorithm>
#include <utility>

#include "support/plain_numbers.hpp"

namespace multipath_localization {

bool Stopover::end() { return std::exchange(left_, 0.0) > 0.0; }

bool Stopover::lasts(double now) {
  if (left_ > 0.0 && seen_ && now > *seen_) left_ = std::max(0.0, left_ - (now - *seen_));
  seen_ = now;
  return left_ > 0.0;
}

std::string Stopover::status() const {
  return by_call() ? "waiting for resume" : "waiting for " + fixed_text(std::ceil(left_), 0) + " s";
}

}  // namespace multipath_localization
