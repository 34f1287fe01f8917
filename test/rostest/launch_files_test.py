#!/usr/bin/python3
"""Launch files set what they are asked to and leave everything else to the parameter files."""
import os
import tempfile
import unittest

import roslaunch.config
import rospkg
import rostest

LAUNCH = os.path.join(rospkg.RosPack().get_path('multipath_localization'), 'launch')


def launched(name, *arguments):
    """The parameters that a launch file sets, by name."""
    config = roslaunch.config.load_config_default([(os.path.join(LAUNCH, name), list(arguments))], None)
    return {key: parameter.value for key, parameter in config.params.items()}


class LaunchFiles(unittest.TestCase):
    def setUp(self):
        with tempfile.NamedTemporaryFile('w', suffix='.yaml', delete=False) as file:
            file.write('{publish_odom_tf: true, publish_tf: false, odom_frame: wheels}')
        self.addCleanup(os.remove, file.name)
        self.params = 'params:=' + file.name

    def test_the_parameter_file_counts(self):
        for name in ('localization.launch', 'robot.launch', 'bag.launch'):
            bag = ['bag:=none.bag'] if name == 'bag.launch' else []
            set_there = launched(name, self.params, *bag)
            self.assertIs(set_there['/localization/publish_odom_tf'], True, name)
            self.assertIs(set_there['/localization/publish_tf'], False, name)
            self.assertEqual(set_there['/localization/odom_frame'], 'wheels', name)

    def test_an_argument_counts_more(self):
        for name in ('localization.launch', 'robot.launch'):
            set_there = launched(name, self.params, 'publish_odom_tf:=false')
            self.assertIs(set_there['/localization/publish_odom_tf'], False, name)
        set_there = launched('localization.launch', self.params, 'odom_frame:=odom_2')
        self.assertEqual(set_there['/localization/odom_frame'], 'odom_2')

    def test_raw_measurements_are_one_argument_away(self):
        plain = launched('robot.launch')
        self.assertNotIn('/gnss_receiver/source', plain)
        self.assertNotIn('/localization/estimator', plain)
        raw = launched('robot.launch', 'raw:=true', 'source:=tcp://host:5000')
        self.assertEqual(raw['/gnss_receiver/source'], 'tcp://host:5000')
        self.assertEqual(raw['/gnss_receiver/stamps'], 'receiver')
        self.assertEqual(raw['/localization/estimator'], 'pseudorange_mixture_filter')

    def test_the_odometry_of_wheels_is_one_argument_away(self):
        plain = launched('robot.launch')
        self.assertNotIn('/wheel_odometry/track', plain)
        with tempfile.NamedTemporaryFile('w', suffix='.yaml', delete=False) as file:
            file.write('{track: 0.5}')
        self.addCleanup(os.remove, file.name)
        wheels = launched('robot.launch', 'wheels:=' + file.name)
        self.assertEqual(wheels['/wheel_odometry/track'], 0.5)
        self.assertIs(wheels['/localization/publish_odom_tf'], True)

    def test_the_odometry_of_a_bag(self):
        set_there = launched('bag.launch', 'bag:=none.bag', 'odom_frame:=wheels')
        self.assertEqual(set_there['/localization/odom_frame'], 'wheels')
        self.assertEqual(set_there['/tf_filter/drop_child_frame'], 'wheels')
        self.assertIs(set_there['/localization/publish_odom_tf'], True)
        self.assertNotIn('/tf_filter/drop_child_frame', launched('bag.launch', 'bag:=none.bag'))

    def test_steering_drives_nowhere_unasked(self):
        unasked = launched('steering.launch')
        self.assertNotIn('/steering/waypoints', unasked)
        self.assertEqual(unasked['/steering/waypoint_file'], '')
        self.assertIs(unasked['/steering/autostart'], True)
        taught = launched('steering.launch', 'waypoint_file:=/tmp/route.csv', 'autostart:=false')
        self.assertEqual(taught['/steering/waypoint_file'], '/tmp/route.csv')
        self.assertIs(taught['/steering/autostart'], False)
        self.assertNotIn('/steering/waypoints', taught)

    def test_a_scenario_is_steered_where_it_is_named(self):
        self.assertEqual(launched('steering.launch', 'scenario:=loop')['/steering/law'], 'nishida')
        self.assertIn('/steering/waypoints', launched('steering.launch', 'file:=' + os.path.join(
            LAUNCH, '../config/scenarios/loop.yaml')))
        for name in ('demo.launch', 'compare.launch'):
            self.assertIn('/steering/waypoints', launched(name, 'gui:=false'), name)


if __name__ == '__main__':
    rostest.rosrun('multipath_localization', 'launch_files', LaunchFiles)
