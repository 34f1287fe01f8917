#!/usr/bin/python3
"""steering_node stops before a building that the simulator's scanner sees: safety by scans without hardware."""
import math
import time
import unittest

import rospy
import rostest
from multipath_localization.msg import LocalizationState
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String

from steering_case import Last

FRONT_OF_THE_SHED = 8.0  # [m] in map, east: the robot comes from its west


class SteeringScanTest(unittest.TestCase):
    def test_stops_before_the_building_ahead(self):
        rospy.init_node("steering_scan_test")
        state = rospy.Publisher("localization/state", LocalizationState, queue_size=1, latch=True)
        state.publish(LocalizationState(state=LocalizationState.GOOD))
        status, truth, scan = Last("steering/status", String), Last("truth", Odometry), Last("scan", LaserScan)
        end = time.time() + 60.0
        while time.time() < end and not self.stands_before_it(status, truth):
            time.sleep(0.1)
        self.assertTrue(self.stands_before_it(status, truth), f"{status.message} {truth.message}")
        x = truth.message.pose.pose.position.x
        self.assertGreater(x, 3.0)
        self.assertLess(x, FRONT_OF_THE_SHED - 0.5)
        self.assertEqual(scan.message.header.frame_id, "base_link")
        ahead = scan.message.ranges[round(-scan.message.angle_min / scan.message.angle_increment)]
        self.assertLess(abs(ahead - (FRONT_OF_THE_SHED - x)), 0.1)
        self.assertTrue(math.isinf(scan.message.ranges[0]))  # behind it

    @staticmethod
    def stands_before_it(status, truth):
        if not status.message or not truth.message:
            return False
        return status.message.data.startswith("stopped: obstacle") and abs(truth.message.twist.twist.linear.x) < 1e-3


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "steering_scan", SteeringScanTest)
