#include "multipath_localization/guidance/path_progress.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/plane.hpp"

namespace multipath_localization {

namespace {

constexpr double kArrived = 0.03;  // short of the goal: the rest is braked away [m]
constexpr double kCatchUp = 0.1;   // that the place on the path may change by beside the base's own way [m]

}  // namespace

PathProgress::PathProgress(std::vector<Eigen::Vector2d> vertices, std::size_t first, const PassingRule& rule,
                           const Eigen::Vector2d& position, const std::vector<double>& curvatures)
    : vertices_(std::move(vertices)),
      next_(first),
      rule_(rule),
      path_(curvatures.empty() ? Path(vertices_, rule.radius) : Path(vertices_, curvatures, rule.radius)),
      station_(path_.nearest(position, path_.station(next_ - 1) - rule.radius, path_.station(next_))),
      position_(position) {}

PathProgress::PathProgress(Path path, const PassingRule& rule)
    : vertices_({path.at(0.0).position, path.at(path.length()).position}),
      next_(1),
      rule_(rule),
      path_(std::move(path)),
      station_(0.0),
      winds_(true),
      position_(vertices_.front()) {}

bool PathProgress::passes(const Pose2& pose) {
  if (done()) return false;
  follow(pose.position());
  if (comes_to_rest()) return arrived(pose);
  const Eigen::Vector2d beyond = pose.position() - vertices_[next_];
  const bool further = station_ >= path_.station(next_) && deviation(pose.position()) <= rule_.radius;
  return beyond.norm() <= rule_.radius || further || crossed(beyond);
}

void PathProgress::follow(const Eigen::Vector2d& position) {
  // A path bends towards the base, which may be aside: its place on it then moves faster than the base.
  const double reach = 2.0 * (position - position_).norm() + kCatchUp;
  position_ = position;
  station_ = path_.nearest(position, std::max(earliest_, station_ - reach), station_ + reach);
}

void PathProgress::pass_next() {
  const double station = path_.station(next_++);
  const PathPiece& bend = path_.pieces()[path_.piece_at(station)];
  // Round a bend that the base cannot follow it does not come by itself: beyond it lies where to go.
  const bool cusp = bend.begin == station && path_.turns_back_at(station);
  if (cusp || std::abs(bend.curvature) > 2.0 * rule_.tightest_curvature) {
    earliest_ = std::max(earliest_, cusp ? station : bend.end());
    station_ = std::max(station_, earliest_);
  }
}

double PathProgress::deviation(const Eigen::Vector2d& position) const {
  const PathPoint foot = path_.at(station_);
  const Eigen::Vector2d aside = position - foot.position;
  if (station_ < path_.length()) return aside.norm();
  return std::abs(cross({std::cos(foot.heading), std::sin(foot.heading)}, aside));
}

std::size_t PathProgress::bend_before(std::size_t vertex) const {
  std::size_t bend = vertex == 0 ? 0 : vertex - 1;
  while (bend > 0 && (vertices_[bend] - vertices_[vertex]).norm() < rule_.radius) --bend;
  return bend;
}

std::vector<Eigen::Vector2d> PathProgress::behind() const {
  const std::size_t last = done() ? vertices_.size() - 1 : bend_before(next_);
  if (last == 0) return {vertices_.front()};
  return {vertices_[bend_before(last)], vertices_[last]};
}

bool PathProgress::crossed(const Eigen::Vector2d& beyond) const {
  const Eigen::Vector2d way = vertices_[next_] - vertices_[bend_before(next_)];
  if (way.isZero()) return false;
  return beyond.dot(way) >= 0.0 &&
         std::abs(cross(way.normalized(), beyond)) <= std::max(rule_.width, rule_.radius);
}

bool PathProgress::arrived(const Pose2& pose) const {
  const bool at_end = station_ >= path_.length() - kArrived;
  if (winds_) return at_end;
  const Eigen::Vector2d ahead = vertices_[next_] - pose.position();
  const double in_reach = ahead.dot(Eigen::Vector2d(std::cos(pose.yaw), std::sin(pose.yaw)));
  if (ahead.norm() <= (at_end ? rule_.radius : kArrived)) return true;
  if (!rule_.turns_on_the_spot && ahead.norm() <= rule_.radius && in_reach <= kArrived) return true;
  const double heading = path_.at(path_.length()).heading;
  const Eigen::Vector2d short_of_it = kArrived * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  return crossed(short_of_it - ahead);
}

}  // namespace multipath_localization
