#!/usr/bin/python3
"""Nodes die in mid-run: the robot stops, launch starts them again, and it drives on from where it was."""
import math
import os
import signal
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

from multipath_localization.msg import LocalizationState

STOPS_WITHIN = 5.0  # [s] of the wall clock
RESUMES_WITHIN = 10.0
DRIVES = 0.3  # [m/s]
FAR = 20.0  # [m] from where the odometry began, so that it shows that it has gone on


def process_of(node):
    uri = rosgraph.Master('death_test').lookupNode(node)
    return xmlrpc.client.ServerProxy(uri).getPid('death_test')[2]


class Death(unittest.TestCase):
    def setUp(self):
        self.speed, self.command, self.truth, self.error, self.state = 0.0, math.nan, {}, math.nan, ''
        self.rolled, self.states = 0.0, []
        self.subscribers = [
            rospy.Subscriber('odom', Odometry, self.on_odometry),
            rospy.Subscriber('truth', Odometry, self.on_truth),
            rospy.Subscriber('odometry/filtered_map', Odometry, self.on_pose),
            rospy.Subscriber('cmd_vel', Twist, lambda m: setattr(self, 'command', m.linear.x)),
            rospy.Subscriber('localization/state', LocalizationState, self.on_state)]
        self.wait(lambda: self.drives() and self.rolled > FAR and self.error < 2.0, 60.0, 'the robot to drive')

    def on_truth(self, message):
        self.speed = abs(message.twist.twist.linear.x)
        position = message.pose.pose.position
        self.truth[message.header.stamp.to_nsec()] = (position.x, position.y)

    def on_state(self, message):
        self.state = message.name
        self.states.append(message.name)

    def on_odometry(self, message):
        self.rolled = math.hypot(message.pose.pose.position.x, message.pose.pose.position.y)

    def on_pose(self, message):
        truth = self.truth.get(message.header.stamp.to_nsec())
        if truth:
            position = message.pose.pose.position
            self.error = math.hypot(position.x - truth[0], position.y - truth[1])

    def wait(self, condition, limit, what):
        begin = time.monotonic()
        while not condition():
            self.assertLess(time.monotonic() - begin, limit, 'waiting for %s: %.2f m/s, command %.2f, error %.2f m, %s' % (
                what, self.speed, self.command, self.error, self.state))
            time.sleep(0.02)

    def stands(self):
        return self.speed < 0.01

    def drives(self):
        return self.speed > DRIVES and self.state in ('GOOD', 'MULTIPATH')

    def saved_as_confirmed(self):
        with open(rospy.get_param('localization/pose_file'), encoding='utf-8') as file:
            return 'confirmed: true' in file.read()

    def test_localization_is_killed(self):
        self.wait(self.saved_as_confirmed, STOPS_WITHIN, 'the pose on the disk')
        os.kill(process_of('/localization'), signal.SIGKILL)
        self.state, self.states, self.error = '', [], math.nan
        self.wait(self.stands, STOPS_WITHIN, 'the robot to stop')
        self.wait(lambda: self.error < 2.0, RESUMES_WITHIN, 'a pose where the robot is')
        self.wait(self.drives, RESUMES_WITHIN, 'the robot to drive on')
        self.assertLess(self.error, 2.0)
        self.assertNotIn('ALIGNING', self.states, 'confirmed as it was')

    def test_steering_is_killed(self):
        os.kill(process_of('/steering'), signal.SIGKILL)
        self.wait(self.stands, STOPS_WITHIN, 'the robot to stop')
        self.wait(self.drives, RESUMES_WITHIN, 'the robot to drive on')

    def test_the_clock_stops_and_goes_on(self):
        simulator = process_of('/simulator')
        os.kill(simulator, signal.SIGSTOP)
        try:
            self.wait(lambda: self.command == 0.0, STOPS_WITHIN, 'the command to stop')
        finally:
            os.kill(simulator, signal.SIGCONT)
        self.wait(self.drives, RESUMES_WITHIN, 'the robot to drive on')
        self.assertLess(self.error, 2.0)


if __name__ == '__main__':
    rospy.init_node('death_test')
    rostest.rosrun('multipath_localization', 'death', Death)
