#!/usr/bin/python3
"""An RTK antenna on a mast along a slope: roll and pitch of the IMU level it, are published, and are missed when they fail."""
import math
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Quaternion
from sensor_msgs.msg import Imu, NavSatStatus
from synthetic_drive import Robot, Session, antenna_transform

STEP = 0.05  # [s] from one odometry to the next
ROLL = -math.radians(15.0)  # the left side is lower
MAST = 1.5  # [m], as antenna_transform has it
SIGMA = 0.02  # of fixes [m]


class LocalizationSlope(unittest.TestCase):
    def setUp(self):
        self.diagnostics = {}
        self.listener = rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        self.imu = rospy.Publisher('imu/data', Imu, queue_size=1000)
        self.transforms = tf2_ros.StaticTransformBroadcaster()
        self.transforms.sendTransform(antenna_transform('gps', 0.0, 0.0))
        self.session = Session()
        self.session.wait(lambda: self.imu.get_num_connections(), 'the node')

    def tearDown(self):
        self.session.close()

    def on_diagnostics(self, message):
        for entry in message.status:
            self.diagnostics[entry.name.split(': ')[-1]] = entry

    def publish_imu(self, robot):
        message = Imu()
        message.header.stamp = rospy.Time.from_sec(round(robot.stamp + STEP, 6))
        message.header.frame_id = 'base_link'
        message.orientation = Quaternion(math.sin(0.5 * ROLL), 0.0, 0.0, math.cos(0.5 * ROLL))
        message.angular_velocity.x = robot.random.gauss(0.0, 0.002)
        message.linear_acceleration.y = 9.81 * math.sin(ROLL)
        message.linear_acceleration.z = 9.81 * math.cos(ROLL)
        self.imu.publish(message)

    def drive(self, robot, seconds, imu=True):
        """Odometry and the IMU at 20 Hz, the fix of an RTK receiver at 5 Hz; the last pose."""
        pose = None
        for i in range(int(round(seconds / STEP))):
            robot.step(STEP)
            if imu:
                self.publish_imu(robot)
            pose = self.session.send_odometry(robot.odometry(), answered=bool(self.session.poses))
            if i % 4 == 0:
                fix = robot.fix()
                fix.status.status = NavSatStatus.STATUS_GBAS_FIX
                fix.position_covariance[0] = fix.position_covariance[4] = SIGMA ** 2
                self.session.send_fix(fix)
        return pose

    def drive_until(self, robot, holds, **inputs):
        """Drives on until the diagnostics of the tilt are as they ought to be."""
        def told():
            self.drive(robot, 0.2, **inputs)
            return 'tilt' in self.diagnostics and holds(self.diagnostics['tilt'])
        self.session.wait(told, 'word of the tilt')

    def test_roll_and_pitch_level_the_mast_and_are_published(self):
        leaned = -MAST * math.sin(ROLL)  # to the left
        robot = Robot(seed=3, yaw=0.5 * math.pi, yaw_rate=0.0, noise=SIGMA, antenna=(0.0, leaned))
        self.session.begin(robot)
        self.drive_until(robot, lambda entry: 'roll and pitch used' in entry.message)
        pose = self.drive(robot, 30.0).pose.pose
        self.assertLess(robot.error_of(pose), 0.15, 'metres, of 0.39 that the mast leans')
        q = pose.orientation
        up_y, up_z = 2.0 * (q.y * q.z + q.w * q.x), 1.0 - 2.0 * (q.x ** 2 + q.y ** 2)
        self.assertAlmostEqual(math.atan2(up_y, up_z), ROLL, delta=0.01)

        self.drive_until(robot, lambda entry: entry.level == DiagnosticStatus.WARN and 'silent' in entry.message, imu=False)


if __name__ == '__main__':
    rospy.init_node('localization_slope_test')
    rostest.rosrun('multipath_localization', 'localization_slope', LocalizationSlope)
