#!/usr/bin/python3
"""Two receivers, each with an antenna of its own: one in a shadow is found out by the other, and one that falls silent missed."""
import copy
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from sensor_msgs.msg import NavSatFix
from std_srvs.srv import Empty
from synthetic_drive import Robot, Session, antenna_transform

ANTENNA = (0.2, -0.8)  # of the second receiver, on the base [m]


class LocalizationReceivers(unittest.TestCase):
    def setUp(self):
        self.diagnostics = {}
        self.listener = rospy.Subscriber('/diagnostics', DiagnosticArray, self.on_diagnostics)
        self.second = rospy.Publisher('gps_2/fix', NavSatFix, queue_size=1000)
        self.transforms = tf2_ros.StaticTransformBroadcaster()
        self.transforms.sendTransform([antenna_transform('gps', 0.0, 0.0), antenna_transform('gps_2', *ANTENNA)])
        rospy.wait_for_service('localization/reset', 10.0)
        rospy.ServiceProxy('localization/reset', Empty)()
        self.session = Session()
        self.session.wait(self.second.get_num_connections, 'the node')

    def tearDown(self):
        self.session.close()

    def on_diagnostics(self, message):
        for entry in message.status:
            self.diagnostics[entry.name.split(': ')[-1]] = entry

    def value(self, name, key):
        found = [pair.value for pair in self.diagnostics[name].values if pair.key == key]
        return float(found[0]) if found else None

    def send_second(self, robot, north):
        """A fix of the second receiver, off by that much."""
        other = copy.copy(robot)
        other.antenna, other.y = ANTENNA, robot.y + north
        fix = other.fix()
        fix.header.frame_id = 'gps_2'
        return self.session.reported(lambda: self.second.publish(fix), fix.header.stamp)

    def drive(self, robot, seconds, north=0.0, both=True):
        def send(robot):
            self.session.send_fix(robot.fix())
            if both:
                self.assertEqual(self.send_second(robot, north).kind, 'fix_2')
        return self.session.drive(robot, seconds, send=send)[-1]

    def drive_until(self, robot, name, holds, **inputs):
        """Drives on until the diagnostics of an input are as they ought to be."""
        def told():
            self.drive(robot, 0.4, **inputs)
            return name in self.diagnostics and holds(self.diagnostics[name])
        self.session.wait(told, 'word of ' + name, timeout=30.0)

    def test_one_in_a_shadow_that_it_does_not_declare_is_found_out(self):
        robot = Robot(seed=3)
        self.session.begin(robot)
        self.drive(robot, 30.0)
        pose = self.drive(robot, 20.0, north=8.0)
        self.assertLess(robot.error_of(pose.pose.pose), 1.0)
        self.assertEqual(self.session.states[-1].name, 'GOOD', self.session.states[-1].reason)
        self.drive_until(robot, 'fix_2', lambda entry: (self.value('fix_2', 'shadow probability') or 0.0) > 0.8, north=8.0)
        self.assertLess(self.value('fix', 'shadow probability'), 0.2)

    def test_one_that_falls_silent_is_a_warning_and_no_more(self):
        robot = Robot(seed=5)
        self.session.begin(robot)
        self.drive(robot, 20.0)
        self.drive_until(robot, 'fix_2', lambda entry: 'arrives and is used' in entry.message)
        self.drive_until(robot, 'fix_2', lambda entry: entry.level == DiagnosticStatus.WARN and 'silent' in entry.message,
                         both=False)
        pose = self.drive(robot, 5.0, both=False)
        self.assertLess(robot.error_of(pose.pose.pose), 1.0)


if __name__ == '__main__':
    rospy.init_node('localization_receivers_test')
    rostest.rosrun('multipath_localization', 'localization_receivers', LocalizationReceivers)
