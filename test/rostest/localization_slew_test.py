#!/usr/bin/python3
"""map -> odom follows slowly where asked to; the poses on topics do not, and what is set is shown at once."""
import math
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseWithCovarianceStamped
from synthetic_drive import Robot, Session, yaw_of
from tf2_msgs.msg import TFMessage

RATE, TURN_RATE, STEP = 0.2, 0.02, 0.05  # as the node is told; of odometry [s]


def composed(parent, child):
    x, y, yaw = parent
    return (x + math.cos(yaw) * child[0] - math.sin(yaw) * child[1],
            y + math.sin(yaw) * child[0] + math.cos(yaw) * child[1], yaw + child[2])


def inverse(pose):
    x, y, yaw = pose
    return -math.cos(yaw) * x - math.sin(yaw) * y, math.sin(yaw) * x - math.cos(yaw) * y, -yaw


def planar(pose):
    return pose.position.x, pose.position.y, yaw_of(pose.orientation)


def apart(a, b):
    """Way [m] and turn [rad] from one pose to another."""
    return math.dist(a[:2], b[:2]), abs(math.remainder(b[2] - a[2], 2.0 * math.pi))


def rates(corrections, odometry):
    """How fast corrections by stamp move [m/s] and turn [rad/s] the robot at most."""
    stamps = sorted(corrections)
    steps = [(apart(composed(corrections[i], odometry[j]), composed(corrections[j], odometry[j])), (j - i) * 1e-9)
             for i, j in zip(stamps, stamps[1:])]
    return max(step[0] / duration for step, duration in steps), max(step[1] / duration for step, duration in steps)


class LocalizationSlew(unittest.TestCase):
    def setUp(self):
        self.corrections = {}
        self.tf = rospy.Subscriber('/tf', TFMessage, self.on_tf, tcp_nodelay=True)
        self.session = Session()

    def on_tf(self, message):
        for transform in message.transforms:
            stamp = transform.header.stamp - rospy.Duration(0.1)
            translation = transform.transform.translation
            self.corrections[stamp.to_nsec()] = (translation.x, translation.y, yaw_of(transform.transform.rotation))

    def drive(self, robot, seconds):
        """Corrections by tf and by the topic, and odometry, by stamps; repetitions may overtake some of tf."""
        by_topic, odometry = {}, {}
        for _ in range(int(round(seconds / STEP))):
            pose = self.session.drive(robot, STEP, fix_every=1)[-1]
            stamp = pose.header.stamp.to_nsec()
            odometry[stamp] = planar(robot.odometry().pose.pose)
            by_topic[stamp] = composed(planar(pose.pose.pose), inverse(odometry[stamp]))
        time.sleep(0.2)
        return {stamp: self.corrections[stamp] for stamp in odometry if stamp in self.corrections}, by_topic, odometry

    def test_slew(self):
        robot = Robot(seed=1, yaw_rate=0.0)
        self.session.begin(robot)
        self.session.drive(robot, 20.0)
        self.assertEqual(self.session.states[-1].name, 'GOOD')
        by_tf, by_topic, odometry = self.drive(robot, 10.0)
        self.assertGreater(len(by_tf), 100)
        moved, turned = rates(by_tf, odometry)
        self.assertLess(moved, 1.01 * RATE, 'm/s')
        self.assertLess(turned, 1.01 * TURN_RATE, 'rad/s')
        self.assertGreater(rates(by_topic, odometry)[0], 1.5 * RATE, 'm/s: poses are not held back')
        self.assert_set_pose_is_shown_at_once(robot)

    def assert_set_pose_is_shown_at_once(self, robot):
        publisher = rospy.Publisher('set_pose', PoseWithCovarianceStamped, queue_size=1)
        self.session.wait(publisher.get_num_connections, 'the subscriber of set_pose')
        message = PoseWithCovarianceStamped()
        message.pose.pose.position.x, message.pose.pose.orientation.w = robot.x + 500.0, 1.0
        message.pose.covariance[0] = message.pose.covariance[7] = 0.04
        message.pose.covariance[35] = 0.01
        publisher.publish(message)
        time.sleep(0.3)
        by_tf, _, odometry = self.drive(robot, 2.0)
        first = min(by_tf)
        self.assertGreater(composed(by_tf[first], odometry[first])[0], robot.x + 400.0, 'metres')


if __name__ == '__main__':
    rospy.init_node('localization_slew_test')
    rostest.rosrun('multipath_localization', 'localization_slew', LocalizationSlew)
