#!/usr/bin/python3
"""A gyro on imu/data and the velocity of the receiver on gps/velocity: used, said to be, and missed where they fail."""
import math
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import TwistWithCovarianceStamped
from multipath_localization.msg import LocalizationState
from sensor_msgs.msg import Imu
from std_srvs.srv import Empty
from synthetic_drive import Robot, Session

STEP = 0.05  # [s] from one odometry to the next


def imu_of(robot, ahead=0.0):
    message = Imu()
    message.header.stamp = rospy.Time.from_sec(round(robot.stamp + ahead, 6))
    message.header.frame_id = 'base_link'
    message.orientation_covariance[0] = -1.0
    message.angular_velocity.z = robot.yaw_rate + robot.random.gauss(0.0, 0.002)
    message.linear_acceleration.z = 9.81
    return message


def velocity_of(robot):
    message = TwistWithCovarianceStamped()
    message.header.stamp = rospy.Time.from_sec(round(robot.stamp, 6))
    message.header.frame_id = 'gps'
    message.twist.twist.linear.x = robot.speed * math.cos(robot.yaw) + robot.random.gauss(0.0, 0.05)
    message.twist.twist.linear.y = robot.speed * math.sin(robot.yaw) + robot.random.gauss(0.0, 0.05)
    message.twist.covariance[0] = message.twist.covariance[7] = 0.05 ** 2
    return message


class LocalizationMotionInputs(unittest.TestCase):
    def setUp(self):
        self.diagnostics = {}
        self.listener = rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        self.imu = rospy.Publisher('imu/data', Imu, queue_size=1000)
        self.velocity = rospy.Publisher('gps/velocity', TwistWithCovarianceStamped, queue_size=1000)
        rospy.wait_for_service('localization/reset', 10.0)
        rospy.ServiceProxy('localization/reset', Empty)()
        self.session = Session()
        self.session.wait(lambda: self.imu.get_num_connections() and self.velocity.get_num_connections(), 'the node')

    def tearDown(self):
        self.session.close()

    def on_diagnostics(self, message):
        for entry in message.status:
            self.diagnostics[entry.name.split(': ')[-1]] = entry

    def drive_until(self, robot, name, holds, **inputs):
        """Drives on, as an input that is silent is told to be, until its diagnostics are as they ought to be."""
        def told():
            self.drive(robot, 0.2, **inputs)
            return name in self.diagnostics and holds(self.diagnostics[name])
        self.session.wait(told, 'word of the ' + name)

    def drive(self, robot, seconds, fixes=True, gyro=True, velocities=False):
        """Odometry of wheels that see no turn at 20 Hz, a gyro that does, fixes and velocities at 5 Hz; the last pose."""
        pose = None
        for i in range(int(round(seconds / STEP))):
            robot.step(STEP)
            if gyro:  # a sample ahead, so that none overtakes the odometry that it is for
                self.imu.publish(imu_of(robot, STEP))
            message = robot.odometry()
            message.twist.twist.angular.z = 0.0
            pose = self.session.send_odometry(message, answered=bool(self.session.poses))
            if i % 4:
                continue
            if fixes:
                self.session.send_fix(robot.fix())
            if velocities:
                self.report_on(velocity_of(robot))
        return pose

    def report_on(self, velocity):
        return self.session.reported(lambda: self.velocity.publish(velocity), velocity.header.stamp)

    def test_a_gyro_turns_the_robot_where_its_wheels_see_no_turn(self):
        robot = Robot(seed=3)
        self.session.begin(robot)
        self.drive(robot, 40.0)
        self.drive_until(robot, 'gyro', lambda entry: 'yaw rate is used' in entry.message)
        pose = self.drive(robot, 10.0, fixes=False)
        self.assertLess(robot.error_of(pose.pose.pose), 2.0, 'metres after 20 m by gyro and wheels alone')

        broken = imu_of(robot, STEP)
        broken.angular_velocity.z = math.nan
        self.imu.publish(broken)
        self.drive_until(robot, 'gyro', lambda entry: entry.level != DiagnosticStatus.OK, gyro=False)

    def test_velocities_tell_the_heading_within_metres(self):
        robot = Robot(seed=5)
        self.session.begin(robot)
        way = 0.0
        while self.session.states[-1].state == LocalizationState.NOT_READY or self.session.states[-1].yaw_sigma > 0.2:
            self.assertLess(way, 6.0, 'metres of driving')
            self.drive(robot, 0.2, velocities=True)
            way += 0.2 * robot.speed
        pose = self.drive(robot, 5.0, velocities=True)
        self.assertLess(robot.error_of(pose.pose.pose), 1.0)
        self.assertIn(('velocity', 'accepted'), [(report.kind, report.reason) for report in self.session.reports])
        self.drive_until(robot, 'velocity', lambda entry: 'arrives and is used' in entry.message, velocities=True)

    def test_bad_velocities_are_refused_with_their_reason(self):
        robot = Robot(seed=7)
        self.session.begin(robot)
        self.drive(robot, 1.0)
        for east, covariance, reason in ((math.nan, 0.01, 'not finite'), (1e4, 0.01, 'too fast'),
                                         (1.0, -1.0, 'invalid covariance')):
            message = velocity_of(robot)
            message.twist.twist.linear.x, message.twist.covariance[0] = east, covariance
            report = self.report_on(message)
            self.assertEqual((report.kind, report.reason), ('velocity', reason))
        self.assertIsNotNone(self.drive(robot, 1.0))


if __name__ == '__main__':
    rospy.init_node('localization_motion_inputs_test')
    rostest.rosrun('multipath_localization', 'localization_motion_inputs', LocalizationMotionInputs)
