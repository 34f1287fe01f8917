#include "ros/steering_node/graceful_shutdown.hpp"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>

namespace multipath_localization {

namespace {

constexpr double kLookEvery = 0.05;      ///< whether to end [s]
constexpr int kLastWords = 5;            ///< times these are said
constexpr double kLastWordEvery = 0.05;  ///< another thread of roscpp writes them [s]

std::atomic<bool> asked_to_end{false};

void on_signal(int /*signal*/) { asked_to_end = true; }

void take_requests() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  // roscpp's own answer to `rosnode kill` closes all topics from another thread.
  const ros::XMLRPCManagerPtr& requests = ros::XMLRPCManager::instance();
  requests->unbind("shutdown");
  requests->bind("shutdown", [](XmlRpc::XmlRpcValue& /*request*/, XmlRpc::XmlRpcValue& answer) {
    asked_to_end = true;
    answer = ros::xmlrpc::responseInt(1, "", 0);
  });
}

}  // namespace

void spin_until_shutdown(const std::function<void()>& say_last) {
  take_requests();
  while (ros::ok() && !asked_to_end) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kLookEvery));
  }
  for (int i = 0; i < kLastWords && ros::ok(); ++i) {
    say_last();
    ros::WallDuration(kLastWordEvery).sleep();
  }
  ros::shutdown();
}

}  // namespace multipath_localization
