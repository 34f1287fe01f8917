#include "multipath_localization/guidance/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

constexpr double kStraight = 1e-6;        // a corner that turns less bends nothing [rad]
constexpr double kCusp = 1e-3;            // pieces follow each other without a turn, but for cusps [rad]
constexpr double kSmallestRadius = 1e-3;  // an arc below that is a cusp [m]

Eigen::Vector2d along(double heading) { return {std::cos(heading), std::sin(heading)}; }

double direction(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d way = to - from;
  return std::atan2(way.y(), way.x());
}

/// Indices of the first and last vertex and of those at least `spacing` from the one before and the last.
std::vector<std::size_t> spaced(const std::vector<Eigen::Vector2d>& vertices, double spacing) {
  const auto near = [&](std::size_t a, std::size_t b) {
    return (vertices[a] - vertices[b]).norm() < spacing;
  };
  std::vector<std::size_t> kept = {0};
  const std::size_t last = vertices.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    if (!near(i, kept.back())) kept.push_back(i);
  }
  while (kept.size() > 1 && near(kept.back(), last)) kept.pop_back();
  if (last > 0) kept.push_back(last);
  return kept;
}

}  // namespace

PathPoint PathPiece::at(double u) const {
  const double turn = curvature * u;
  const double chord = std::abs(turn) < kStraight ? u : 2.0 * std::sin(0.5 * turn) / curvature;
  return {start + chord * along(heading + 0.5 * turn), heading + turn, curvature};
}

double PathPiece::nearest(const Eigen::Vector2d& position, double from, double to) const {
  if (curvature == 0.0) return std::clamp((position - start).dot(along(heading)), from, to);
  const double side = std::copysign(0.5 * kPi, curvature);
  const Eigen::Vector2d centre = start + along(heading + side) / std::abs(curvature);
  const double turn =
      angle_difference(direction(centre, position) + side, heading + 0.5 * curvature * length);
  return std::clamp(0.5 * length + turn / curvature, from, to);
}

Path::Path(const std::vector<Eigen::Vector2d>& vertices, double corner_radius) {
  const std::vector<std::size_t> bends = spaced(vertices, corner_radius);
  const Eigen::Vector2d& second = vertices[bends.size() > 1 ? bends[1] : 0];
  const double heading = direction(vertices.front(), second);
  pieces_.push_back({0.0, 0.0, vertices.front(), heading, 0.0});
  corners_.push_back(0.0);
  for (std::size_t i = 1; i + 1 < bends.size(); ++i) {
    add_corner(vertices[bends[i - 1]], vertices[bends[i]], vertices[bends[i + 1]], corner_radius);
  }
  add_piece((vertices.back() - pieces_.back().at(pieces_.back().length).position).norm(), 0.0);
  corners_.push_back(length());
  find_stations(vertices, bends);
}

Path::Path(const std::vector<Eigen::Vector2d>& vertices, const std::vector<double>& curvatures,
           double corner_radius) {
  pieces_.push_back({0.0, 0.0, vertices.front(), direction(vertices[0], vertices[1]), 0.0});
  corners_.push_back(0.0);
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if (curvatures[i] != 0.0) {
      add_arc(vertices[i - 1], vertices[i], curvatures[i]);
      continue;
    }
    turn_to(direction(vertices[i - 1], vertices[i]));
    if (i + 1 < vertices.size() && curvatures[i + 1] == 0.0) {
      add_corner(vertices[i - 1], vertices[i], vertices[i + 1], corner_radius);
      continue;
    }
    add_piece((vertices[i] - pieces_.back().at(pieces_.back().length).position).norm(), 0.0);
    corners_.push_back(length());
  }
  stations_ = corners_;
}

Path::Path(const Pose2& start, const std::vector<PathArc>& arcs) {
  pieces_.push_back({0.0, 0.0, start.position(), start.yaw, 0.0});
  for (const PathArc& arc : arcs) add_piece(arc.length, arc.curvature);
  stations_ = {0.0, length()};
}

