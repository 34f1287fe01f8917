#!/usr/bin/python3
"""Pairs of fixes and raw epochs reach the estimators that use them; others say so, and bad ones are told why."""
import copy
import math
import re
import time
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rosgraph_msgs.msg import Log
from std_srvs.srv import Empty
from synthetic_drive import Robot, Session, antenna_transform, yaw_of


def spoilt(message, spoil):
    spoil(message)
    return message


class LocalizationGnss(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.static_tf = tf2_ros.StaticTransformBroadcaster()
        cls.static_tf.sendTransform([antenna_transform('gps_left', 0.0, 0.5),
                                     antenna_transform('gps_right', 0.0, -0.5)])

    def setUp(self):
        self.diagnostics, self.log = {}, []
        self.listeners = [rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics),
                          rospy.Subscriber('/rosout_agg', Log, self.log.append)]

    def tearDown(self):
        for space in ('', 'dual/', 'raw/', 'late/'):
            rospy.ServiceProxy(space + 'localization/reset', Empty)()

    def on_diagnostics(self, message):
        for entry in message.status:
            self.diagnostics[entry.name] = entry

    def test_takes_the_delay_of_a_receiver_off(self):
        session, robot = Session('late/'), Robot(seed=4, noise=0.05, yaw_rate=0.0)
        session.drive(robot, 1.0, fix_every=0, answered=False)
        reasons = []
        for _ in range(40):
            earlier = copy.copy(robot)
            for _ in range(6):
                robot.step()
                session.send_odometry(robot.odometry(), answered='accepted' in reasons)
            late = earlier.fix()
            late.header.stamp = robot.odometry().header.stamp
            report = session.send_fix(late)
            self.assertAlmostEqual(report.header.stamp.to_sec(), earlier.stamp, places=3)
            reasons.append(report.reason)
        # The first may overtake odometry that nobody waits to be answered.
        self.assertEqual(set(reasons[1:]), {'accepted'})
        robot.step()
        pose = session.send_odometry(robot.odometry())
        self.assertLess(robot.error_of(pose.pose.pose), 0.3, 'metres; it drives 0.6 m in the delay')

    def test_what_an_estimator_has_no_use_for(self):
        session, robot = Session(), Robot(seed=1)
        session.begin(robot)
        for _ in range(10):
            session.drive(robot, 0.2)
            report = session.send_epoch(robot.epoch())
            self.assertEqual((report.kind, report.reason, report.satellites), ('epoch', 'unused', 8))
            report = session.send_pair(robot.pair())
            self.assertEqual((report.kind, report.reason, report.header.frame_id), ('dual', 'unused', 'gps_left'))
        pose = session.drive(robot, 10.0)[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 1.0, 'metres')
        name = 'localization: epoch'
        session.wait(lambda: name in self.diagnostics, 'diagnostics')
        self.assertEqual(self.diagnostics[name].level, DiagnosticStatus.OK)
        self.assertIn('no use', self.diagnostics[name].message)
        session.wait(lambda: re.search(r'declared 0\.30 m, observed 0\.\d\d m, using [01]\.\d\d m',
                                       self.diagnostics['localization: fix'].message), 'the sigmas of fixes')
        complaints = [entry.msg for entry in self.log
                      if entry.name == '/localization' and entry.level >= Log.WARN
                      and 'no transform from base_link to gps:' not in entry.msg]
        self.assertEqual(complaints, [])

    def test_bad_epochs(self):
        session, robot = Session(), Robot(seed=2)
        session.begin(robot)
        for spoil, reason in (
                (lambda m: setattr(m.header, 'stamp', rospy.Time()), 'zero stamp'),
                (lambda m: setattr(m, 'pseudoranges', m.pseudoranges * 40), 'too many satellites'),
                (lambda m: setattr(m, 'pseudoranges', []), 'too few satellites'),
                (lambda m: [setattr(p, 'pseudorange', math.nan) for p in m.pseudoranges], 'too few satellites'),
                (lambda m: [setattr(p.position, 'x', 1e308) for p in m.pseudoranges], 'too few satellites'),
                (lambda m: setattr(m.pseudoranges[0], 'pseudorange', math.inf), 'unused')):
            self.assertEqual(session.send_epoch(spoilt(robot.epoch(), spoil)).reason, reason)

    def drive_by_epochs(self, session, robot, seconds):
        """Epochs with one useless satellite each; the last pose."""
        def send(robot):
            epoch = robot.epoch()
            epoch.pseudoranges[0].pseudorange = math.nan
            report = session.send_epoch(epoch)
            self.assertEqual((report.reason, report.usable_satellites), ('accepted', 7))
        session.drive(robot, seconds, answered=False, send=send)
        return session.drive(robot, 0.05, fix_every=0)[-1]

    def test_raw_epochs_tell_the_pose_and_fixes_stand_in_for_them(self):
        session, robot = Session('raw/'), Robot(seed=4)
        session.send_odometry(robot.odometry(), answered=False)
        time.sleep(0.1)  # of fixes that come before any odometry only the last counts
        for _ in range(2):
            session.gps.publish(robot.fix())
        self.assertEqual(session.send_fix(robot.fix()).reason, 'not needed')
        session.wait(lambda: len(session.reports) == 3, 'all reports')
        pose = self.drive_by_epochs(session, robot, 45.0)
        self.assertLess(robot.error_of(pose.pose.pose), 1.5, 'metres; the datum is the first of three fixes')
        self.assertEqual(session.states[-1].name, 'GOOD')

        first, number = len(session.reports), len(session.states)
        pose = session.drive(robot, 20.0)[-1]
        reasons = [report.reason for report in session.reports[first:]]
        self.assertEqual(set(reasons), {'not needed', 'accepted'})
        self.assertAlmostEqual(0.2 * reasons.count('not needed'), 2.0, delta=0.4, msg='seconds')
        self.assertLess(robot.error_of(pose.pose.pose), 1.5, 'metres')
        self.assertEqual({state.name for state in session.states[number:]} - {'GOOD', 'MULTIPATH'}, set())
        self.assertIn('fixes', session.states[-1].reason)
        self.assertIn('no pseudoranges for', session.states[-1].reason)
        name = 'raw/localization: fix'
        self.diagnostics.clear()
        session.wait(lambda: self.level_of(name) == DiagnosticStatus.OK, 'diagnostics without a fault of fixes')

        pose = self.drive_by_epochs(session, robot, 10.0)
        self.assertLess(robot.error_of(pose.pose.pose), 1.5, 'metres')
        self.assertEqual(session.states[-1].reason, 'pseudoranges agree with odometry')
        self.assertEqual(session.send_fix(robot.fix()).reason, 'not needed')
        session.drive(robot, 5.0, fix_every=0)
        self.assertEqual(session.states[-1].name, 'DEAD_RECKONING')

    def level_of(self, status):
        return next((entry.level for name, entry in self.diagnostics.items() if name.endswith(status)), None)

    def test_fixes_alone_do_where_raw_epochs_never_come(self):
        session, robot = Session('raw/'), Robot(seed=5)
        session.send_odometry(robot.odometry(), answered=False)
        time.sleep(0.1)  # of fixes that come before any odometry only the last counts
        for _ in range(2):
            session.gps.publish(robot.fix())  # which tell the datum with the next one
        session.drive(robot, 2.5, answered=False)
        pose = session.drive(robot, 15.0)[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 1.5, 'metres')
        self.assertIn('fixes', session.states[-1].reason)

    def test_pairs_tell_the_heading_at_rest(self):
        session, robot = Session('dual/'), Robot(seed=3, yaw=2.5, speed=0.0, yaw_rate=0.0)
        while True:  # the static transforms may be under way
            session.send_odometry(robot.odometry(), answered=False)
            if session.send_pair(robot.pair()).reason != 'invalid frame':
                break
            robot.step()
        pose = session.drive(robot, 3.0, send=lambda r: session.send_pair(r.pair()))[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 0.05, 'metres')
        turn = yaw_of(pose.pose.pose.orientation) - robot.yaw
        self.assertLess(abs(math.remainder(turn, 2.0 * math.pi)), 0.05)
        self.assertEqual({report.kind for report in session.reports}, {'dual'})
        self.check_defective_pairs(session, robot)

    def check_defective_pairs(self, session, robot):
        left, right = robot.pair()
        right.header.stamp += rospy.Duration(0.2)
        session.left.publish(left)
        session.right.publish(right)
        session.drive(robot, 1.5, fix_every=0)
        number = len(session.reports)
        session.send_pair(robot.pair())  # a second later, which gives up what waits
        session.wait(lambda: len(session.reports) == number + 3, 'the reports on all three')
        unpaired = [(r.kind, r.header.frame_id) for r in session.reports if r.reason == 'unpaired']
        self.assertEqual(sorted(unpaired), [('dual', 'gps_left'), ('dual', 'gps_right')])
        self.assertEqual(session.reports[-1].reason, 'accepted')
        for spoil, reason in ((lambda pair: setattr(pair[1].status, 'status', -1), 'no fix'),
                              (lambda pair: setattr(pair[0], 'latitude', math.nan), 'not finite'),
                              (lambda pair: setattr(pair[1].header, 'frame_id', 'nowhere'), 'invalid frame'),
                              (lambda pair: setattr(pair[1].header, 'frame_id', 'gps_left'), 'invalid frame')):
            robot.step()
            session.send_odometry(robot.odometry())
            self.assertEqual(session.send_pair(spoilt(robot.pair(), spoil)).reason, reason)


if __name__ == '__main__':
    rospy.init_node('localization_gnss_test')
    rostest.rosrun('multipath_localization', 'localization_gnss', LocalizationGnss)
