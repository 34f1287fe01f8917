#!/usr/bin/python3
"""steering_node alone, on poses made up here: drives, slows, stops, says why, and resumes."""
import math
import time

import rospy
import rostest
from geometry_msgs.msg import PoseArray
from multipath_localization.msg import LocalizationState
from visualization_msgs.msg import MarkerArray

from steering_case import Last, SteeringCase, wait_for_subscribers, waypoint_array

SQUARE = [(10, 0), (10, 10), (0, 10), (0, 0)]


class SteeringNodeTest(SteeringCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.waypoints = rospy.Publisher("waypoints", PoseArray, queue_size=10)
        cls.markers = Last("steering/markers", MarkerArray)
        wait_for_subscribers(cls.pose, cls.state, cls.waypoints)

    def setUp(self):
        self.set_state(LocalizationState.GOOD)
        self.order("stop")
        self.set_waypoints(SQUARE)
        end = time.time() + 5.0
        while not self.order("start")[0] and time.time() < end:
            time.sleep(0.05)

    def set_waypoints(self, points, **how):
        self.waypoints.publish(waypoint_array(points, **how))

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

    def test_stops_on_a_pose_of_another_century(self):
        for stamp in (rospy.Time(4294967000), rospy.Time(0, 1)):
            self.expect("driving")
            self.assertEqual(self.expect("stopped: pose is", stamp=stamp).speed, 0.0)
        self.assertEqual(self.expect("driving").speed, 1.0)

    def test_drives_straight_after_a_restart_of_the_localisation(self):
        self.assertEqual(self.expect("driving", yaw=2.0).speed, 1.0)
        self.set_state(LocalizationState.NOT_READY)  # over before the next pose
        self.set_state(LocalizationState.ALIGNING)
        time.sleep(0.2)  # the pose of before is not what the distance is counted from
        command = self.expect("slow: heading", x=50.0, yaw=2.0)
        self.assertEqual((command.speed, command.steering_angle), (0.5, 0.0))

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
        self.assertAlmostEqual(self.expect("driving", sigma=1.0).speed, 1.0)
        self.assertAlmostEqual(self.expect("slow: fixes are biased", sigma=2.0).speed, 0.5)
        self.assertEqual(self.expect("stopped: fixes are biased", sigma=3.0).speed, 0.0)

    def test_brakes_and_speeds_up_within_its_limits(self):
        self.expect("driving")
        speeds = []
        self.set_state(LocalizationState.LOST)
        end = time.time() + 1.0
        while time.time() < end:
            self.send_pose(0.0, 0.0, 0.0)
            time.sleep(0.02)
            speeds.append(self.cmd_vel.message.linear.x)
        self.assertEqual(speeds[-1], 0.0)
        self.assertGreater(len([speed for speed in speeds if 0.0 < speed < 1.0]), 2)
        self.assertEqual(speeds, sorted(speeds, reverse=True))

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

    def test_refuses_waypoints_of_another_frame_not_finite_or_too_many(self):
        self.set_waypoints([(-50, 0)], frame="odom")
        self.set_waypoints([(-50, float("nan"))])
        self.set_waypoints(20000 * [(-50, 0)])
        command = self.expect("driving", 0.0, 0.0, 0.0)
        self.assertLess(abs(command.steering_angle), 0.3)  # on the way to (10, 0) still: (-50, 0) lies behind

    def test_without_waypoints_stands(self):
        self.set_waypoints([])
        self.assertEqual(self.expect("stopped: no waypoints").speed, 0.0)

    def test_waypoints_delivered_again_restart_nothing(self):
        self.expect("driving", 5.0, 5.0)
        self.assertEqual(self.order("skip"), (True, "next is waypoint 2 of 4"))
        self.set_waypoints(SQUARE)
        self.set_waypoints(SQUARE, stamp=rospy.Time(100))
        self.expect("driving", 5.0, 5.0)
        self.assertEqual(self.order("skip"), (True, "next is waypoint 3 of 4"))
        self.assertTrue(self.order("loop", False)[0])
        try:
            self.order("skip")
            self.order("skip")
            self.set_waypoints(SQUARE, stamp=rospy.Time(100))
            time.sleep(0.3)
            self.assertEqual(self.expect("finished", 5.0, 5.0).speed, 0.0)
            self.set_waypoints(SQUARE, stamp=rospy.Time(101))
            self.assertEqual(self.expect("driving", 5.0, 5.0).speed, 1.0)
        finally:
            self.order("loop", True)

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
