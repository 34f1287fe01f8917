#!/usr/bin/python3
"""First fixes that are nonsense, a datum far from all fixes, and antennas that tf places late or on /tf."""
import time
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rosgraph_msgs.msg import Log
from synthetic_drive import Robot, Session, antenna_transform


class LocalizationOddInput(unittest.TestCase):
    def setUp(self):
        self.log, self.diagnostics = [], {}
        self.listeners = [rospy.Subscriber('/rosout', Log, self.log.append),
                          rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)]

    def on_diagnostics(self, message):
        for entry in message.status:
            self.diagnostics[entry.name] = entry

    def told(self, session, words, space):
        """Waits for a warning of that node with these words."""
        session.wait(lambda: any(all(word in entry.msg for word in words) for entry in self.log
                                 if entry.name == '/%s/localization' % space and entry.level >= Log.WARN),
                     'a warning that says ' + ' and '.join(words))

    def test_no_datum_comes_from_nonsense(self):
        session, robot = Session('first/'), Robot(seed=1, noise=0.1)
        session.send_odometry(robot.odometry(), answered=False)
        time.sleep(0.1)
        zero = robot.fix()
        zero.latitude = zero.longitude = 0.0
        zero.position_covariance = [0.0] * 9
        self.assertEqual(session.send_fix(zero).reason, 'invalid position')
        outlier = robot.fix()
        outlier.latitude += 30.0
        session.gps.publish(outlier)
        for _ in range(3):
            robot.step()
            session.send_odometry(robot.odometry(), answered=False)
            session.gps.publish(robot.fix())
        session.wait(lambda: len(session.reports) == 5, 'all reports')
        self.assertEqual([report.reason for report in session.reports[1:]], ['invalid position'] + 3 * ['accepted'])
        pose = session.drive(robot, 25.0)[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 1.0, 'metres; the datum is the first fix that agrees')
        self.assertEqual(session.states[-1].name, 'GOOD')
        self.told(session, ['refused 1 of 1', 'invalid position'], 'first')

    def test_epochs_alone_tell_a_datum(self):
        session, robot = Session('epochs/'), Robot(seed=4)
        session.send_odometry(robot.odometry(), answered=False)
        time.sleep(0.1)
        for _ in range(3):
            session.raw.publish(robot.epoch())
            robot.step()
            session.send_odometry(robot.odometry(), answered=False)
        session.wait(lambda: len(session.reports) == 3, 'all reports')
        self.assertEqual([report.reason for report in session.reports], 3 * ['accepted'])
        pose = session.drive(robot, 1.0, send=lambda r: session.send_epoch(r.epoch()))[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 5.0, 'metres; the datum is the first epoch')

    def test_a_datum_far_from_all_fixes_is_named(self):
        session, robot = Session('far/'), Robot(seed=2)
        session.send_odometry(robot.odometry(), answered=False)
        time.sleep(0.1)
        for _ in range(12):
            robot.step()
            session.send_odometry(robot.odometry(), answered=False)
            self.assertEqual(session.send_fix(robot.fix()).reason, 'invalid position')
        words = ['the datum [1.00000000, 1.00000000] is', 'km from [52.', 'datum: [52.']
        self.told(session, words, 'far')

        def shown():  # of an input that still comes
            robot.step()
            session.odom.publish(robot.odometry())
            session.gps.publish(robot.fix())
            status = self.diagnostics.get('far/localization: fix') or self.diagnostics.get('localization: fix')
            return status and status.level == DiagnosticStatus.WARN and all(word in status.message for word in words)
        session.wait(shown, 'diagnostics')

    def test_fixes_wait_for_a_frame_that_comes_late_and_on_tf(self):
        session, robot = Session('late/'), Robot(seed=3, noise=0.1, antenna=(1.0, 0.4))
        session.send_odometry(robot.odometry(), answered=False)
        time.sleep(0.1)
        session.gps.publish(self.fix_of(robot, 'rover'))
        time.sleep(0.3)
        self.assertEqual(session.reports, [], 'it waits')
        moving_tf = tf2_ros.TransformBroadcaster()
        session.wait(lambda: moving_tf.pub_tf.get_num_connections() >= 3, 'the subscribers of tf')
        footprint, rover = antenna_transform('base_link', -0.5, 0.0), antenna_transform('rover', 0.5, 0.4)
        footprint.header.frame_id, footprint.child_frame_id = '/base_footprint', '/base_link'
        rover.header.frame_id = '/base_footprint'
        moving_tf.sendTransform([footprint, rover])
        session.wait(lambda: session.reports, 'the report')
        self.assertEqual(session.reports[0].reason, 'accepted')
        poses = session.drive(robot, 25.0, send=lambda r: session.send_fix(self.fix_of(r, 'rover')))
        self.assertLess(robot.error_of(poses[-1].pose.pose), 0.4, 'metres; the antenna is 1.08 m off')
        warned = [entry.msg for entry in self.log if entry.name == '/late/localization' and entry.level >= Log.WARN
                  and not entry.msg.startswith('waiting for: ')]  # as it did before this test began
        self.assertEqual(warned, [])
        self.check_an_antenna_that_appears(session, robot, moving_tf)

    @staticmethod
    def fix_of(robot, frame):
        fix = robot.fix()
        fix.header.frame_id = frame
        return fix

    def check_an_antenna_that_appears(self, session, robot, moving_tf):
        def send(robot):
            session.send_fix(self.fix_of(robot, 'mast'))
        session.drive(robot, 1.0, send=send)
        self.told(session, ['no transform from base_link to mast', 'taken to be at the base'], 'late')
        moving_tf.sendTransform(antenna_transform('mast', 1.0, 0.4))
        time.sleep(0.2)
        robot.step()
        session.send_odometry(robot.odometry(), answered=False)
        send(robot)
        self.told(session, ['starting afresh', 'tf has placed an antenna'], 'late')


if __name__ == '__main__':
    rospy.init_node('localization_odd_input_test')
    rostest.rosrun('multipath_localization', 'localization_odd_input', LocalizationOddInput)
