#!/usr/bin/python3
"""A heading on `heading`: used, said to be, refused with a reason, and missed where it falls silent."""
import math
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from multipath_localization.msg import LocalizationState
from sensor_msgs.msg import Imu
from std_srvs.srv import Empty
from synthetic_drive import Robot, Session

STEP = 0.05  # [s] from one odometry to the next
SIGMA = 0.02  # [rad]


def turn(message, robot):
    """Gives an orientation the robot's yaw, with noise."""
    yaw = robot.yaw + robot.random.gauss(0.0, SIGMA)
    message.z, message.w = math.sin(0.5 * yaw), math.cos(0.5 * yaw)


def imu_of(robot):
    message = Imu()
    message.header.stamp = rospy.Time.from_sec(round(robot.stamp, 6))
    message.header.frame_id = 'base_link'
    turn(message.orientation, robot)
    message.orientation_covariance[8] = SIGMA ** 2
    return message


class LocalizationHeading(unittest.TestCase):
    def setUp(self):
        self.diagnostics = {}
        self.heading = rospy.Publisher('heading', Imu, queue_size=1000)
        self.listener = rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        rospy.wait_for_service('localization/reset', 10.0)
        rospy.ServiceProxy('localization/reset', Empty)()
        self.session = Session()
        self.session.wait(self.heading.get_num_connections, 'the node')

    def tearDown(self):
        self.session.close()

    def on_diagnostics(self, message):
        for entry in message.status:
            self.diagnostics[entry.name.split(': ')[-1]] = entry

    def report_on(self, message):
        return self.session.reported(lambda: self.heading.publish(message), message.header.stamp)

    def drive(self, robot, seconds, heading_of):
        """Odometry at 20 Hz, fixes and headings at 5 Hz; the last pose."""
        pose = None
        for i in range(int(round(seconds / STEP))):
            robot.step(STEP)
            pose = self.session.send_odometry(robot.odometry(), answered=bool(self.session.poses))
            if i % 4:
                continue
            self.session.send_fix(robot.fix())
            if heading_of is not None:
                self.report_on(heading_of(robot))
        return pose

    def drive_until(self, robot, holds, heading_of):
        """Drives on until the diagnostics of the heading are as they ought to be."""
        def told():
            self.drive(robot, 0.2, heading_of)
            return 'heading' in self.diagnostics and holds(self.diagnostics['heading'])
        self.session.wait(told, 'word of the heading')

    def test_it_is_used_and_missed_when_it_falls_silent(self):
        robot = Robot(seed=5)
        self.session.begin(robot)
        way = 0.0
        while self.session.states[-1].state in (LocalizationState.NOT_READY, LocalizationState.ALIGNING):
            self.assertLess(way, 30.0, 'metres of driving')
            self.drive(robot, 0.2, imu_of)
            way += 0.2 * robot.speed
        self.assertIn(('heading', 'accepted'), [(report.kind, report.reason) for report in self.session.reports])
        self.drive_until(robot, lambda entry: 'arrives and is used' in entry.message, imu_of)
        self.drive_until(robot, lambda entry: entry.level != DiagnosticStatus.OK, None)
        pose = self.drive(robot, 5.0, None)
        self.assertLess(robot.error_of(pose.pose.pose), 1.5)

    def test_bad_headings_are_refused_with_their_reason(self):
        robot = Robot(seed=7)
        self.session.begin(robot)
        self.drive(robot, 1.0, None)
        for z, covariance, unknown, reason in ((math.nan, 0.01, 0.0, 'invalid orientation'),
                                               (0.0, -0.01, 0.0, 'invalid covariance'), (0.0, 0.01, -1.0, 'unused')):
            message = imu_of(robot)
            message.orientation.z, message.orientation.w = z, 1.0
            message.orientation_covariance[8], message.orientation_covariance[0] = covariance, unknown
            report = self.report_on(message)
            self.assertEqual((report.kind, report.reason), ('heading', reason))
        self.assertIsNotNone(self.drive(robot, 1.0, None))


if __name__ == '__main__':
    rospy.init_node('localization_heading_test')
    rostest.rosrun('multipath_localization', 'localization_heading', LocalizationHeading)
