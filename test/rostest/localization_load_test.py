#!/usr/bin/python3
"""More work than there is time for: the node leaves out weighing and stays with the present, answers every message,
says so, and weighs all again as soon as it can. What is too large for any robot is refused."""
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from multipath_localization.msg import GnssEpoch, Pseudorange
from std_srvs.srv import Empty
from synthetic_drive import PATIENCE, Robot, Session

SECONDS, ODOMETRY_RATE, FIX_EVERY, SPED_UP = 4, 1000, 4, 20.0


class LocalizationLoad(unittest.TestCase):
    def setUp(self):
        self.filter = []
        self.listener = rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        rospy.wait_for_service('localization/reset', 10.0)
        rospy.ServiceProxy('localization/reset', Empty)()
        self.session = Session()

    def on_diagnostics(self, message):
        self.filter += [status for status in message.status if status.name.endswith('filter')]

    def overload(self, robot):
        """A drive at twenty times its speed, odometry at 1 kHz and fixes at 250 Hz, without waiting for answers; returns the
        stamps of odometry."""
        stamps = []
        for i in range(SECONDS * ODOMETRY_RATE):
            robot.step(SPED_UP / ODOMETRY_RATE)
            message = robot.odometry()
            stamps.append(message.header.stamp.to_nsec())
            self.session.odom.publish(message)
            if i % FIX_EVERY == 0:
                self.session.gps.publish(robot.fix())
            if i % 10 == 9:
                time.sleep(0.01)
        return stamps

    def test_sheds_work_not_messages(self):
        robot = Robot()
        self.session.begin(robot)
        before = len(self.session.reports)
        stamps = self.overload(robot)
        self.session.wait(lambda: stamps[-1] in self.session.poses, 'the pose of the present')
        self.session.wait(lambda: len(self.session.reports) >= before + len(stamps) // FIX_EVERY, 'all reports')
        self.assertEqual([s for s in stamps if s not in self.session.poses], [])
        reasons = [report.reason for report in self.session.reports[before:]]
        self.assertEqual(len(reasons), len(stamps) // FIX_EVERY)
        self.assertGreater(reasons.count('accepted'), 5 / PATIENCE)
        self.assertEqual(len(reasons), reasons.count('accepted') + reasons.count('overload'), set(reasons))
        self.assertGreater(reasons.count('overload'), 20)
        self.session.wait(lambda: any('does not keep up' in status.message for status in self.filter), 'diagnostics')

        fixes = [self.fix_after_a_second(robot) for _ in range(5)]
        self.assertEqual([fix.reason for fix in fixes], 5 * ['accepted'])
        seen = len(self.filter)
        self.session.wait(lambda: len(self.filter) > seen + 1, 'more diagnostics')
        self.assertNotIn('does not keep up', self.filter[-1].message)
        pose = self.session.poses[robot.odometry().header.stamp.to_nsec()][-1]
        self.assertLess(robot.error_of(pose.pose.pose), 1.0)

    def fix_after_a_second(self, robot):
        for _ in range(20):
            robot.step()
            self.session.send_odometry(robot.odometry())
        return self.session.send_fix(robot.fix())

    def test_refuses_what_is_too_large(self):
        robot = Robot()
        self.session.begin(robot)
        epoch = GnssEpoch()
        epoch.header = robot.fix().header
        epoch.pseudoranges = 100000 * [Pseudorange()]
        self.assertEqual(self.session.send_epoch(epoch).reason, 'too many satellites')
        for name in ('gps' + 1000000 * '/gps', 1000000 * '\xff'):
            fix = robot.fix()
            fix.header.frame_id = name
            self.assertEqual(self.session.send_fix(fix).reason, 'invalid frame')
            message = robot.odometry()
            message.header.frame_id = name
            message.header.stamp += rospy.Duration(0.01)
            self.session.send_odometry(message, answered=False)
        robot.step()
        pose = self.session.send_odometry(robot.odometry())
        self.assertLess(len(pose.header.frame_id), 10)


if __name__ == '__main__':
    rospy.init_node('localization_load_test')
    rostest.rosrun('multipath_localization', 'localization_load', LocalizationLoad)
