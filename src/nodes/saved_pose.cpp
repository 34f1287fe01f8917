#include "nodes/saved_pose.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

#include "multipath_localization/core/atomic_file.hpp"
#include "multipath_localization/core/covariance.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "multipath_localization/estimators/fix_check.hpp"
#include "nodes/state_file.hpp"

namespace multipath_localization {

namespace {

constexpr double kFastest = 10.0;        ///< that a robot rolls on without localisation [m/s]
constexpr double kSlack = 0.5;           ///< and beyond that [m]
constexpr double kRoundingSigma = 1e-3;  ///< [m], [rad]
constexpr std::size_t kKeys = 6;

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
  out << "stamp: " << saved.stamp << "\n";
  const auto pose = [](const Pose2& p) { return std::vector<double>{p.x, p.y, p.yaw}; };
  list(out, "base_in_map", pose(saved.base_in_map));
  list(out, "covariance", {saved.covariance.data(), saved.covariance.data() + 9});
  list(out, "base_in_odom", pose(saved.base_in_odom));
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

SavedPose parsed(const YAML::Node& content) {
  if (!content.IsMap() || content.size() != kKeys)
    throw ParameterError("it does not hold what belongs there");
  SavedPose saved;
  saved.datum = place_of(content["datum"]);
  saved.stamp = content["stamp"].as<double>();
  saved.base_in_map = pose_of(content["base_in_map"]);
  saved.covariance = Eigen::Matrix3d(finite_numbers(content["covariance"], 9).data());
  saved.base_in_odom = pose_of(content["base_in_odom"]);
  saved.confirmed = content["confirmed"].as<bool>();
  if (!std::isfinite(saved.stamp)) throw ParameterError("its stamp is not finite");
  for (const Pose2& base : {saved.base_in_map, saved.base_in_odom}) {
    if (!usable(prior_at(base, saved)))
      throw ParameterError("nobody can start from such a pose or covariance");
  }
  saved.covariance = symmetric<3>(saved.covariance);  // but for rounding it is
  return saved;
}

}  // namespace

std::optional<SavedPose> read_saved_pose(const std::string& file) { return read_state(file, parsed); }

void write_saved_pose(const std::string& file, const SavedPose& pose) { replace_file(file, text_of(pose)); }

std::variant<PosePrior, std::string> resumed(const SavedPose& saved, double stamp, const Pose2& base_in_odom,
                                             double max_age) {
  const double age = stamp - saved.stamp;
  std::ostringstream why;
  why << std::fixed << std::setprecision(1);
  if (age < 0.0) why << "it was saved " << -age << " s after the odometry that comes now";
  if (age > max_age) why << "it is " << age << " s old";
  if (!why.str().empty()) return why.str();
  PosePrior prior = prior_at(saved.base_in_map, saved);
  prior.stamp = stamp;
  const Pose2 rolled = inverse(saved.base_in_odom) * base_in_odom;
  if (rolled.position().norm() > kFastest * age + kSlack) return prior;
  prior.pose = saved.base_in_map * rolled;
  prior.confirmed = saved.confirmed;
  return prior;
}

}  // namespace multipath_localization
