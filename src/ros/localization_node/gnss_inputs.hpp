#pragma once

#include <ros/node_handle.h>
#include <topic_tools/shape_shifter.h>

#include <array>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ros/inputs/fix_pairing.hpp"
#include "ros/inputs/input_monitor.hpp"
#include "ros/inputs/told_levels.hpp"
#include "ros/messages/gnss_message.hpp"

namespace multipath_localization {

/// One input of GNSS.
struct GnssInput {
  std::string name;          ///< of its messages: name_of
  std::size_t kind = 0;      ///< in Measurement
  std::size_t receiver = 0;  ///< of fixes, whose
  InputMonitor monitor;

  /// Whether it belongs to what is waited for: a further receiver only once it has been heard.
  [[nodiscard]] bool counts() const { return monitor.awaited() && (receiver == 0 || monitor.seen()); }
  [[nodiscard]] bool tells_position() const { return multipath_localization::tells_position(kind); }
};

/// Subscribes to `gps/fix`, `gps_2/fix`, ... of further receivers, with `gps/level`, `gps_2/level`, ...,
/// `gps/left/fix` with `gps/right/fix`, `gnss/epoch`, and `gps/velocity` and `heading` of either of their
/// types, and hands on what comes.
class GnssInputs {
 public:
  using Take = std::function<void(const GnssMessage&)>;
  /// Takes a fix of one of two antennas that has found no other.
  using GiveUp = std::function<void(const sensor_msgs::NavSatFix&)>;

  /// `used`: the kinds that are awaited.
  GnssInputs(ros::NodeHandle node, const GnssParameters& parameters, const UsedKinds& used, Take take,
             GiveUp give_up);

  /// Gives up what waits for its other half.
  void clear();

  /// One of them, by its name.
  [[nodiscard]] InputMonitor& of(std::string_view name);
  [[nodiscard]] const std::vector<GnssInput>& all() const { return inputs_; }

  /// Those awaited that tell a position, in words: "fix on ... or epoch on ...".
  [[nodiscard]] std::string described() const;
  /// Whether all of these are: InputMonitor::silent.
  [[nodiscard]] bool silent(double bound) const;
  /// Tells the console of each kind once that it is used; to be called now and then.
  void tell_new();
  /// What became of each kind since the start, a sentence each.
  [[nodiscard]] std::vector<std::string> sums() const;

 private:
  void on_left(const sensor_msgs::NavSatFix::ConstPtr& message);
  void on_right(const sensor_msgs::NavSatFix::ConstPtr& message);
  void on_epoch(const GnssEpoch::ConstPtr& message);
  void on_velocity(const topic_tools::ShapeShifter::ConstPtr& message);
  void on_heading(const topic_tools::ShapeShifter::ConstPtr& message);
  void add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix);

  ros::Subscriber subscribe_fix(ros::NodeHandle& node, std::size_t receiver);
  ros::Subscriber subscribe_level(ros::NodeHandle& node, std::size_t receiver);

  double delay_;
  FixPairing pairing_;
  Take take_;
  GiveUp give_up_;
  std::vector<GnssInput> inputs_;
  std::array<ToldLevels, kMostReceivers> levels_;
  std::vector<ros::Subscriber> level_subscribers_;
  std::set<std::string> told_;  ///< names of those that the console knows
};

}  // namespace multipath_localization
