#include "multipath_localization/guidance/route.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace multipath_localization {

namespace {

void require_finite(const std::vector<Eigen::Vector2d>& waypoints) {
  for (const Eigen::Vector2d& waypoint : waypoints) {
    if (!waypoint.allFinite()) throw std::invalid_argument("a waypoint is not finite");
  }
}

double extent_of(const std::vector<Eigen::Vector2d>& waypoints) {
  double extent = 0.0;
  for (const Eigen::Vector2d& waypoint : waypoints) {
    extent = std::max(extent, (waypoint - waypoints.front()).norm());
  }
  return extent;
}

}  // namespace

Route::Route(std::vector<Eigen::Vector2d> waypoints, RouteTasks tasks)
    : waypoints_(std::move(waypoints)), tasks_(std::move(tasks)), extent_(extent_of(waypoints_)) {
  require_finite(waypoints_);
  if (!tasks_.at.empty() && tasks_.at.size() != waypoints_.size()) {
    throw std::invalid_argument("not as many tasks as waypoints");
  }
}

void Route::move(std::vector<Eigen::Vector2d> waypoints) {
  require_finite(waypoints);
  if (waypoints.size() != waypoints_.size()) throw std::invalid_argument("not as many waypoints as before");
  waypoints_ = std::move(waypoints);
  extent_ = extent_of(waypoints_);
}

std::size_t Route::target() const { return empty() ? 0 : passed_ % waypoints_.size(); }

int Route::rounds() const { return empty() ? 0 : static_cast<int>(passed_ / waypoints_.size()); }

double Route::progress() const {
  return empty() ? 0.0 : static_cast<double>(passed_) / static_cast<double>(waypoints_.size());
}

WaypointTask Route::task(std::size_t ahead) const {
  return tasks_.at.empty() ? WaypointTask{} : tasks_.at[(passed_ + ahead) % waypoints_.size()];
}

const Eigen::Vector2d& Route::waypoint(std::size_t ahead) const {
  return waypoints_[(passed_ + ahead) % waypoints_.size()];
}

bool Route::stops(std::size_t ahead) const {
  return task(ahead).wait > 0.0 || task(ahead).reverse != task(ahead + 1).reverse;
}

bool Route::has_arcs() const {
  return std::any_of(tasks_.at.begin(), tasks_.at.end(),
                     [](const WaypointTask& task) { return task.curvature.has_value(); });
}

}  // namespace multipath_localization
