#!/usr/bin/python3
"""steering_node alone, on poses made up here: drives, slows, stops, says why, and resumes."""
import math
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Pose, PoseArray, Twist
from multipath_localization.msg import LocalizationState, SteeringCommand
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64, String
from std_srvs.srv import SetBool, Trigger
from visualization_msgs.msg import MarkerArray

SQUARE = [(10, 0), (10, 10), (0, 10), (0, 0)]


class Last:
    """The last message of a topic."""

    def __init__(self, topic, kind):
        self.message = None
        self.count = 0
        self.subscriber = rospy.Subscriber(topic, kind, self.take, queue_size=100)

    def take(self, message):
        self.message = message
        self.count += 1


class SteeringNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("steering_node_test")
        cls.pose = rospy.Publisher("odometry/filtered_map", Odometry, queue_size=10)
        cls.state = rospy.Publisher("localization/state", LocalizationState, queue_size=1, latch=True)
        cls.waypoints = rospy.Publisher("waypoints", PoseArray, queue_size=10)
        cls.steering = Last("steering", SteeringCommand)
        cls.cmd_vel = Last("cmd_vel", Twist)
        cls.status = Last("steering/status", String)
        cls.progress = Last("steering/progress", Float64)
        cls.markers = Last("steering/markers", MarkerArray)
        end = time.time() + 10.0
        while time.time() < end and 0 in (cls.pose.get_num_connections(), cls.state.get_num_connections(),
                                          cls.waypoints.get_num_connections()):
            time.sleep(0.05)

    def setUp(self):
        self.set_waypoints(SQUARE)
        self.set_state(LocalizationState.GOOD)

    def order(self, name, *data):
        """Calls a service of the node; whether it was done, and the message."""
        service = f"steering/{name}"
        rospy.wait_for_service(service, 10.0)
        answer = rospy.ServiceProxy(service, SetBool if data else Trigger)(*data)
        return answer.success, answer.message

    def set_state(self, state):
        self.state.publish(LocalizationState(state=state))

    def set_waypoints(self, points, frame="map"):
        message = PoseArray()
        message.header.frame_id = frame
        for x, y in points:
            pose = Pose()
            pose.position.x, pose.position.y, pose.orientation.w = x, y, 1.0
            message.poses.append(pose)
        self.waypoints.publish(message)

    def send_pose(self, x, y, yaw, age=0.0, frame="map"):
        message = Odometry()
        message.header.stamp = rospy.Time.now() - rospy.Duration(age)
        message.header.frame_id = frame
        message.pose.pose.position.x = x
        message.pose.pose.position.y = y
        message.pose.pose.orientation.z = math.sin(0.5 * yaw)
        message.pose.pose.orientation.w = math.cos(0.5 * yaw)
        self.pose.publish(message)

    def expect(self, status, x=0.0, y=0.0, yaw=0.0, **how):
        """Sends a pose at 20 Hz until the status is as expected; the command then."""
        end = time.time() + 8.0
        while time.time() < end:
            self.send_pose(x, y, yaw, **how)
            time.sleep(0.05)
            if self.status.message and self.status.message.data.startswith(status):
                for _ in range(4):
                    self.send_pose(x, y, yaw, **how)
                    time.sleep(0.05)
                return self.steering.message
        self.fail(f"status is {self.status.message}, not {status}")

    def expect_silent(self, status):
        """Waits without sending poses until the status is as expected; the command then."""
        end = time.time() + 8.0
        while time.time() < end:
            if self.status.message and self.status.message.data.startswith(status):
                time.sleep(0.3)
                return self.steering.message
            time.sleep(0.05)
        self.fail(f"status is {self.status.message}, not {status}")

    def test_drives_towards_the_waypoint(self):
        command = self.expect("driving", 0.0, -1.0, 0.0)
        self.assertAlmostEqual(command.speed, 1.0)
        self.assertEqual(command.header.frame_id, "base_link")
        twist = self.cmd_vel.message
        self.assertAlmostEqual(twist.linear.x, 1.0)
        self.assertAlmostEqual(twist.angular.z, math.tan(command.steering_angle) / 0.5, places=6)
        self.assertIsNotNone(self.markers.message)

    def test_stops_on_a_stale_pose_and_resumes(self):
        self.expect("driving")
        stopped = self.expect_silent("stopped: pose is")
        self.assertEqual(stopped.speed, 0.0)
        count = self.steering.count
        time.sleep(0.5)
        self.assertGreater(self.steering.count, count)  # goes on saying stop
        self.assertEqual(self.expect("driving").speed, 1.0)

    def test_stops_on_poses_that_arrive_old(self):
        self.expect("driving")
        self.assertEqual(self.expect("stopped: pose is 3", age=3.0).speed, 0.0)
        self.assertEqual(self.cmd_vel.message.linear.x, 0.0)

    def test_stops_when_lost_and_resumes(self):
        self.expect("driving")
        self.set_state(LocalizationState.LOST)
        self.assertEqual(self.expect("stopped: localisation lost").speed, 0.0)
        self.set_state(LocalizationState.GOOD)
        self.assertEqual(self.expect("driving").speed, 1.0)

    def test_stops_in_a_state_it_does_not_know(self):
        self.set_state(77)
        self.assertEqual(self.expect("stopped").speed, 0.0)

    def test_slows_where_fixes_are_biased(self):
        self.set_state(LocalizationState.MULTIPATH)
        self.assertAlmostEqual(self.expect("slow").speed, 0.5)

    def test_stops_on_a_pose_that_is_not_finite(self):
        self.expect("driving")
        for x, yaw in ((float("nan"), 0.0), (0.0, float("nan")), (float("inf"), 0.0)):
            command = self.expect("stopped: pose not finite", x, 0.0, yaw)
            self.assertEqual((command.speed, command.steering_angle), (0.0, 0.0))
        self.assertEqual(self.expect("driving").speed, 1.0)

    def test_does_not_drive_by_a_pose_of_another_frame(self):
        self.expect("driving")
        self.assertEqual(self.expect("stopped: pose is", frame="odom").speed, 0.0)

    def test_counts_progress(self):
        self.expect("driving", -5.0, 0.0)
        for x, y in SQUARE + SQUARE[:1]:
            for _ in range(3):
                self.send_pose(x, y, 0.0)
                time.sleep(0.05)
        time.sleep(0.3)
        self.assertEqual(self.progress.message.data, 1.25)

    def test_refuses_waypoints_of_another_frame_or_not_finite(self):
        self.set_waypoints([(-50, 0)], frame="odom")
        self.set_waypoints([(-50, float("nan"))])
        command = self.expect("driving", 0.0, 0.0, 0.0)
        self.assertLess(abs(command.steering_angle), 0.3)  # on the way to (10, 0) still: (-50, 0) lies behind

    def test_without_waypoints_stands(self):
        self.set_waypoints([])
        self.assertEqual(self.expect("stopped: no waypoints").speed, 0.0)

    def test_obeys_its_owner(self):
        self.expect("driving")
        self.assertEqual(self.order("pause"), (True, "paused"))
        self.assertEqual(self.expect("paused: waiting for resume").speed, 0.0)
        self.assertEqual(self.cmd_vel.message.linear.x, 0.0)
        self.assertFalse(self.order("start")[0])
        self.assertTrue(self.order("resume")[0])
        self.assertEqual(self.expect("driving").speed, 1.0)
        self.assertEqual(self.order("skip"), (True, "next is waypoint 2 of 4"))
        self.assertTrue(self.order("stop")[0])
        self.assertEqual(self.expect("stopped: by order").speed, 0.0)
        self.assertFalse(self.order("resume")[0])
        self.assertEqual(self.order("start"), (True, "driving from waypoint 1 of 4"))
        self.assertEqual(self.expect("driving").speed, 1.0)

    def test_drives_no_second_round_without_loop(self):
        self.assertTrue(self.order("loop", False)[0])
        try:
            self.expect("driving", 5.0, 5.0)
            for _ in SQUARE:
                self.assertTrue(self.order("skip")[0])
            self.assertEqual(self.expect("finished", 5.0, 5.0).speed, 0.0)
        finally:
            self.order("loop", True)
            self.order("start")
        self.assertEqual(self.expect("driving").speed, 1.0)


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "steering_node", SteeringNodeTest)
