#!/usr/bin/python3
"""steering_node records waypoints, saves them, and drives along them at its owner's orders."""
import os
import shutil
import time

import rospy
import rostest
from geometry_msgs.msg import PointStamped, PoseArray, PoseStamped
from multipath_localization.msg import LocalizationState

from steering_case import SteeringCase, wait_for_subscribers, waypoint_array

LATITUDE, LONGITUDE = 35.0, 139.0
DEGREE = 110941.0  # of latitude there [m]


class SteeringWaypointsTest(SteeringCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.file = rospy.get_param("steering/waypoint_file")
        shutil.rmtree(os.path.dirname(cls.file), ignore_errors=True)
        cls.origin = rospy.Publisher("local_xy_origin", PoseStamped, queue_size=1, latch=True)
        cls.waypoints = rospy.Publisher("waypoints", PoseArray, queue_size=1)
        cls.clicked = rospy.Publisher("clicked_point", PointStamped, queue_size=10)
        wait_for_subscribers(cls.pose, cls.state, cls.origin, cls.waypoints, cls.clicked)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(os.path.dirname(cls.file), ignore_errors=True)

    def set_origin(self, latitude):
        message = PoseStamped()
        message.header.frame_id = "map"
        message.pose.position.x, message.pose.position.y = LONGITUDE, latitude
        self.origin.publish(message)
        time.sleep(0.3)

    def set_waypoints(self, points):
        self.waypoints.publish(waypoint_array(points))
        time.sleep(0.3)

    def click(self, x, y, frame="map"):
        message = PointStamped()
        message.header.frame_id = frame
        message.point.x, message.point.y = x, y
        self.clicked.publish(message)
        time.sleep(0.3)

    def test_records_saves_and_drives(self):
        self.set_state(LocalizationState.GOOD)
        self.expect("stopped: waiting for start")
        self.assertEqual(self.order("start"), (False, "no waypoints in " + self.file))
        self.assertEqual(self.order("save"), (False, "nothing is recorded"))
        self.set_origin(LATITUDE)

        self.expect("stopped: waiting for start", 10.0, 0.0)
        self.assertEqual(self.order("record"), (True, "waypoint 1, to be kept by save"))
        self.click(20.0, 5.0, "odom")
        self.click(20.0, float("nan"))
        self.click(20.0, 10.0)
        self.set_state(LocalizationState.LOST)
        self.expect("stopped: waiting for start", 30.0, 0.0)
        self.assertFalse(self.order("record")[0])
        self.set_state(LocalizationState.MULTIPATH)
        self.expect("stopped: waiting for start", 30.0, 0.0)
        done, message = self.order("record")
        self.assertTrue(done)
        self.assertTrue(message.startswith("waypoint 3, to be kept by save; beware"), message)
        self.set_state(LocalizationState.GOOD)
        self.assertEqual(self.order("save"), (True, f"3 waypoints in {self.file}; start drives along them"))
        self.expect_file([0.0, 10.0, 0.0])
        self.expect("stopped: by order", 0.0, 0.0)

        self.assertEqual(self.order("start"), (True, "driving from waypoint 1 of 3"))
        ahead = self.expect("driving", 0.0, 0.0)
        self.assertEqual(ahead.speed, 1.0)
        self.assertAlmostEqual(ahead.steering_angle, 0.0, places=3)
        self.assertTrue(self.order("pause")[0])
        self.assertEqual(self.expect("paused", 0.0, 0.0).speed, 0.0)
        self.assertEqual(self.order("skip"), (True, "next is waypoint 2 of 3"))
        self.assertTrue(self.order("resume")[0])
        self.assertGreater(self.expect("driving", 0.0, 0.0).steering_angle, 0.05)

        self.set_origin(LATITUDE + 20.0 / DEGREE)  # the second waypoint now lies 10 m south
        self.assertLess(self.expect("driving", 0.0, 0.0).steering_angle, -0.05)
        self.assertTrue(self.order("stop")[0])
        self.assertEqual(self.expect("stopped: by order", 0.0, 0.0).speed, 0.0)

    def test_waypoints_of_map_stay_where_they_are_on_the_ground(self):
        self.set_origin(LATITUDE)
        self.set_state(LocalizationState.GOOD)
        self.set_waypoints([(20.0, 10.0), (20.0, 30.0)])
        self.assertTrue(self.order("start")[0])
        self.assertGreater(self.expect("driving", 0.0, 0.0).steering_angle, 0.05)
        self.set_origin(LATITUDE + 20.0 / DEGREE)  # the first waypoint now lies 10 m south
        self.assertLess(self.expect("driving", 0.0, 0.0).steering_angle, -0.05)
        self.set_origin(LATITUDE + 3.0)
        self.assertEqual(self.expect("stopped: waypoint 1 is farther than", 0.0, 0.0).speed, 0.0)
        self.set_origin(LATITUDE)
        self.assertGreater(self.expect("driving", 0.0, 0.0).steering_angle, 0.05)
        self.assertTrue(self.order("stop")[0])

    def expect_file(self, norths):
        """Waypoints of the file, by their distance north of the origin [m]."""
        with open(self.file) as content:
            lines = content.read().splitlines()
        self.assertEqual(lines[0], "latitude,longitude")
        self.assertEqual(len(lines), 1 + len(norths))
        for line, north in zip(lines[1:], norths):
            self.assertAlmostEqual((float(line.split(",")[0]) - LATITUDE) * DEGREE, north, delta=0.01)


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "steering_waypoints", SteeringWaypointsTest)
