#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "multipath_localization/core/pose.hpp"
#include "multipath_localization/guidance/path.hpp"

namespace multipath_localization {

/// When a waypoint counts as passed.
struct PassingRule {
  double radius;              ///< this near to it [m]
  double width;               ///< or this far aside at most where the line through it is crossed [m]
  bool at_end;                ///< the last waypoint is one to stop at, not one to come by
  double tightest_curvature;  ///< the base can drive [1/m]
  bool turns_on_the_spot;     ///< the base does: it can go to what lies beside it
};

/// Where a base is on the path through waypoints, and which of these it has passed.
///
/// A waypoint is passed within `radius` of it, or by crossing the line through it that is perpendicular to
/// the way there, at most `width` or `radius` aside, or by being so near to what prolongs that way beyond it,
/// or within `radius` of the path beyond it. One to stop at is passed by crossing that line, or where it no
/// longer lies ahead within `radius` of a base that cannot turn to it: that is as near as it comes.
class PathProgress {
 public:
  /// The path through `vertices` in map [m], of which the `first` ones, one at least, lie behind, for a base
  /// at `position`. `curvatures` are those of the ways to them, see Path; none where all corners are rounded.
  PathProgress(std::vector<Eigen::Vector2d> vertices, std::size_t first, const PassingRule& rule,
               const Eigen::Vector2d& position, const std::vector<double>& curvatures = {});
  /// A path from where the base is, whose end is the only waypoint: passed where the path ends, however near
  /// it comes by before.
  PathProgress(Path path, const PassingRule& rule);

  /// Follows the base to where it is now; whether it passes the next waypoint there.
  bool passes(const Pose2& pose);
  void pass_next();  ///< goes on to the waypoint after the next

  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] double station() const { return station_; }  ///< of the base, along the path [m]
  [[nodiscard]] std::size_t left() const { return vertices_.size() - next_; }  ///< vertices to be passed
  [[nodiscard]] double earliest() const { return earliest_; }  ///< station it does not fall back behind [m]
  /// Where the path comes by the vertex `ahead` of the next [m].
  [[nodiscard]] double station_ahead(std::size_t ahead) const { return path_.station(next_ + ahead); }
  [[nodiscard]] const Eigen::Vector2d& position() const { return position_; }  ///< of the base, last
  [[nodiscard]] bool done() const { return left() == 0; }
  /// Whether the next waypoint is one to stop at.
  [[nodiscard]] bool comes_to_rest() const { return rule_.at_end && left() == 1; }
  [[nodiscard]] const Eigen::Vector2d& end() const { return vertices_.back(); }  ///< the last waypoint
  [[nodiscard]] const PassingRule& rule() const { return rule_; }
  /// How far the base is from the path, prolonged beyond its end [m].
  [[nodiscard]] double deviation(const Eigen::Vector2d& position) const;
  /// The last places before the next waypoint that bend the path: two, or one where there is but one.
  [[nodiscard]] std::vector<Eigen::Vector2d> behind() const;

 private:
  void follow(const Eigen::Vector2d& position);
  [[nodiscard]] std::size_t bend_before(std::size_t vertex) const;
  [[nodiscard]] bool crossed(const Eigen::Vector2d& beyond) const;
  [[nodiscard]] bool arrived(const Pose2& pose) const;

  std::vector<Eigen::Vector2d> vertices_;
  std::size_t next_;
  PassingRule rule_;
  Path path_;
  double station_;
  bool winds_ = false;     ///< the path may come by its end before
  double earliest_ = 0.0;  ///< station that the base does not fall back behind: of a cusp [m]
  Eigen::Vector2d position_;
};

}  // namespace multipath_localization
