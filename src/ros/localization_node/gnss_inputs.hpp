#pragma once

#include <ros/node_handle.h>
#include <topic_tools/shape_shifter.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "ros/inputs/fix_pairing.hpp"
#include "ros/localization_node/input_monitor.hpp"
#include "ros/messages/gnss_message.hpp"

namespace multipath_localization {

/// Subscribes to `gps/fix`, `gps/left/fix` with `gps/right/fix`, `gnss/epoch`, and `gps/velocity` of either
/// of its types, and hands on what comes.
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

  [[nodiscard]] InputMonitor& of(std::size_t kind) { return monitors_[kind]; }
  [[nodiscard]] const InputMonitor& of(std::size_t kind) const { return monitors_[kind]; }

  /// Those awaited that tell a position, in words: "fix on ... or epoch on ...".
  [[nodiscard]] std::string described() const;
  /// Whether all of these are: InputMonitor::silent.
  [[nodiscard]] bool silent(double bound) const;
  /// Tells the console of each kind once that it is used; to be called now and then.
  void tell_new();
  /// What became of each kind since the start, a sentence each.
  [[nodiscard]] std::vector<std::string> sums() const;

 private:
  void on_fix(const sensor_msgs::NavSatFix::ConstPtr& message);
  void on_left(const sensor_msgs::NavSatFix::ConstPtr& message);
  void on_right(const sensor_msgs::NavSatFix::ConstPtr& message);
  void on_epoch(const GnssEpoch::ConstPtr& message);
  void on_velocity(const topic_tools::ShapeShifter::ConstPtr& message);
  void add(FixPairing::Side side, const sensor_msgs::NavSatFix& fix);

  double delay_;
  FixPairing pairing_;
  Take take_;
  GiveUp give_up_;
  std::array<InputMonitor, kGnssKinds.size()> monitors_;
  UsedKinds told_{};
};

}  // namespace multipath_localization
