#!/usr/bin/python3
"""gnss_epoch_node plays the end of a drive again and again: time goes on, odometry starts at zero."""
import shutil
import unittest

import rospy
import rostest
from gnss_epoch_drive import RATE
from nav_msgs.msg import Odometry


class GnssEpochNodeLoopTest(unittest.TestCase):
    def test_time_goes_on_when_a_drive_is_played_again(self):
        messages = []
        listener = rospy.Subscriber('odom', Odometry, messages.append, queue_size=5000)
        folder = rospy.get_param('/gnss_epoch/drive')
        end = rospy.Time.now() + rospy.Duration(30.0)
        while len(messages) < 100 and rospy.Time.now() < end:
            rospy.sleep(0.1)
        listener.unregister()
        shutil.rmtree(folder)
        stamps = [message.header.stamp.to_sec() for message in messages]
        self.assertGreaterEqual(len(stamps), 100)
        self.assertLess(abs(stamps[-1] - rospy.Time.now().to_sec()), 30.0, 'seconds: without /clock it is now')
        gaps = [b - a for a, b in zip(stamps, stamps[1:])]
        again = [i for i, gap in enumerate(gaps, 1) if gap > 0.5]
        self.assertGreaterEqual(len(again), 2)
        for i in again:
            self.assertAlmostEqual(gaps[i - 1], 1.5, delta=1e-3)
            self.assertLess(messages[i].pose.pose.position.x, 0.2, 'metres: odometry starts at zero')
        for i, gap in enumerate(gaps, 1):
            if i not in again:
                self.assertAlmostEqual(gap, 1.0 / RATE, delta=1e-3)


if __name__ == '__main__':
    rospy.init_node('gnss_epoch_node_loop_test')
    rostest.rosrun('multipath_localization', 'gnss_epoch_node_loop', GnssEpochNodeLoopTest)
