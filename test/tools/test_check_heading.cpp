#include <cmath>
#include <functional>

#include "found.hpp"
#include "healthy_robot.hpp"
#include "ros/messages/heading_conversions.hpp"
#include "tools/doctor/checks.hpp"

namespace multipath_localization {
namespace {

/// The healthy robot with headings at 5 Hz, as they are told of its yaw.
Observations with_heading(const std::function<double(double yaw)>& told) {
  Observations seen = healthy_robot();
  for (std::size_t i = 0; i < seen.odometry.size(); i += 4) {
    const nav_msgs::Odometry& odometry = seen.odometry[i].message;
    std_msgs::Header header;
    header.stamp = odometry.header.stamp;
    const Heading heading{header.stamp.toSec(), told(to_pose2(odometry.pose.pose)->yaw), 0.01};
    seen.headings.push_back({to_message(heading, header), seen.odometry[i].time});
  }
  return seen;
}

TEST(CheckHeading, PassesOneThatPointsWhereTheRobotDoes) {
  EXPECT_TRUE(check_heading(healthy_robot()).empty());
  EXPECT_TRUE(Passes(check_heading(with_heading([](double yaw) { return yaw + 0.05; }))));
}

TEST(CheckHeading, FindsWhatIsWrong) {
  EXPECT_TRUE(ToFix(check_heading(with_heading([](double yaw) { return 0.5 * kPi - yaw; })),
                    "other way round", "counter-clockwise from east"));
  EXPECT_TRUE(ToFix(check_heading(with_heading([](double yaw) { return yaw + kPi; })), "180 degrees off",
                    "taken for each other"));
  EXPECT_TRUE(ToFix(check_heading(with_heading([](double) { return 0.4; })), "does not go with", "driver"));
  EXPECT_TRUE(ToFix(check_heading(with_heading([](double) { return NAN; })), "cannot be used", "driver"));
}

}  // namespace
}  // namespace multipath_localization
