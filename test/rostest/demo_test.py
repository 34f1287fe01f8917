#!/usr/bin/python3
"""Simulator, localisation and steering together: a lap of the loop on the estimate, the error bounded."""
import math
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Vector3Stamped
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

LAP_LIMIT = 400.0  # [s] simulated; the loop is 200 m long
WALL_LIMIT = 100.0  # [s]
START = 30.0  # [s] from here on the pose is scored


def rms(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


class Demo(unittest.TestCase):
    def setUp(self):
        self.truth, self.shadowed, self.estimates, self.fixes, self.progress = {}, {}, {}, {}, 0.0
        self.subscribers = [
            rospy.Subscriber('truth', Odometry, lambda m: self.keep(self.truth, m)),
            rospy.Subscriber('odometry/filtered_map', Odometry, lambda m: self.keep(self.estimates, m)),
            rospy.Subscriber('odometry/gps', Odometry, lambda m: self.keep(self.fixes, m)),
            rospy.Subscriber('truth/bias', Vector3Stamped, self.on_bias),
            rospy.Subscriber('steering/progress', Float64, self.on_progress)]

    @staticmethod
    def keep(track, message):
        position = message.pose.pose.position
        track[message.header.stamp.to_nsec()] = (position.x, position.y)

    def on_bias(self, message):
        self.shadowed[message.header.stamp.to_nsec()] = message.vector.z > 0.0

    def on_progress(self, message):
        self.progress = message.data

    def test_lap(self):
        begin, started = time.monotonic(), None
        while time.monotonic() - begin < WALL_LIMIT and self.progress < 1.0:
            time.sleep(0.2)
            now = rospy.Time.now().to_sec()
            started = started or now or None
            if started and now - started > LAP_LIMIT:
                break
        for subscriber in self.subscribers:
            subscriber.unregister()
        self.assertGreaterEqual(self.progress, 1.0, 'laps')
        self.check_errors()

    def errors_of(self, track):
        """Distances from the truth, by whether the antenna was in shadow."""
        first, errors = min(self.estimates), {True: [], False: []}
        for stamp, (x, y) in list(track.items()):
            self.assertTrue(math.isfinite(x) and math.isfinite(y))
            if stamp in self.truth and stamp in self.shadowed and stamp - first > START * 1e9:
                true_x, true_y = self.truth[stamp]
                errors[self.shadowed[stamp]].append(math.hypot(x - true_x, y - true_y))
        return errors

    def check_errors(self):
        poses, fixes = self.errors_of(self.estimates), self.errors_of(self.fixes)
        for name, errors in (('poses', poses), ('fixes', fixes)):
            print('%s: open sky %.2f m, shadow %.2f m, max %.2f m' % (
                name, rms(errors[False]), rms(errors[True]), max(errors[True] + errors[False])))
        # The first shadow of the simulator's first seed is the hardest of 16: on their mean the error in it is a fifth. What is
        # left of it under open sky differs from run to run, by which message comes first: 1 to 3 m.
        self.assertLess(rms(poses[False]), 0.8 * rms(fixes[True]), 'm RMS under open sky, beside the fixes in shadow')
        self.assertLess(rms(poses[True]), 0.8 * rms(fixes[True]), 'm RMS in shadow, beside the fixes')
        self.assertLess(max(poses[True] + poses[False]), max(fixes[True] + fixes[False]), 'm')


if __name__ == '__main__':
    rospy.init_node('demo_test')
    rostest.rosrun('multipath_localization', 'demo', Demo)
