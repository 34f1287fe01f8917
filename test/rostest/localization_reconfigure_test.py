#!/usr/bin/python3
"""What clients of dynamic_reconfigure set counts at once, stays within bounds and moves no pose."""
import unittest

import rospy
import rostest
from dynamic_reconfigure.client import Client
from synthetic_drive import Robot, Session

FILTER = 'multipath_particle_filter/'


class LocalizationReconfigure(unittest.TestCase):
    def test_reconfigure(self):
        session, robot = Session(), Robot(seed=1)
        client = Client('localization', timeout=10.0)
        told = {entry['name']: entry for entry in client.get_parameter_descriptions()}
        self.assertEqual((told['localizer/lost_sigma']['min'], told['localizer/lost_sigma']['max']), (0.1, 10000.0))
        self.assertIn('max_correction_rate', told)
        session.begin(robot)
        session.drive(robot, 20.0)
        self.assertEqual(session.states[-1].name, 'GOOD')
        session.states.clear()

        for change in ({FILTER + 'particles': 100}, {FILTER + 'odometry/distance': 0.01}, {FILTER + 'particles': 900},
                       {'max_correction_rate': 0.5}, {'localizer/fix_covariance/source': 'adaptive'}):
            self.assertGreaterEqual(client.update_configuration(change).items(), change.items())
            pose = session.drive(robot, 2.0)[-1]
            self.assertLess(robot.error_of(pose.pose.pose), 0.8, 'metres')
        self.assertEqual({state.name for state in session.states}, {'GOOD'}, 'nothing starts afresh')
        self.assertEqual(rospy.get_param('localization/localizer/fix_covariance/source'), 'adaptive')

        self.assertEqual(client.update_configuration({'localizer/lost_sigma': 1e9})['localizer/lost_sigma'], 10000.0)
        client.update_configuration({'localizer/lost_sigma': 0.1})
        session.drive(robot, 1.0)
        session.wait(lambda: session.states[-1].name == 'LOST', 'the state by the new bound')


if __name__ == '__main__':
    rospy.init_node('localization_reconfigure_test')
    rostest.rosrun('multipath_localization', 'localization_reconfigure', LocalizationReconfigure)
