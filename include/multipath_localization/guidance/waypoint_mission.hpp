#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "multipath_localization/guidance/waypoint_follower.hpp"

namespace multipath_localization {

/// What became of an order to the robot, in words for who gave it.
struct Answer {
  bool done;
  std::string message;
};

/// What became of waypoints that a topic delivered.
enum class Delivery {
  kKnown,      ///< nothing
  kContinued,  ///< they continue the route under way: the robot goes on to the waypoint it was steered for
  kNew         ///< they are another route
};

/// A WaypointFollower at the orders of the robot's owner. The robot drives after `start` or `resume` alone,
/// or from the beginning with `autostart`; no order but these two sets it in motion. An order that makes no
/// sense where things stand changes nothing and says why.
class WaypointMission {
 public:
  /// Waypoints in map [m]. Throws std::invalid_argument when one is not finite.
  WaypointMission(const WaypointFollowerParameters& parameters, const std::vector<Eigen::Vector2d>& waypoints,
                  bool autostart);

  Answer start();                        ///< from the first waypoint on, unless driving or paused
  Answer pause();                        ///< stand, and keep the waypoint steered for
  Answer resume();                       ///< from a pause, or a wait at a waypoint
  Answer skip();                         ///< on to the next waypoint, driving or paused
  void hold(const std::string& reason);  ///< as pause, urgently: what halts the robot waits for `resume`
  Answer stop();                         ///< stand until `start`; always done
  Answer set_loop(bool repeat);          ///< go on to the first waypoint after the last, or stop there

  /// Waypoints in map [m], to be driven from the first on: at once when driving or finished. Throws
  /// std::invalid_argument, and keeps the old ones, as Route does.
  void set_waypoints(const std::vector<Eigen::Vector2d>& waypoints, const RouteTasks& tasks = {});

  /// Waypoints in map [m] as a topic delivers them, over again at times. Those that came last, with no later
  /// `stamp` [ns], are the same delivery and change nothing, see same_route. Those that continue the route
  /// under way, as WaypointFollower::continue_along tells, are gone on along. All others are for
  /// WaypointFollower::take_route while driving, else for set_waypoints.
  Delivery offer_waypoints(const std::vector<Eigen::Vector2d>& waypoints, std::uint64_t stamp,
                           const RouteTasks& tasks = {});

  /// WaypointFollower::move_waypoints: the robot goes on to the waypoint it was steered for.
  void move_waypoints(const std::vector<Eigen::Vector2d>& waypoints) { follower_.move_waypoints(waypoints); }

  /// No waypoints until set_waypoints, for a reason to be told. What was finished then takes `start`.
  void stand_without_waypoints(const std::string& reason);

  /// As WaypointFollower::command; zero, and why, where the owner's orders are to stand.
  FollowerOutput command(const Pose2& pose, double pose_age, Trust state, double sigma = 0.0,
                         double now = 0.0);

  /// Whether it stands by order, or at the end of the way: nothing but an order, or waypoints, ends that.
  [[nodiscard]] bool stands() const { return order_ != Order::kDrive || follower_.finished(); }

  [[nodiscard]] const WaypointFollower& follower() const { return follower_; }

 private:
  enum class Order { kAwaited, kDrive, kPause, kStop, kDone };

  [[nodiscard]] bool finished() const;
  [[nodiscard]] Answer no_waypoints() const;
  [[nodiscard]] std::string reason_to_stand() const;  ///< empty under kDrive

  /// What offer_waypoints took last.
  struct StampedRoute {
    std::vector<Eigen::Vector2d> waypoints;
    std::uint64_t stamp;
  };

  WaypointFollowerParameters parameters_;
  WaypointFollower follower_;
  Order order_;
  std::optional<StampedRoute> last_delivery_;
  std::string held_for_;           ///< the reason of a pause that is not the owner's
  std::string without_waypoints_;  ///< why there are none, where that is known
};

}  // namespace multipath_localization
