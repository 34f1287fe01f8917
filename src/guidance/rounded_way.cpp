#include "guidance/rounded_way.hpp"

#include <algorithm>
#include <cmath>

#include "multipath_localization/core/angle.hpp"

namespace multipath_localization {

namespace {

constexpr double kStraight = 1e-6;               // a corner that turns less is none [rad]
constexpr double kLongestArc = 2.0 * kPi / 3.0;  // one place to the next [rad]
constexpr double kSlack = 1e-9;                  // that lines may be too short by [m]

constexpr double kLook = 0.2;  // between looks whether an arc may come somewhere [rad]

Eigen::Vector2d along(double heading) { return {std::cos(heading), std::sin(heading)}; }

double heading_of(const Eigen::Vector2d& way) { return std::atan2(way.y(), way.x()); }

/// An arc that touches two lines.
struct Arc {
  Eigen::Vector2d centre;
  double radius;
  double heading;  ///< at its begin [rad]
  double turn;     ///< to the left [rad]
  double tangent;  ///< from its begin to the corner, negative where it begins beyond [m]

  [[nodiscard]] Eigen::Vector2d at(double share) const {
    const double outwards = heading + share * turn - std::copysign(0.5 * kPi, turn);
    return centre + radius * along(outwards);
  }
};

Arc arc_at(const Eigen::Vector2d& corner, double heading, double turn, double tangent, double radius) {
  const Eigen::Vector2d begin = corner - tangent * along(heading);
  return {begin + radius * along(heading + std::copysign(0.5 * kPi, turn)), radius, heading, turn, tangent};
}

bool allowed(const Arc& arc, const Rounding& rounding) {
  const double looks = std::ceil(std::abs(arc.turn) / kLook) + 1.0;
  for (double i = 0.0; i <= looks; ++i) {
    if (!rounding.may_come(arc.at(i / looks))) return false;
  }
  return true;
}

/// Round a corner; none where it may not be driven round.
std::optional<Arc> arc_round(const Eigen::Vector2d& from, const Eigen::Vector2d& corner,
                             const Eigen::Vector2d& to, const Rounding& rounding) {
  const double heading = heading_of(corner - from);
  const double turn = angle_difference(heading_of(to - corner), heading);
  const double tangent = rounding.radius * std::tan(0.5 * std::abs(turn));
  const Arc inside = arc_at(corner, heading, turn, tangent, rounding.radius);
  if (allowed(inside, rounding)) return inside;
  const Arc loop = arc_at(corner, heading, turn - std::copysign(2.0 * kPi, turn), -tangent, rounding.radius);
  return allowed(loop, rounding) ? std::optional(loop) : std::nullopt;
}

void append(std::vector<WayPoint>& way, const Arc& arc) {
  way.push_back({arc.at(0.0), 0.0});
  if (std::abs(arc.turn) < kStraight) return;
  const double pieces = std::ceil(std::abs(arc.turn) / kLongestArc);
  for (double i = 1.0; i <= pieces; ++i) {
    way.push_back({arc.at(i / pieces), std::copysign(1.0 / arc.radius, arc.turn)});
  }
}

}  // namespace

std::optional<std::vector<WayPoint>> rounded_way(const std::vector<Eigen::Vector2d>& corners,
                                                 const Rounding& rounding) {
  std::vector<WayPoint> way = {{corners.front(), 0.0}};
  double used = 0.0;  // of the line under way, from the corner before [m]
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const auto arc = arc_round(corners[i - 1], corners[i], corners[i + 1], rounding);
    if (!arc || used + arc->tangent > (corners[i] - corners[i - 1]).norm() + kSlack) return std::nullopt;
    append(way, *arc);
    used = arc->tangent;
  }
  if (corners.size() < 2) return way;
  if (used > (corners.back() - corners[corners.size() - 2]).norm() + kSlack) return std::nullopt;
  way.push_back({corners.back(), 0.0});
  return way;
}

}  // namespace multipath_localization
