#!/usr/bin/python3
"""steering_node in closed loop with a robot that does as it is told, on routes as planners and people send them."""
import math
import time

import rospy
import rostest
from geometry_msgs.msg import PoseArray, PoseStamped
from multipath_localization.msg import LocalizationState, RouteProgress
from nav_msgs.msg import Path
from rosgraph_msgs.msg import Clock

from steering_case import Last, SteeringCase, wait_for_subscribers, waypoint_array

STEP = 0.1  # of the robot's motion for each command [s]


class SteeringRoutesTest(SteeringCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.waypoints = rospy.Publisher("waypoints", PoseArray, queue_size=10)
        cls.clock = rospy.Publisher("/clock", Clock, queue_size=10, latch=True)
        cls.goal = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        cls.plan = rospy.Publisher("plan", Path, queue_size=1)
        cls.to_go = Last("steering/route_progress", RouteProgress)
        wait_for_subscribers(cls.pose, cls.state, cls.waypoints, cls.clock, cls.goal, cls.plan)
        cls.stamp = 0
        cls.time = 1000.0

    def setUp(self):
        self.set_state(LocalizationState.GOOD)
        self.x = self.y = self.yaw = self.way = 0.0
        self.send([])
        self.expect("stopped: no waypoints")

    def send(self, points):
        """Under a later stamp than before."""
        type(self).stamp += 1
        self.waypoints.publish(waypoint_array(points, stamp=rospy.Time(self.stamp)))

    def step(self):
        """Sends the pose, and does as the command that comes for it says."""
        before = self.cmd_vel.count
        end = time.time() + 8.0
        type(self).time += STEP
        self.clock.publish(Clock(rospy.Time(self.time)))
        self.send_pose(self.x, self.y, self.yaw, stamp=rospy.Time(self.time))
        while self.cmd_vel.count == before:
            self.assertLess(time.time(), end, f"no command; status is {self.status.message}")
            time.sleep(0.001)
        twist = self.cmd_vel.message
        middle = self.yaw + 0.5 * STEP * twist.angular.z
        self.x += STEP * twist.linear.x * math.cos(middle)
        self.y += STEP * twist.linear.x * math.sin(middle)
        self.yaw += STEP * twist.angular.z
        self.way += STEP * abs(twist.linear.x)

    def drive(self, status, most=60.0):
        """Drives until the status is as expected, `most` [m] at most."""
        while not self.status.message.data.startswith(status):
            self.assertLess(self.way, most, self.status.message.data)
            self.step()

    def drive_past(self, x):
        while self.x < x:
            self.assertLess(self.way, 60.0)
            self.step()

    def drive_once(self, points, most):
        self.send(points)
        self.drive("driving")
        self.drive("finished: loop needs a waypoint farther than 3.5 m from the first", most)
        while self.cmd_vel.message.linear.x > 0.0:
            self.step()
        time.sleep(0.2)
        self.assertEqual(self.progress.message.data, 1.0)
        x, y = points[-1]
        self.assertLess(math.hypot(self.x - x, self.y - y), 0.1)

    def test_stops_at_a_single_waypoint(self):
        self.drive_once([(10, 0)], 12.0)

    def test_stops_at_a_single_waypoint_behind(self):
        self.drive_once([(-8, 0)], 20.0)

    def test_stops_at_waypoints_nearer_to_each_other_than_the_radius(self):
        self.drive_once([(5, 0), (5.36, 0)], 8.0)

    def test_stops_at_a_waypoint_doubled(self):
        self.drive_once([(5, 0), (5, 0), (5, 0)], 8.0)

    def test_goes_on_along_a_route_made_anew_grown_or_shortened(self):
        self.order("loop", False)
        try:
            self.send([(5, 0), (15, 0), (25, 0)])
            self.drive_past(8.0)
            for route in ([(5.0000001, 0), (15, -0.0000001), (25, 0)],
                          [(5, 0.004), (15, 0.004), (25, 0.004)],
                          [(5, 0), (15, 0), (25, 0), (35, 0)],
                          [(15, 0), (25, 0), (35, 0)]):
                self.send(route)
                self.drive_past(self.x + 1.5)
            self.drive_past(18.0)
            self.send([(25, 0), (35, 0)])
            self.drive("finished", 40.0)
            self.assertGreater(self.x, 33.9)
            self.assertLess(self.way, 36.0)
        finally:
            self.order("loop", True)

    def place(self, x, y, yaw):
        message = PoseStamped()
        message.header.frame_id = "map"
        message.header.stamp = rospy.Time(self.time)
        message.pose.position.x, message.pose.position.y = x, y
        message.pose.orientation.z, message.pose.orientation.w = math.sin(0.5 * yaw), math.cos(0.5 * yaw)
        return message

    def test_drives_to_a_goal_of_rviz_with_its_heading(self):
        self.goal.publish(self.place(10.0, 5.0, 1.5))
        self.drive("driving")
        self.drive("finished")
        while self.cmd_vel.message.linear.x > 0.0:
            self.step()
        self.assertLess(math.hypot(self.x - 10.0, self.y - 5.0), 0.1)
        self.assertAlmostEqual(self.yaw, 1.5, delta=0.1)

    def test_drives_along_the_plan_of_a_planner_once(self):
        plan = Path()
        plan.header.frame_id = "map"
        plan.poses = [self.place(0.2 * i, 0.05 * i, 0.0) for i in range(80)]
        self.plan.publish(plan)
        self.drive("driving")
        self.drive_past(8.0)
        self.drive("finished", 20.0)
        end = time.time() + 8.0  # progress is told once a second
        while self.to_go.message.waypoints != 80:
            self.assertLess(time.time(), end, self.to_go.message)
            self.send_pose(self.x, self.y, self.yaw, stamp=rospy.Time(self.time))
            time.sleep(0.05)

    def test_stops_at_once_when_the_route_is_emptied(self):
        self.send([(10, 0)])
        self.drive_past(3.0)
        self.send([])
        self.assertEqual(self.expect_silent("stopped: no waypoints").speed, 0.0)


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "steering_routes", SteeringRoutesTest)
