#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/NavSatFix.h>

#include "byte_stream.hpp"
#include "models/motion/wheel_odometer.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "multipath_localization/localization/localizer.hpp"
#include "oracle.hpp"
#include "ros/inputs/odometry_reader.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/messages/epoch_conversions.hpp"
#include "ros/wheel_odometry_node/ackermann_message.hpp"
#include "ros/wheel_odometry_node/wheel_joints.hpp"
#include "targets.hpp"

namespace multipath_localization::fuzz {

namespace {

/// Messages as a node gets them, one after the other, each behind a byte that tells its type.
class Node {
 public:
  explicit Node(const std::string& bytes)
      : in_(bytes), localizer_(make_estimator("gated_ekf", YAML::Node(), 1), LocalizerParameters{}) {
    localizer_.start(std::nullopt);
  }

  void run() {
    while (!in_.empty()) {
      switch (in_.take<std::uint8_t>() % 7) {
        case 0: take_fix(); break;
        case 1: take_pair(); break;
        case 2: take_epoch(); break;
        case 3: take_odometry(); break;
        case 5: take_joints(); break;
        case 6: take_drive(); break;
        default: take_pose(); break;
      }
      check_estimate();
    }
  }

 private:
  void take_fix() {
    const auto message = in_.take<sensor_msgs::NavSatFix>();
    const CheckedFix checked = to_fix(message, map_, FixParameters{});
    require(!std::isinf(declared_sigma(message)) || checked.reason != Reason::kAccepted, "an infinite sigma");
    if (checked.reason != Reason::kAccepted) return;
    check(checked.fix);
    const CheckedFix again = to_fix(to_message(checked.fix, map_, message.header), map_, FixParameters{});
    require(again.reason == Reason::kAccepted, "a fix is refused once written as a message");
    require((again.fix.position - checked.fix.position).norm() < 1.0, "a fix has moved by being written");
    localizer_.add(checked.fix);
  }

  void take_pair() {
    FixPair pair;
    pair.left = in_.take<sensor_msgs::NavSatFix>();
    pair.right = in_.take<sensor_msgs::NavSatFix>();
    const CheckedDual checked = to_dual(pair, map_, FixParameters{}, {0.0, 0.5}, {0.0, -0.5});
    if (checked.reason != Reason::kAccepted) return;
    check(checked.fix.left);
    check(checked.fix.right);
    localizer_.add(checked.fix);
  }

  void take_epoch() {
    GnssEpoch message;
    message.header = in_.take<std_msgs::Header>();
    message.pseudoranges = in_.take_list<Pseudorange>();
    const auto place = solve_geodetic(message, EpochParameters{});
    require(!place || (valid(*place) && std::isfinite(place->altitude)), "an epoch leads to no place");
    const CheckedEpoch checked = to_epoch(message, map_, EpochParameters{});
    if (checked.reason != Reason::kAccepted) return;
    check(checked.epoch);
    require(checked.epoch.observations.size() + checked.dropped == message.pseudoranges.size(), "satellites");
    const CheckedEpoch again =
        to_epoch(to_message(checked.epoch, map_, message.header), map_, EpochParameters{});
    require(again.dropped == 0, "a satellite is left out once written as a message");
    localizer_.add(checked.epoch);
  }

  void take_odometry() {
    const auto message = in_.take<nav_msgs::Odometry>();
    const CheckedOdometry checked = odometry_.read(message);
    if (checked.restarted) localizer_.start(std::nullopt);
    if (checked.reason != Reason::kAccepted) return;
    const OdometryIncrement& u = checked.increment;
    require(std::isfinite(u.stamp) && std::isfinite(u.duration) && u.duration > 0.0, "no time of odometry");
    const OdometryParameters limits;
    require(std::abs(u.speed) <= limits.max_speed, "too fast");
    require(std::abs(u.yaw_rate) <= limits.max_yaw_rate, "turns too fast");
    require_finite(checked.base_in_odom, "the pose of odometry");
    localizer_.add(u);
  }

  void take_joints() {
    sensor_msgs::JointState message;
    message.header = in_.take<std_msgs::Header>();
    message.name = in_.take_list<std::string>();
    message.position = in_.take_list<double>();
    message.velocity = in_.take_list<double>();
    check(wheels_.take(message.header.stamp.toSec(), read_joints(message, {{"a"}, {"b"}, {}}).readings));
  }

  void take_drive() {
    const auto message = in_.take<AckermannDriveStamped>();
    check(drive_.take(message.header.stamp.toSec(), DriveReading{message.speed, message.steering_angle}));
  }

  static void check(const WheelMotion& told) {
    if (!told.motion) return;
    require(told.reason == Reason::kAccepted, "motion that is refused");
    require(std::abs(told.motion->speed) <= WheelLimits{}.max_speed, "wheels too fast");
    require(std::abs(told.motion->yaw_rate) <= WheelLimits{}.max_yaw_rate, "wheels turn too fast");
    require(told.motion->duration > 0.0, "no time of wheels");
  }

  void take_pose() {
    const auto prior = to_prior(in_.take<geometry_msgs::PoseWithCovarianceStamped>());
    if (!prior) return;
    require_finite(prior->pose, "a pose to start from");
    require_covariance<3>(prior->covariance, "the covariance to start from");
    localizer_.start(prior);
  }

  static void check(const GnssFix& fix) {
    require_finite(fix.stamp, "a fix's stamp");
    require(fix.position.norm() <= FixParameters{}.reach, "a fix out of reach");
    require_covariance<2>(fix.covariance, "a fix's covariance");
    require(fix.covariance.diagonal().minCoeff() > 0.0, "a fix without variance");
  }

  static void check(const PseudorangeEpoch& epoch) {
    for (const SatelliteObservation& observation : epoch.observations) {
      require(observation.position.allFinite(), "a satellite's place is not finite");
      require_finite(observation.pseudorange + observation.elevation, "a pseudorange or elevation");
      require(std::isfinite(observation.sigma) && observation.sigma > 0.0, "a sigma is not above 0");
    }
  }

  void check_estimate() {
    const PoseEstimate estimate = localizer_.estimate();
    localizer_.take_reports();
    require(!localizer_.state_reason().empty(), "a state without a reason");
    if (!estimate.valid) return;
    require_finite(estimate.pose, "the estimate");
    require_covariance<3>(estimate.covariance, "the estimate's covariance");
  }

  ByteStream in_;
  LocalFrame map_{Geodetic{52.5, 13.4, 40.0}};
  OdometryReader odometry_{OdometryParameters{}, "map"};
  WheelOdometer wheels_{{0.1, 0.5, 0.0, 0.0}, {}}, drive_{{0.0, 0.0, 1.2, 0.0}, {}};
  Localizer localizer_;
};

}  // namespace

void messages(const std::string& bytes) { unless_cut(Node(bytes)); }

}  // namespace multipath_localization::fuzz