void Path::add_corner(const Eigen::Vector2d& from, const Eigen::Vector2d& corner, const Eigen::Vector2d& to,
                      double corner_radius) {
  const Eigen::Vector2d start = pieces_.back().at(pieces_.back().length).position;
  const double turn = angle_difference(direction(corner, to), direction(from, corner));
  const double half_turn = 0.5 * std::abs(turn);
  const double half_leg = 0.5 * std::min((corner - from).norm(), (to - corner).norm());
  const double cut = 1.0 / std::cos(half_turn) - 1.0;  // from vertex to arc, in radii
  const double radius = std::min(corner_radius / cut, half_leg / std::tan(half_turn));
  const bool arc = half_turn > kStraight && radius > kSmallestRadius;
  add_piece((corner - start).norm() - (arc ? radius * std::tan(half_turn) : 0.0), 0.0);
  if (arc) {
    const double length = 2.0 * half_turn * radius;
    add_piece(length, std::copysign(1.0 / radius, turn));
    corners_.push_back(pieces_.back().begin + 0.5 * length);
    add_piece(0.0, 0.0);
  } else {
    corners_.push_back(length());
    pieces_.push_back({length(), 0.0, corner, pieces_.back().heading + turn, 0.0});
  }
}

void Path::add_piece(double length, double curvature) {
  PathPiece& last = pieces_.back();
  length = std::max(length, 0.0);
  if (last.curvature == curvature) {
    last.length += length;
    return;
  }
  const PathPoint start = last.at(last.length);
  pieces_.push_back({last.end(), length, start.position, start.heading, curvature});
}

void Path::add_arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double curvature) {
  const double half_turn = std::asin(std::clamp(0.5 * curvature * (to - from).norm(), -1.0, 1.0));
  turn_to(direction(from, to) - half_turn);
  const double heading = pieces_.back().heading;
  pieces_.push_back({length(), 2.0 * half_turn / curvature, from, heading, curvature});
  corners_.push_back(length());
}

/// Begins a line that heads so, counted on, where the last piece ends.
void Path::turn_to(double heading) {
  const PathPoint end = pieces_.back().at(pieces_.back().length);
  pieces_.push_back({length(), 0.0, end.position, end.heading + angle_difference(heading, end.heading), 0.0});
}

void Path::find_stations(const std::vector<Eigen::Vector2d>& vertices,
                         const std::vector<std::size_t>& bends) {
  stations_.resize(vertices.size());
  for (std::size_t i = 0; i < bends.size(); ++i) {
    stations_[bends[i]] = corners_[i];
    if (i == 0) continue;
    for (std::size_t between = bends[i - 1] + 1; between < bends[i]; ++between) {
      stations_[between] = nearest(vertices[between], stations_[between - 1], corners_[i]);
    }
  }
}

std::size_t Path::piece_at(double s) const {
  const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), s,
                                      [](double at, const PathPiece& piece) { return at < piece.begin; });
  return static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

PathPoint Path::at(double s) const {
  const PathPiece& piece = pieces_[piece_at(s)];
  return piece.at(s - piece.begin);
}

double Path::nearest(const Eigen::Vector2d& position, double from, double to) const {
  from = std::clamp(from, 0.0, length());
  to = std::clamp(to, from, length());
  double nearest = from;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = piece_at(from); i < pieces_.size() && pieces_[i].begin <= to; ++i) {
    const PathPiece& piece = pieces_[i];
    const double first = std::clamp(from - piece.begin, 0.0, piece.length);
    const double last = std::clamp(to - piece.begin, first, piece.length);
    const double u = piece.nearest(position, first, last);
    const double away = (piece.at(u).position - position).norm();
    if (away >= distance) continue;
    distance = away;
    nearest = piece.begin + u;
  }
  return nearest;
}

bool Path::turns_back_at(double station) const {
  const std::size_t i = piece_at(station);
  if (i == 0 || pieces_[i].begin != station) return false;
  const PathPiece& before = pieces_[i - 1];
  return std::abs(pieces_[i].heading - before.at(before.length).heading) > kCusp;
}

double Path::mean_curvature(double from, double to) const {
  return (at(to).heading - at(from).heading) / (to - from);
}

}  // namespace multipath_localization
