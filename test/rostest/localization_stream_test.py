#!/usr/bin/python3
"""One finite pose for each odometry message, near the truth, whatever the order in which fixes arrive."""
import math
import unittest

import rospy
import rostest
from std_srvs.srv import Empty
from synthetic_drive import Robot, Session, numbers_of, yaw_of


class LocalizationStream(unittest.TestCase):
    def setUp(self):
        rospy.wait_for_service('localization/reset', 10.0)
        self.session = Session()

    def tearDown(self):
        rospy.ServiceProxy('localization/reset', Empty)()

    def check(self, poses):
        for pose in poses:
            self.assertEqual(pose.header.frame_id, 'map')
            self.assertEqual(pose.child_frame_id, 'base_link')
            self.assertAlmostEqual(pose.twist.twist.linear.x, 2.0, delta=1e-4, msg='stamps are of whole microseconds')
            self.assertTrue(all(math.isfinite(number) for number in numbers_of(pose)))
        self.assertTrue(all(len(answers) == 1 for answers in self.session.poses.values()), 'one pose per message')

    def test_one_pose_per_message_near_the_truth(self):
        robot = Robot(seed=1)
        self.session.begin(robot)
        poses = self.session.drive(robot, 40.0)
        self.assertEqual(len(poses), 800)
        self.check(poses)
        self.assertLess(robot.error_of(poses[-1].pose.pose), 0.6, 'metres, with fixes of 0.3 m')
        turn = yaw_of(poses[-1].pose.pose.orientation) - robot.yaw
        self.assertLess(abs(math.remainder(turn, 2.0 * math.pi)), 0.1)
        self.assertEqual({report.reason for report in self.session.reports}, {'accepted'})
        self.assertEqual(self.session.states[-1].name, 'GOOD')

    def test_late_fixes_count_at_their_own_stamps(self):
        robot = Robot(seed=2, start=2.0e9)
        self.session.begin(robot)
        poses, on_the_way = [], []
        for i in range(800):
            robot.step()
            poses.append(self.session.send_odometry(robot.odometry()))
            if i % 4 == 0:
                on_the_way.append(robot.fix())
            if len(on_the_way) > 4:
                report = self.session.send_fix(on_the_way.pop(0))
                self.assertEqual(report.reason, 'accepted')
                self.assertGreater(report.age, 0.7)
        self.check(poses)
        self.assertLess(robot.error_of(poses[-1].pose.pose), 0.6, 'metres; weighed on arrival it were 1.6')

    def test_fixes_ahead_of_odometry_wait_for_it(self):
        robot = Robot(seed=3, start=3.0e9)
        self.session.begin(robot)
        early = robot.fix()
        early.header.stamp = rospy.Time.from_sec(robot.stamp + 0.3)
        self.session.gps.publish(early)
        number = len(self.session.reports)
        self.session.drive(robot, 0.25, fix_every=0)
        self.assertEqual(len(self.session.reports), number)
        self.session.drive(robot, 0.1, fix_every=0)
        self.session.wait(lambda: len(self.session.reports) > number, 'the report on a fix that waited')
        self.assertEqual(self.session.reports[-1].header.stamp, early.header.stamp)

    def test_a_fix_before_any_odometry_is_not_lost(self):
        robot = Robot(seed=4, start=3.5e9)
        self.session.gps.publish(robot.fix())
        rospy.sleep(0.2)
        pose = self.session.send_odometry(robot.odometry())
        self.assertLess(robot.error_of(pose.pose.pose), 2.0)

    def test_odometry_that_overtook_the_first_fix_is_answered_too(self):
        robot = Robot(seed=5, start=3.8e9)
        fix, messages = robot.fix(), []
        for _ in range(4):
            messages.append(robot.odometry())
            self.session.send_odometry(messages[-1], answered=False)
            robot.step()
        self.session.send_fix(fix)
        for message in messages:
            stamp = message.header.stamp.to_nsec()
            self.session.wait(lambda: stamp in self.session.poses, 'the pose at %d' % stamp)
        self.check([])


if __name__ == '__main__':
    rospy.init_node('localization_stream_test')
    rostest.rosrun('multipath_localization', 'localization_stream', LocalizationStream)
