#!/usr/bin/env python3
"""localization_node goes on where it was after it has been killed, and not from a pose that does not count."""
import os
import signal
import subprocess
import tempfile
import unittest

import rospy
import yaml
from roslib.packages import find_node

from synthetic_drive import Robot, Session


class RespawnTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = os.path.join(folder.name, 'pose.yaml')
        node = find_node('multipath_localization', 'localization_node')[0]
        self.command = [node, '__name:=localization', '__ns:=mortal', '_pose_file:=' + self.file]

    def run_node(self, use, end=signal.SIGKILL):
        """Starts the node, lets `use` talk with it, and ends it, by default as a crash would."""
        process = subprocess.Popen(self.command)
        session = Session('mortal/')
        try:
            use(session)
        finally:
            process.send_signal(end)
            process.wait(10.0)
            session.close()

    def lived(self, robot):
        """A first life until the pose is confirmed and the last one is on the disk."""
        def use(session):
            session.begin(robot, fixes=3)
            session.drive(robot, 25.0)
            self.assertEqual(session.states[-1].name, 'GOOD')
            session.wait(lambda: self.saved_stamp() > robot.stamp - 1.5, 'the file')
        self.run_node(use)

    def saved_stamp(self):
        if not os.path.exists(self.file):
            return 0.0
        with open(self.file, encoding='utf-8') as file:
            return yaml.safe_load(file)['stamp']

    def test_goes_on_at_the_first_odometry(self):
        robot = Robot(seed=3, noise=0.1)
        self.lived(robot)
        robot.yaw_rate = 0.0  # rolls on while nobody looks
        for _ in range(20):
            robot.step()

        def use(session):
            pose = session.send_odometry(robot.odometry())
            self.assertLess(robot.error_of(pose.pose.pose), 0.8, 'metres, before any fix')
            pose = session.drive(robot, 5.0)[-1]
            self.assertLess(robot.error_of(pose.pose.pose), 0.8, 'metres')
            session.wait(lambda: session.states[-1].name == 'GOOD', 'the state')
        self.run_node(use)

    def test_a_pose_is_confirmed_anew_where_the_odometry_has_begun_anew(self):
        robot = Robot(seed=6, noise=0.1, speed=0.75, yaw_rate=0.05)
        self.lived(robot)
        robot.stamp += 3.0
        robot.start = (robot.x, robot.y, robot.yaw)

        def use(session):
            pose = session.send_odometry(robot.odometry())
            self.assertLess(robot.error_of(pose.pose.pose), 1.0, 'metres, before any fix')
            self.assertGreater(pose.pose.covariance[0], 2.2 ** 2, 'square metres, which it may have come')
            session.drive(robot, 1.0)
            session.wait(lambda: session.states[-1].name == 'ALIGNING', 'the state')
            self.assertNotIn('GOOD', [state.name for state in session.states])
            pose = session.drive(robot, 30.0)[-1]
            self.assertLess(robot.error_of(pose.pose.pose), 0.8, 'metres')
            session.wait(lambda: session.states[-1].name == 'GOOD', 'the state')
        self.run_node(use)

    def test_a_node_that_is_told_to_end_leaves_its_last_pose(self):
        robot = Robot(seed=7, noise=0.1)

        def use(session):
            session.begin(robot, fixes=3)
            session.drive(robot, 10.0)  # faster than the disk writes
        self.run_node(use, signal.SIGINT)
        self.assertGreater(self.saved_stamp(), robot.stamp - 1.5)

    def test_an_old_pose_does_not_count(self):
        robot = Robot(seed=4, noise=0.1)
        self.lived(robot)
        robot.stamp += 1000.0
        def use(session):
            session.send_odometry(robot.odometry(), answered=False)
            session.wait(lambda: session.states and session.states[-1].name == 'NOT_READY', 'the state')
            self.assertFalse(session.poses)
        self.run_node(use)

    def test_a_damaged_pose_does_not_count(self):
        robot = Robot(seed=5, noise=0.1)
        self.lived(robot)
        with open(self.file, 'r+', encoding='utf-8') as file:
            file.truncate(120)
        def use(session):
            session.begin(robot, fixes=3)
            session.drive(robot, 1.0)
            self.assertEqual(session.states[-1].name, 'ALIGNING')
        self.run_node(use)


if __name__ == '__main__':
    import rostest
    rospy.init_node('localization_respawn_test')
    rostest.rosrun('multipath_localization', 'localization_respawn', RespawnTest)
