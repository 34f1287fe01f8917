#include "multipath_localization/guidance/trail.hpp"

#include <algorithm>

namespace multipath_localization {

namespace {

constexpr double kStep = 0.1;  // between places kept [m]
constexpr double kBy = 0.3;    // of a place where the robot has just been [m]

}  // namespace

void Trail::add(const Eigen::Vector2d& position) {
  if (!places_.empty() && (position - places_.back()).norm() < kStep) return;
  places_.push_back(position);
  while (static_cast<double>(places_.size()) * kStep > length_) places_.pop_front();
}

bool Trail::comes_by(const Eigen::Vector2d& place) const {
  return std::any_of(places_.begin(), places_.end(),
                     [&](const Eigen::Vector2d& at) { return (at - place).norm() <= kBy; });
}

}  // namespace multipath_localization
