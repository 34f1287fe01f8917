#!/usr/bin/python3
"""The tf tree as REP-105 has it: map -> odom alone, dated ahead, often enough, and the antenna where tf says."""
import math
import time
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Clock
from synthetic_drive import Robot, Session, antenna_transform, yaw_of
from tf2_msgs.msg import TFMessage


class LocalizationTf(unittest.TestCase):
    def setUp(self):
        self.transforms, self.strangers = [], set()
        self.clock = rospy.Publisher('/clock', Clock, queue_size=100, tcp_nodelay=True)
        self.tf = rospy.Subscriber('/tf', TFMessage, self.on_tf, tcp_nodelay=True)
        self.tf_status = ''
        self.diagnostics = rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        self.static_tf = tf2_ros.StaticTransformBroadcaster()
        self.static_tf.sendTransform(antenna_transform('gps', 1.0, 0.4, yaw=0.3))
        self.session = Session()

    def on_tf(self, message):
        for transform in message.transforms:
            if (transform.header.frame_id, transform.child_frame_id) == ('map', 'odom'):
                self.transforms.append(transform)
            else:
                self.strangers.add((transform.header.frame_id, transform.child_frame_id))

    def on_diagnostics(self, message):
        for entry in message.status:
            if entry.name.endswith(': tf'):
                self.tf_status = entry.message

    def tick(self, stamp):
        self.clock.publish(Clock(rospy.Time.from_sec(stamp)))

    def test_tree(self):
        robot = Robot(seed=1, antenna=(1.0, 0.4))
        self.tick(robot.stamp)
        while True:  # the static transform may be under way
            self.session.send_odometry(robot.odometry(), answered=False)
            if self.session.send_fix(robot.fix()).reason == 'accepted':
                break
            robot.step()
        poses = {}
        for i in range(200):  # odometry of 5 Hz for 40 s
            for _ in range(10):
                robot.step(0.02)
                self.tick(robot.stamp)
                time.sleep(0.004)
            pose = self.session.send_odometry(robot.odometry())
            poses[pose.header.stamp.to_nsec()] = (pose, robot.odometry())
            if i == 100:
                self.static_tf.pub_tf.unregister()  # whoever placed the antenna has died
            self.assertEqual(self.session.send_fix(robot.fix()).reason, 'accepted')
        self.check_stamps()
        self.check_composition(poses)
        self.assertEqual(self.strangers, set(), 'map -> odom alone')
        self.assertLess(robot.error_of(pose.pose.pose), 0.6, 'metres; the antenna is 1.08 m off')
        self.check_frames_that_do_not_ride(robot)
        self.check_leap(robot)

    def check_frames_that_do_not_ride(self, robot):
        static_tf, moving_tf = tf2_ros.StaticTransformBroadcaster(), tf2_ros.TransformBroadcaster()
        self.session.wait(lambda: moving_tf.pub_tf.get_num_connections() >= 2, 'the subscriber of tf')  # and this test
        footprint, low, beacon, carried = (antenna_transform(child, x, y) for child, x, y in (
            ('base_link', 0.0, 0.0), ('low', 1.0, 0.4), ('beacon', 1.0, 0.4), ('base_footprint', 5.0, 0.0)))
        footprint.header.frame_id = low.header.frame_id = 'base_footprint'
        beacon.header.frame_id = carried.header.frame_id = 'robot_odom'
        moving_tf.sendTransform(carried)
        static_tf.sendTransform([footprint, low, beacon])
        while self.reason_of(robot, 'low') != 'accepted':  # the transforms may be under way
            moving_tf.sendTransform(carried)
        self.assertEqual(self.reason_of(robot, 'beacon'), 'invalid frame')
        self.assertEqual(self.reason_of(robot, 'robot_odom'), 'invalid frame', 'by another name than the parameter says')
        self.assertEqual(self.reason_of(robot, '/odom'), 'invalid frame')
        self.assertEqual(self.reason_of(robot, 'base_footprint'), 'accepted')
        self.session.wait(lambda: 'beacon (which does not ride on the robot)' in self.tf_status, 'diagnostics')

    def reason_of(self, robot, frame):
        """What becomes of a fix of an antenna of that frame."""
        robot.step()
        self.session.send_odometry(robot.odometry())
        fix = robot.fix()
        fix.header.frame_id = frame
        return self.session.send_fix(fix).reason

    def check_leap(self, robot):
        for _ in range(5):
            self.tick(robot.stamp + 3.0e9)  # further than the longest ros::Duration
            time.sleep(0.1)
        robot.step()
        self.session.send_odometry(robot.odometry())

    def check_stamps(self):
        stamps = [transform.header.stamp.to_sec() for transform in self.transforms]
        self.assertTrue(all(later > earlier for earlier, later in zip(stamps, stamps[1:])), 'stamps grow')
        self.assertGreater(len(stamps) / (stamps[-1] - stamps[0]), 20.0, 'Hz, with odometry of 5 Hz')

    def check_composition(self, poses):
        matched = 0
        for transform in self.transforms:
            dated = transform.header.stamp - rospy.Duration(0.1)
            if dated.to_nsec() not in poses:
                continue
            pose, odometry = poses[dated.to_nsec()]
            yaw = yaw_of(transform.transform.rotation)
            x, y = odometry.pose.pose.position.x, odometry.pose.pose.position.y
            self.assertAlmostEqual(transform.transform.translation.x + math.cos(yaw) * x - math.sin(yaw) * y,
                                   pose.pose.pose.position.x, 6)
            self.assertAlmostEqual(transform.transform.translation.y + math.sin(yaw) * x + math.cos(yaw) * y,
                                   pose.pose.pose.position.y, 6)
            matched += 1
        self.assertGreater(matched, 150, 'of 200: the rest was overtaken by a repetition')


if __name__ == '__main__':
    rospy.init_node('localization_tf_test')
    rostest.rosrun('multipath_localization', 'localization_tf', LocalizationTf)
