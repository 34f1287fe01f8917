#!/usr/bin/python3
"""gnss_epoch_node plays a drive once: everything in it, on its stamps and the clock, and leaves."""
import math
import shutil
import threading
import time
import unittest

import rosgraph
import rospy
import rostest
import tf2_ros
from gnss_epoch_drive import RATE, SECONDS
from multipath_localization.msg import FixReport, GnssEpoch
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import NavSatFix


class Recorder:
    def __init__(self, topic, kind):
        self.messages, self.lock = [], threading.Lock()
        self.subscriber = rospy.Subscriber(topic, kind, self.take, queue_size=5000, tcp_nodelay=True)

    def take(self, message):
        with self.lock:
            self.messages.append(message)

    def stamps(self):
        return [message.header.stamp.to_sec() for message in self.messages]


class GnssEpochNodeTest(unittest.TestCase):
    def wait_until_it_publishes(self, expected, timeout=40.0):
        master = rosgraph.Master('/gnss_epoch_node_test')
        for _ in range(int(timeout / 0.1)):
            if ('/gnss/epoch' in dict(master.getSystemState()[0])) == expected:
                return
            time.sleep(0.1)
        self.fail('the node does not come up' if expected else 'the node does not leave')

    def test_a_drive_is_played_once(self):
        odometry, epochs = Recorder('odom', Odometry), Recorder('gnss/epoch', GnssEpoch)
        fixes, truth = Recorder('gps/fix', NavSatFix), Recorder('truth', Odometry)
        poses, clock = Recorder('odometry/filtered_map', Odometry), Recorder('/clock', Clock)
        reports = Recorder('localization/fix_report', FixReport)
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        folder = rospy.get_param('/gnss_epoch/drive')
        self.wait_until_it_publishes(True)
        self.wait_until_it_publishes(False)
        time.sleep(1.0)

        count = int(SECONDS * RATE) + 1
        measured = len(range(0, count, 4))
        self.assertEqual([len(r.messages) for r in (odometry, truth, fixes, epochs)],
                         [count, count, measured, measured])
        for recorder, step in ((odometry, 1), (truth, 1), (fixes, 4), (epochs, 4)):
            for i, stamp in enumerate(recorder.stamps()):
                self.assertAlmostEqual(stamp, 100.0 + step * i / RATE, delta=1e-6)
        times = [message.clock.to_sec() for message in clock.messages]
        self.assertEqual(times, sorted(times))
        self.assertGreaterEqual(times[-1], 100.0 + SECONDS)
        for frame in ('odom', 'base_link'):
            self.assertTrue(buffer.can_transform(frame, 'gps', rospy.Time()), frame)
        self.assertTrue(buffer.can_transform('earth', 'map', rospy.Time()))
        self.check_the_localization(poses.messages[-1], reports.messages, truth.messages[-1])
        del listener
        shutil.rmtree(folder)

    def check_the_localization(self, pose, reports, truth):
        accepted = {report.kind for report in reports if report.accepted}
        self.assertEqual(accepted, {'epoch'})
        error = math.hypot(pose.pose.pose.position.x - truth.pose.pose.position.x,
                           pose.pose.pose.position.y - truth.pose.pose.position.y)
        self.assertLess(error, 3.0, 'metres')


if __name__ == '__main__':
    rospy.init_node('gnss_epoch_node_test')
    rostest.rosrun('multipath_localization', 'gnss_epoch_node', GnssEpochNodeTest)
