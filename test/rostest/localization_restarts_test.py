#!/usr/bin/python3
"""The node starts afresh when time goes back, when asked to and where it is told to."""
import math
import subprocess
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseWithCovarianceStamped
from roslib.packages import find_node
from rosgraph_msgs.msg import Clock
from std_srvs.srv import Empty, SetBool
from synthetic_drive import Robot, Session, yaw_of


class LocalizationRestarts(unittest.TestCase):
    def setUp(self):
        rospy.wait_for_service('localization/reset', 10.0)
        self.clock = rospy.Publisher('/clock', Clock, queue_size=100, tcp_nodelay=True)
        self.reset = rospy.ServiceProxy('localization/reset', Empty)
        self.toggle = rospy.ServiceProxy('localization/toggle', SetBool)
        self.session = Session()
        self.reset()

    def assert_near(self, robot, pose, bound=0.8):
        self.assertLess(robot.error_of(pose.pose.pose), bound, 'metres')
        self.assertLess(abs(math.remainder(yaw_of(pose.pose.pose.orientation) - robot.yaw, 2.0 * math.pi)), 0.15)

    def test_the_same_stamps_twice(self):
        for seed, yaw in ((1, 1.0), (2, -2.0)):
            robot = Robot(seed=seed, yaw=yaw)
            self.session.poses.clear()
            self.session.send_odometry(robot.odometry(), answered=False)
            robot.step()
            self.session.begin(robot)
            self.assert_near(robot, self.session.drive(robot, 25.0)[-1])

    def test_the_clock_goes_back(self):
        for seed, yaw in ((3, 0.0), (4, 2.0)):
            robot = Robot(seed=seed, yaw=yaw)
            self.tick(robot)
            self.session.poses.clear()
            self.session.begin(robot)
            for _ in range(25):
                self.tick(robot)
                pose = self.session.drive(robot, 1.0)[-1]
            self.assert_near(robot, pose)

    def tick(self, robot):
        self.clock.publish(Clock(rospy.Time.from_sec(robot.stamp)))
        self.settle(0.02)

    @staticmethod
    def settle(seconds=0.2):
        time.sleep(seconds)  # rospy.sleep goes by the clock of this test

    def test_reset_forgets_the_pose(self):
        robot = Robot(seed=5)
        self.session.begin(robot)
        self.session.drive(robot, 20.0)
        self.reset()
        self.session.wait(lambda: self.session.states[-1].name == 'NOT_READY', 'the state after the reset')
        robot.step()
        self.session.send_odometry(robot.odometry(), answered=False)
        self.assertNotIn(robot.odometry().header.stamp.to_nsec(), self.session.poses)
        self.session.begin(robot)
        self.assert_near(robot, self.session.drive(robot, 25.0)[-1])

    def test_a_pose_can_be_set(self):
        for topic in ('initialpose', 'set_pose'):
            robot = Robot(seed=6)
            self.reset()
            self.session.poses.clear()
            publisher = rospy.Publisher(topic, PoseWithCovarianceStamped, queue_size=1)
            self.session.wait(publisher.get_num_connections, topic)
            self.session.send_odometry(robot.odometry(), answered=False)
            message = PoseWithCovarianceStamped()
            message.header.frame_id = 'map'
            message.pose.pose.position.x, message.pose.pose.position.y = 30.0, -20.0
            message.pose.pose.orientation.z, message.pose.pose.orientation.w = math.sin(-0.5), math.cos(-0.5)
            message.pose.covariance[0] = message.pose.covariance[7] = 0.04
            message.pose.covariance[35] = 0.01
            publisher.publish(message)
            self.settle()
            robot.x, robot.y, robot.yaw = 30.0, -20.0, -1.0
            robot.start = (30.0, -20.0, -1.0)
            self.assert_near(robot, self.session.drive(robot, 2.0, fix_every=0)[-1])

    def test_toggle(self):
        robot = Robot(seed=7)
        self.session.begin(robot)
        self.session.drive(robot, 1.0)
        self.assertTrue(self.toggle(False).success)
        known = len(self.session.poses)
        self.session.drive(robot, 1.0, fix_every=0, answered=False)
        self.settle()
        self.assertEqual(len(self.session.poses), known)
        self.assertTrue(self.toggle(True).success)
        robot.step()
        self.session.begin(robot)
        self.assert_near(robot, self.session.drive(robot, 25.0)[-1])

    def test_an_unknown_parameter_is_fatal(self):
        node = find_node('multipath_localization', 'localization_node')[0]
        run = subprocess.run([node, '__name:=typo', '_datun:=1'], capture_output=True, text=True, timeout=20)
        self.assertEqual(run.returncode, 1)
        self.assertIn('datun', run.stderr + run.stdout)


if __name__ == '__main__':
    rospy.init_node('localization_restarts_test', disable_rostime=True)
    rostest.rosrun('multipath_localization', 'localization_restarts', LocalizationRestarts)
