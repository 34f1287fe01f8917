#include "ros/messages/gnss_message.hpp"

#include <cmath>
#include <limits>

namespace multipath_localization {

namespace {

/// Reads one kind of message after the other kinds of it have been told apart.
class Reading {
 public:
  Reading(const LocalFrame& map, const GnssParameters& parameters, const AntennaFinder& antenna_in_base,
          const RotationFinder& rotation_in_base)
      : map_(map),
        parameters_(parameters),
        antenna_in_base_(antenna_in_base),
        rotation_in_base_(rotation_in_base) {}

  CheckedMeasurement operator()(const ReceiverFix& message) const {
    const std::optional<Eigen::Vector2d> antenna = lone_antenna(message.header.frame_id);
    if (!antenna) return {Reason::kInvalidFrame, {}};
    CheckedFix checked = to_fix(message, map_, parameters_.fix, *antenna);
    checked.fix.receiver = message.receiver;
    checked.fix.level = message.level;
    return {checked.reason, checked.fix};
  }

  CheckedMeasurement operator()(const FixPair& message) const {
    const std::optional<Eigen::Vector2d> left = antenna_in_base_(message.left.header.frame_id);
    const std::optional<Eigen::Vector2d> right = antenna_in_base_(message.right.header.frame_id);
    if (!left || !right) return {Reason::kInvalidFrame, {}};
    const CheckedDual checked = to_dual(message, map_, parameters_.fix, *left, *right);
    return {checked.reason, checked.fix};
  }

  CheckedMeasurement operator()(const GnssEpoch& message) const {
    const std::optional<Eigen::Vector2d> antenna = lone_antenna(message.header.frame_id);
    if (!antenna) return {Reason::kInvalidFrame, {}};
    const CheckedEpoch checked = to_epoch(message, map_, parameters_.epoch, *antenna);
    return {checked.reason, checked.epoch};
  }

  CheckedMeasurement operator()(const geometry_msgs::TwistWithCovarianceStamped& message) const {
    const std::optional<Eigen::Vector2d> antenna = lone_antenna(message.header.frame_id);
    if (!antenna) return {Reason::kInvalidFrame, {}};
    const CheckedVelocity checked = to_velocity(message, parameters_.velocity, *antenna);
    return {checked.reason, checked.velocity};
  }

  CheckedMeasurement operator()(const sensor_msgs::Imu& message) const {
    std::optional<Eigen::Quaterniond> in_base;
    if (rotation_in_base_ && !message.header.frame_id.empty()) {
      in_base = rotation_in_base_(message.header.frame_id);
    }
    const CheckedHeading checked =
        to_heading(message, parameters_.heading, in_base.value_or(Eigen::Quaterniond::Identity()));
    return {checked.reason, checked.heading};
  }

 private:
  [[nodiscard]] std::optional<Eigen::Vector2d> lone_antenna(const std::string& frame) const {
    const std::optional<Eigen::Vector2d> antenna = antenna_in_base_(frame);
    if (antenna || parameters_.require_antenna_transform) return antenna;
    return parameters_.antenna_otherwise();
  }

