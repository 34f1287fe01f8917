#!/usr/bin/python3
"""Bad input is refused with its reason; the poses stay finite and near the truth, the node alive."""
import math
import random
import re
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from synthetic_drive import Robot, Session, numbers_of

NAN, INFINITY = float('nan'), float('inf')


def stamped(seconds):
    def change(fix):
        fix.header.stamp = rospy.Time.from_sec(fix.header.stamp.to_sec() + seconds) if seconds else rospy.Time()
    return change


def covariance(*diagonal, kind=2):
    def change(fix):
        fix.position_covariance = [diagonal[0], 0, 0, 0, diagonal[1], 0, 0, 0, 1.0]
        fix.position_covariance_type = kind
    return change


def field(name, value):
    return lambda fix: setattr(fix, name, value)


def status(value):
    def change(fix):
        fix.status.status = value
    return change


def frame(name):
    def change(fix):
        fix.header.frame_id = name
    return change


FIXES = [
    (stamped(0), 'zero stamp'), (stamped(60.0), 'future stamp'), (stamped(-60.0), 'old stamp'),
    (status(-1), 'no fix'),
    (field('latitude', NAN), 'not finite'), (field('longitude', INFINITY), 'not finite'),
    (field('latitude', 1e308), 'invalid position'), (field('longitude', 181.0), 'invalid position'),
    (field('latitude', -52.5), 'invalid position'), (field('altitude', 1e308), 'invalid position'),
    (covariance(NAN, 1.0), 'invalid covariance'), (covariance(1e308, 1e308), 'invalid covariance'),
    (covariance(-1.0, 1.0), 'invalid covariance'), (covariance(1.0, 1.0, kind=9), 'invalid covariance'),
    (field('altitude', NAN), 'accepted'), (covariance(0.0, 0.0), 'accepted'), (covariance(NAN, NAN, kind=0), 'accepted'),
    (frame('nowhere'), 'accepted'), (frame('/nowhere'), 'accepted'), (frame(''), 'accepted'),
]


def odometry_with(change):
    def make(robot):
        message = robot.odometry()
        change(message)
        return message
    return make


def spoil(message, path, value):
    for name in path[:-1]:
        message = getattr(message, name)
    setattr(message, path[-1], value)


ODOMETRY = [odometry_with(lambda m, p=path, v=value: spoil(m, p, v))
            for path in (('pose', 'pose', 'position', 'x'), ('pose', 'pose', 'orientation', 'z'),
                         ('twist', 'twist', 'linear', 'x'), ('twist', 'twist', 'angular', 'z'))
            for value in (NAN, INFINITY, 1e308)] + [
    odometry_with(lambda m: spoil(m, ('header', 'stamp'), rospy.Time())),
    odometry_with(lambda m: spoil(m, ('header', 'stamp'), rospy.Time(4294967295, 0))),
    odometry_with(lambda m: spoil(m, ('header', 'stamp'), m.header.stamp - rospy.Duration(0.5))),
    odometry_with(lambda m: spoil(m, ('header', 'stamp'), m.header.stamp - rospy.Duration(500.0))),
    odometry_with(lambda m: spoil(m, ('header', 'frame_id'), 'map'))]


