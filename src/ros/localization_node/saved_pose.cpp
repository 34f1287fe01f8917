#include "ros/localization_node/saved_pose.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/core/fix_check.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "ros/saved_state/state_file.hpp"
#include "support/atomic_file.hpp"
#include "support/numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kSlack = 0.5;           ///< that a robot may come further than by its speed [m]
constexpr double kTurnSlack = 0.5;       ///< and turn further than by its yaw rate [rad],
constexpr double kTurnRadius = 4.0;      ///< or than on a curve it may have gone into [m]
constexpr double kFurthestWay = 1e3;     ///< wider is no knowledge [m]
constexpr double kRoundingSigma = 1e-3;  ///< [m], [rad]
constexpr std::size_t kKeys = 7;

void list(std::ostream& out, const char* key, const std::vector<double>& numbers) {
  out << key << ": [";
  const char* separator = "";
  for (const double number : numbers) {
    out << separator << number;
    separator = ", ";
  }
  out << "]\n";
}

std::string text_of(const SavedPose& saved) {
  std::ostringstream out;
  out << std::setprecision(17) << "# Where the robot was: localization_node goes on from here.\n";
  list(out, "datum", {saved.datum.latitude_deg, saved.datum.longitude_deg, saved.datum.altitude});
  out << "stamp: " << saved.odometry.stamp << "\n";
  const auto pose = [](const Pose2& p) { return std::vector<double>{p.x, p.y, p.yaw}; };
  list(out, "base_in_map", pose(saved.base_in_map));
  list(out, "covariance", {saved.covariance.data(), saved.covariance.data() + 9});
  list(out, "base_in_odom", pose(saved.odometry.base_in_odom));
  list(out, "motion", {saved.odometry.speed, saved.odometry.yaw_rate});
  out << "confirmed: " << (saved.confirmed ? "true" : "false") << "\n";
  return out.str();
}

Pose2 pose_of(const YAML::Node& source) {
  const std::vector<double> p = finite_numbers(source, 3);
  return {p[0], p[1], p[2]};
}

/// With as much uncertainty as the pose was saved with.
PosePrior prior_at(const Pose2& base, const SavedPose& saved) {
  PosePrior prior;
  prior.pose = base;
  prior.covariance = saved.covariance + kRoundingSigma * kRoundingSigma * Eigen::Matrix3d::Identity();
  return prior;
}

/// A way and a turn that a robot may have made.
struct Reach {
  double way;   ///< [m]
  double turn;  ///< [rad]
};

Reach reach_between(const OdometryState& before, const OdometryState& now) {
  const double age = now.stamp - before.stamp;
  const double speed = std::max(std::abs(before.speed), std::abs(now.speed));
  const double yaw_rate = std::max(std::abs(before.yaw_rate), std::abs(now.yaw_rate));
  return {speed * age + kSlack, (yaw_rate + speed / kTurnRadius) * age + kTurnSlack};
}

/// Makes a prior less certain by that much, at most all that can be known. Where the odometry has come
/// further, be it from the pose that was saved or from where it began anew, the robot has at least come the
/// shorter of these ways.
void widen(PosePrior& prior, const Reach& reach, const Pose2& rolled, const Pose2& base_in_odom) {
  const double way = std::min(rolled.position().norm(), base_in_odom.position().norm());
  const double turn = std::min(std::abs(rolled.yaw), std::abs(base_in_odom.yaw));
  const double sigma = std::min(std::max(way, reach.way), kFurthestWay);
  const double yaw_sigma = std::min(std::max(turn, reach.turn), kPi);
  prior.covariance.diagonal() += Eigen::Vector3d(square(sigma), square(sigma), square(yaw_sigma));
}

SavedPose parsed(const YAML::Node& content) {
  if (!content.IsMap() || content.size() != kKeys)
    throw ParameterError("it does not hold what belongs there");
  SavedPose saved;
  saved.datum = place_of(content["datum"]);
  saved.odometry.stamp = yaml_number<double>(content["stamp"]);
  saved.base_in_map = pose_of(content["base_in_map"]);
  saved.covariance = Eigen::Matrix3d(finite_numbers(content["covariance"], 9).data());
  saved.odometry.base_in_odom = pose_of(content["base_in_odom"]);
  const std::vector<double> motion = finite_numbers(content["motion"], 2);
  saved.odometry.speed = motion[0];
  saved.odometry.yaw_rate = motion[1];
  saved.confirmed = content["confirmed"].as<bool>();
  if (!std::isfinite(saved.odometry.stamp)) throw ParameterError("its stamp is not finite");
  for (const Pose2& base : {saved.base_in_map, saved.odometry.base_in_odom}) {
    if (!usable(prior_at(base, saved)))
      throw ParameterError("nobody can start from such a pose or covariance");
  }
  saved.covariance = symmetric<3>(saved.covariance);  // but for rounding it is
  return saved;
}

}  // namespace

std::optional<SavedPose> read_saved_pose(const std::string& file) { return read_state(file, parsed); }

void write_saved_pose(const std::string& file, const SavedPose& pose) { replace_file(file, text_of(pose)); }

std::variant<PosePrior, std::string> resumed(const SavedPose& saved, const OdometryState& now,
                                             double max_age) {
  const double age = now.stamp - saved.odometry.stamp;
  std::ostringstream why;
  why << std::fixed << std::setprecision(1);
  if (age < 0.0) why << "it was saved " << -age << " s after the odometry that comes now";
  if (age > max_age) why << "it is " << age << " s old";
  if (!why.str().empty()) return why.str();
  PosePrior prior = prior_at(saved.base_in_map, saved);
  prior.stamp = now.stamp;
  const Pose2 rolled = inverse(saved.odometry.base_in_odom) * now.base_in_odom;
  const Reach reach = reach_between(saved.odometry, now);
  const bool may_have_begun = now.base_in_odom.position().norm() <= reach.way;
  const bool in_reach = rolled.position().norm() <= reach.way && std::abs(rolled.yaw) <= reach.turn;
  if (may_have_begun || !in_reach) {
    widen(prior, reach, rolled, now.base_in_odom);
    return prior;
  }
  prior.pose = saved.base_in_map * rolled;
  prior.confirmed = saved.confirmed;
  return prior;
}

}  // namespace multipath_localization