  const LocalFrame& map_;
  const GnssParameters& parameters_;
  const AntennaFinder& antenna_in_base_;
  const RotationFinder& rotation_in_base_;
};

const std_msgs::Header& header(const FixPair& pair) {
  return (pair.left.header.stamp < pair.right.header.stamp ? pair.right : pair.left).header;
}

template <class Message>
const std_msgs::Header& header(const Message& message) {
  return message.header;
}

}  // namespace

std::string fix_name(std::size_t receiver) {
  const std::string name(kMeasurementNames[kFixKind]);
  return receiver == 0 ? name : name + "_" + std::to_string(receiver + 1);
}

std::string fix_topic(std::size_t receiver) {
  return receiver == 0 ? "gps/fix" : "gps_" + std::to_string(receiver + 1) + "/fix";
}

std::string level_topic(std::size_t receiver) {
  const std::string fix = fix_topic(receiver);
  return fix.substr(0, fix.find('/')) + "/level";
}

std::string name_of(const GnssMessage& message) {
  const auto* fix = std::get_if<ReceiverFix>(&message);
  return fix == nullptr ? std::string(kMeasurementNames[message.index()]) : fix_name(fix->receiver);
}

std::string name_of(const Measurement& measurement) {
  const auto* fix = std::get_if<GnssFix>(&measurement);
  return fix == nullptr ? std::string(kMeasurementNames[measurement.index()]) : fix_name(fix->receiver);
}

void GnssParameters::fields(ParameterVisitor& field) {
  field("antenna", antenna, {-100.0, 100.0}, "m",
        "a lone antenna whose frame tf does not place on the robot is here on the base, forwards and to the "
        "left; empty: at the base");
  if (!antenna.empty() && antenna.size() != 2) throw ParameterError("antenna is not [forwards, to the left]");
  field("require_antenna_transform", require_antenna_transform,
        "refuse fixes whose frame tf does not place on the robot, instead of taking the antenna to be where "
        "`antenna` says");
  field("pair_tolerance", pair_tolerance, {0.0, 1.0}, "s",
        "fixes of the left and the right antenna whose stamps differ by more are of two instants");
  field("delay", delay, {-2.0, 2.0}, "s",
        "fixes, epochs, velocities and headings are of this long before their stamps; tune_from_bag tells");
  field.group("fix", fix, "how fixes are read");
  field.group("epoch", epoch, "how epochs of pseudoranges are read");
  field.group("velocity", velocity, "how velocities of a receiver are read");
  field.group("heading", heading, "how headings are read");
}

Eigen::Vector2d GnssParameters::antenna_otherwise() const {
  return antenna.empty() ? Eigen::Vector2d(0.0, 0.0) : Eigen::Vector2d(antenna[0], antenna[1]);
}

std::string GnssParameters::otherwise_at() const {
  if (require_antenna_transform) return ": it is refused";
  return antenna.empty() ? ": a lone antenna is taken to be at the base"
                         : ": a lone antenna is taken to be where the parameter antenna says";
}

std::vector<std::string> frames_of(const GnssMessage& message) {
  if (const auto* pair = std::get_if<FixPair>(&message)) {
    return {pair->left.header.frame_id, pair->right.header.frame_id};
  }
  if (std::holds_alternative<sensor_msgs::Imu>(message)) return {};
  return {header_of(message).frame_id};
}

const std_msgs::Header& header_of(const GnssMessage& message) {
  return std::visit([](const auto& m) -> const std_msgs::Header& { return header(m); }, message);
}

double declared_sigma(const GnssMessage& message) {
  if (const auto* fix = std::get_if<ReceiverFix>(&message)) return declared_sigma(*fix);
  if (const auto* pair = std::get_if<FixPair>(&message)) {
    return std::hypot(declared_sigma(pair->left), declared_sigma(pair->right)) * std::sqrt(0.5);
  }
  if (const auto* velocity = std::get_if<geometry_msgs::TwistWithCovarianceStamped>(&message)) {
    return declared_sigma(*velocity);
  }
  if (const auto* heading = std::get_if<sensor_msgs::Imu>(&message)) return declared_heading_sigma(*heading);
  return std::numeric_limits<double>::quiet_NaN();
}

std::size_t satellites_of(const Measurement& measurement) {
  const auto* epoch = std::get_if<PseudorangeEpoch>(&measurement);
  return epoch == nullptr ? 0 : epoch->observations.size();
}

std::size_t satellites_of(const GnssMessage& message) {
  const auto* epoch = std::get_if<GnssEpoch>(&message);
  return epoch == nullptr ? 0 : epoch->pseudoranges.size();
}

Reason check(const GnssMessage& message, const GnssParameters& parameters) {
  if (const auto* epoch = std::get_if<GnssEpoch>(&message)) return check(*epoch, parameters.epoch);
  if (const auto* fix = std::get_if<ReceiverFix>(&message)) return check(*fix, parameters.fix);
  if (const auto* velocity = std::get_if<geometry_msgs::TwistWithCovarianceStamped>(&message)) {
    return check(*velocity, parameters.velocity);
  }
  if (const auto* heading = std::get_if<sensor_msgs::Imu>(&message)) return check(*heading);
  const auto& pair = std::get<FixPair>(message);
  const Reason left = check(pair.left, parameters.fix);
  return left == Reason::kAccepted ? check(pair.right, parameters.fix) : left;
}

std::optional<Geodetic> place_of(const GnssMessage& message, const GnssParameters& parameters) {
  if (const auto* epoch = std::get_if<GnssEpoch>(&message)) return solve_geodetic(*epoch, parameters.epoch);
  if (const auto* fix = std::get_if<ReceiverFix>(&message)) return to_geodetic(*fix);
  if (const auto* pair = std::get_if<FixPair>(&message)) return to_geodetic(pair->left);
  return std::nullopt;
}

CheckedMeasurement to_measurement(const GnssMessage& message, const LocalFrame& map,
                                  const GnssParameters& parameters, const AntennaFinder& antenna_in_base,
                                  const RotationFinder& rotation_in_base) {
  return std::visit(Reading(map, parameters, antenna_in_base, rotation_in_base), message);
}

}  // namespace multipath_localization