class LocalizationBadInput(unittest.TestCase):
    def setUp(self):
        self.diagnostics = {}
        self.listener = rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        self.session = Session()

    def on_diagnostics(self, message):
        for entry in message.status:
            self.diagnostics[entry.name.split(': ')[-1]] = entry

    def test_storm(self):
        robot = Robot(seed=1, start=2.2e9)  # later than the longest ros::Duration
        self.session.begin(robot)
        self.session.drive(robot, 20.0)
        self.storm_of_transforms()
        self.storm_of_fixes(robot)
        self.storm_of_odometry(robot)
        self.storm_of_poses(robot)
        pose = self.session.drive(robot, 10.0)[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 1.0, 'metres, after all this')
        for answers in self.session.poses.values():
            self.assertTrue(all(math.isfinite(number) for answer in answers for number in numbers_of(answer)))
        self.check_diagnostics()
        self.drive_until_good(robot)
        self.check_frozen(robot)
        self.check_another_broadcaster()

    def check_another_broadcaster(self):
        self.assertNotEqual(self.diagnostics['tf'].level, DiagnosticStatus.ERROR)
        stranger = TransformStamped()
        stranger.header.frame_id, stranger.child_frame_id = 'world', '/odom'
        stranger.transform.rotation.w = 1.0
        broadcaster = tf2_ros.TransformBroadcaster()

        def told():
            stranger.header.stamp = rospy.Time.now()
            broadcaster.sendTransform(stranger)  # time and again: the node may not be connected yet
            return self.diagnostics['tf'].level == DiagnosticStatus.ERROR
        self.session.wait(told, 'an error of tf')
        self.assertIn(rospy.get_name() + ' broadcasts a parent of odom', self.diagnostics['tf'].message)

    def drive_until_good(self, robot, at_most=90.0):
        """Odometry that was lost in a storm looks like biased fixes for a while."""
        for _ in range(int(at_most / 10.0)):
            if self.session.states[-1].name == 'GOOD':
                return
            self.session.drive(robot, 10.0)
        self.fail('still %s' % self.session.states[-1].name)

    def check_frozen(self, robot):
        fix, speed, robot.yaw_rate = robot.fix(), robot.speed, 0.0

        def send(robot):
            fix.header.stamp = robot.odometry().header.stamp
            self.session.send_fix(fix)
        robot.speed = 0.0
        self.session.drive(robot, 5.0, send=send)
        self.assertEqual(self.session.reports[-1].reason, 'repeated', 'of a parked robot')

        def stays_sound():
            self.session.drive(robot, 0.2, send=send)  # time and again: silence is no sound input
            return self.diagnostics['fix'].level == DiagnosticStatus.OK
        self.session.wait(stays_sound, 'diagnostics of a parked robot')
        self.assertEqual(self.session.states[-1].name, 'GOOD')
        robot.speed = speed
        self.session.drive(robot, 6.0, send=send)
        self.assertEqual(self.session.reports[-1].reason, 'frozen')

        def told_frozen():
            self.session.drive(robot, 0.2, send=send)
            return re.search(r'receiver frozen \d+ s', self.diagnostics['fix'].message)
        self.session.wait(told_frozen, 'a frozen receiver')
        self.assertEqual(self.diagnostics['fix'].level, DiagnosticStatus.ERROR)
        self.session.drive(robot, 0.4)
        self.assertEqual(self.session.reports[-1].reason, 'accepted')

    def storm_of_transforms(self):
        broadcaster = tf2_ros.TransformBroadcaster()
        self.session.wait(broadcaster.pub_tf.get_num_connections, 'the subscriber of tf')
        for stamp, path, value in ((4294967290, (), None), (4294967295, (), None), (0, ('rotation', 'w'), NAN),
                                   (0, ('rotation', 'w'), 7.0), (0, ('rotation', 'w'), INFINITY),
                                   (0, ('translation', 'x'), NAN), (0, ('translation', 'x'), INFINITY)):
            transform = TransformStamped()
            transform.header.frame_id, transform.child_frame_id = 'base_link', 'gps'
            transform.header.stamp = rospy.Time(stamp)
            transform.transform.rotation.w = 1.0
            if path:
                spoil(transform.transform, path, value)
            broadcaster.sendTransform(transform)

    def storm_of_fixes(self, robot):
        for change, reason in FIXES * 2:
            self.session.drive(robot, 0.2)
            robot.step()
            self.session.send_odometry(robot.odometry())
            fix = robot.fix()
            change(fix)
            self.assertEqual(self.session.send_fix(fix).reason, reason)

    def storm_of_odometry(self, robot):
        order = random.Random(5)
        for make in order.sample(ODOMETRY, len(ODOMETRY)) * 2:
            self.session.drive(robot, 0.1)
            known = len(self.session.poses)
            self.session.send_odometry(make(robot), answered=False)
            self.session.send_odometry(robot.odometry(), answered=False)  # repeated
            robot.step()
            self.session.send_odometry(robot.odometry())
            self.assertEqual(len(self.session.poses), known + 1, 'no answer to what was refused')

    def storm_of_poses(self, robot):
        publisher = rospy.Publisher('set_pose', PoseWithCovarianceStamped, queue_size=10)
        self.session.wait(publisher.get_num_connections, 'the subscriber of set_pose')
        for path, value in ((('pose', 'pose', 'position', 'x'), NAN), (('pose', 'pose', 'orientation', 'w'), 7.0),
                            (('pose', 'covariance'), [NAN] * 36), (('header', 'frame_id'), 'odom')):
            message = PoseWithCovarianceStamped()
            message.header.frame_id = 'map'
            message.pose.pose.orientation.w = 1.0
            spoil(message, path, value)
            publisher.publish(message)
        rospy.sleep(0.3)
        self.session.drive(robot, 0.2)
        self.assertNotIn('NOT_READY', [state.name for state in self.session.states[-3:]])

    def check_diagnostics(self):
        self.diagnostics.clear()  # a second old, perhaps
        self.session.wait(lambda: 'zero stamp' in str(self.diagnostics.get('fix')), 'diagnostics')
        counted = {value.key: value.value for value in self.diagnostics['fix'].values}
        self.assertEqual(counted['no fix'], '2')
        self.assertEqual(counted['invalid covariance'], '8')
        counted = {value.key: value.value for value in self.diagnostics['odometry'].values}
        self.assertEqual(counted['zero stamp'], '2')
        self.assertEqual(counted['invalid frame'], '2')
        self.assertEqual({'fix', 'odometry', 'filter', 'tf'} - set(self.diagnostics), set())
        self.assertIn('gps', self.diagnostics['tf'].message, 'the antenna frame that tf does not know')


if __name__ == '__main__':
    rospy.init_node('localization_bad_input_test')
    rostest.rosrun('multipath_localization', 'localization_bad_input', LocalizationBadInput)
