#!/usr/bin/python3
"""What wheels do becomes odometry: of four wheels' joints, and of speed and steering, on circles; and what is refused."""
import math
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from genpy.dynamic import generate_dynamic
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState, NavSatFix
from synthetic_drive import PATIENCE, Robot, yaw_of

STEP = 0.05  # [s]
RADIUS, TRACK, WHEELBASE = 0.1, 0.5, 1.2
WHEELS = ['front_left', 'front_right', 'rear_left', 'rear_right']
DEFINITION = '''Header header
AckermannDrive drive
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
================================================================================
MSG: ackermann_msgs/AckermannDrive
float32 steering_angle
float32 steering_angle_velocity
float32 speed
float32 acceleration
float32 jerk
'''
AckermannDriveStamped = generate_dynamic('ackermann_msgs/AckermannDriveStamped', DEFINITION)[
    'ackermann_msgs/AckermannDriveStamped']


def wait_for(done, what, timeout=10.0):
    deadline = time.monotonic() + timeout * PATIENCE
    while not done():
        if time.monotonic() > deadline:
            raise AssertionError('waited in vain for ' + what)
        time.sleep(0.005)


def stamp_of(robot):
    return rospy.Time.from_sec(round(robot.stamp, 6))


class Wheels:
    """Joints of a robot on four wheels, whose names come in another order each time, and none of an arm's."""

    def __init__(self, robot):
        self.robot, self.left, self.right = robot, 0.0, 0.0

    def step(self):
        self.robot.step(STEP)
        half = 0.5 * TRACK * self.robot.yaw_rate
        self.left += (self.robot.speed - half) * STEP / RADIUS
        self.right += (self.robot.speed + half) * STEP / RADIUS

    def state(self):
        message = JointState()
        message.header.stamp = stamp_of(self.robot)
        names = WHEELS[:]
        self.robot.random.shuffle(names)
        message.name = ['gripper'] + names
        message.position = [0.0] + [self.left if name.endswith('left') else self.right for name in names]
        return message


class WheelOdometryNode(unittest.TestCase):
    def setUp(self):
        self.odometry, self.poses, self.diagnostics = [], [], []
        self.links = [rospy.Subscriber('joints/odom', Odometry, self.odometry.append),
                      rospy.Subscriber('car/odom', Odometry, self.odometry.append),
                      rospy.Subscriber('joints/odometry/filtered_map', Odometry, self.poses.append),
                      rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)]
        self.joints = rospy.Publisher('joints/joint_states', JointState, queue_size=1000)
        self.drives = rospy.Publisher('car/ackermann', AckermannDriveStamped, queue_size=1000)
        self.gps = rospy.Publisher('joints/gps/fix', NavSatFix, queue_size=1000)
        self.links += [self.joints, self.drives, self.gps]
        wait_for(lambda: all(link.get_num_connections() for link in self.links), 'the nodes')

    def tearDown(self):
        for link in self.links:
            link.unregister()

    def on_diagnostics(self, message):
        self.diagnostics += [entry for entry in message.status if entry.name.endswith(': wheels')]

    def assert_driven(self, robot, start):
        """That the last odometry tells where the robot is, seen from the first, which stood at (x, y, yaw)."""
        first, last = self.odometry[0].pose.pose, self.odometry[-1].pose.pose
        turn = start[2] - yaw_of(first.orientation)
        dx, dy = last.position.x - first.position.x, last.position.y - first.position.y
        self.assertAlmostEqual(start[0] + math.cos(turn) * dx - math.sin(turn) * dy, robot.x, delta=0.01)
        self.assertAlmostEqual(start[1] + math.sin(turn) * dx + math.cos(turn) * dy, robot.y, delta=0.01)
        self.assertAlmostEqual(math.remainder(yaw_of(last.orientation) + turn - robot.yaw, 2 * math.pi), 0, delta=0.001)

    def sent(self, publisher, message):
        """Publishes what is to become odometry, and waits for that."""
        number = len(self.odometry)
        publisher.publish(message)
        wait_for(lambda: len(self.odometry) > number, 'odometry')
        self.assertEqual(self.odometry[-1].header.stamp, message.header.stamp)

    def told(self, publisher, messages, holds):
        """Publishes until diagnostics are as they ought to be."""
        self.diagnostics.clear()

        def done():
            publisher.publish(next(messages))
            return any(map(holds, self.diagnostics))
        wait_for(done, 'word of the wheels')

    def test_joints_drive_a_circle_and_are_located(self):
        robot = Robot(seed=4, start=1.0e9)
        wheels = Wheels(robot)
        self.joints.publish(wheels.state())
        wheels.step()
        self.sent(self.joints, wheels.state())
        start = (robot.x, robot.y, robot.yaw)
        for i in range(int(round(2.0 * math.pi / robot.yaw_rate / STEP))):
            wheels.step()
            if i % 7 == 1:  # lost
                continue
            self.sent(self.joints, wheels.state())
            if i % 4 == 0:
                self.gps.publish(robot.fix())
        self.assert_driven(robot, start)
        last = self.odometry[-1]
        self.assertAlmostEqual(last.twist.twist.linear.x, robot.speed, places=3)
        self.assertAlmostEqual(last.twist.twist.angular.z, robot.yaw_rate, places=3)
        self.assertEqual((last.header.frame_id, last.child_frame_id), ('odom', 'base_link'))
        wait_for(lambda: self.poses and self.poses[-1].header.stamp == last.header.stamp, 'the pose')
        self.assertLess(robot.error_of(self.poses[-1].pose.pose), 1.5)

    def test_speed_and_steering_drive_a_circle(self):
        robot = Robot(seed=5, start=2.0e9, speed=-1.5, yaw_rate=-0.3)
        def reading():
            message = AckermannDriveStamped()
            message.header.stamp = stamp_of(robot)
            message.drive.speed = robot.speed
            message.drive.steering_angle = math.atan(WHEELBASE * robot.yaw_rate / robot.speed)
            return message
        self.drives.publish(reading())
        robot.step(STEP)
        self.sent(self.drives, reading())
        start = (robot.x, robot.y, robot.yaw)
        for _ in range(300):
            robot.step(STEP)
            self.sent(self.drives, reading())
        self.assert_driven(robot, start)

        def in_degrees():
            while True:
                robot.step(STEP)
                message = reading()
                message.drive.steering_angle = math.degrees(message.drive.steering_angle)
                yield message
        self.told(self.drives, in_degrees(), lambda entry: entry.level == DiagnosticStatus.WARN
                  and 'too fast' in entry.message and 'degrees' in entry.message)

    def test_joints_that_are_missing_are_named(self):
        robot = Robot(seed=6, start=3.0e9)
        wheels = Wheels(robot)

        def without_one():
            while True:
                wheels.step()
                message = wheels.state()
                message.name[message.name.index('rear_left')] = 'left_rear'
                yield message
        self.told(self.joints, without_one(), lambda entry: entry.level == DiagnosticStatus.WARN
                  and 'not finite' in entry.message and 'nothing of rear_left' in entry.message)


if __name__ == '__main__':
    rospy.init_node('wheel_odometry_node_test')
    rostest.rosrun('multipath_localization', 'wheel_odometry_node', WheelOdometryNode)
