#!/usr/bin/python3
"""fault_injector_node beside a robot: fixes and odometry in, spoilt ones out, and what is wrong with them told."""
import time
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry
from sensor_msgs.msg import NavSatFix
from std_msgs.msg import String
from synthetic_drive import Robot


class FaultInjectorTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("fault_injector_node_test")
        cls.fixes, cls.odometry, cls.faults = [], [], []
        cls.subscribers = [
            rospy.Subscriber("gps/fix_spoiled", NavSatFix, cls.fixes.append),
            rospy.Subscriber("odom_spoiled", Odometry, cls.odometry.append),
            rospy.Subscriber("fault_injector/faults", String, cls.faults.append)]
        cls.gps = rospy.Publisher("gps/fix", NavSatFix, queue_size=1000)
        cls.odom = rospy.Publisher("odom", Odometry, queue_size=1000)
        links = [cls.gps, cls.odom] + cls.subscribers
        cls.wait(lambda: all(link.get_num_connections() for link in links), "the node")

    @staticmethod
    def wait(done, what, timeout=10.0):
        end = time.monotonic() + timeout
        while not done() and time.monotonic() < end:
            time.sleep(0.02)
        assert done(), "waited in vain for " + what

    def test_spoils_by_the_stamps(self):
        robot = Robot(start=1.0e9, yaw=0.0, yaw_rate=0.0, noise=0.0)
        sent = {}
        for i in range(200):
            robot.step()
            self.odom.publish(robot.odometry())
            if i % 4 == 0:
                fix = robot.fix()
                sent[fix.header.stamp.to_nsec()] = fix
                self.gps.publish(fix)
            self.wait(lambda: len(self.odometry) > i, "odometry %d" % i)
        first = self.odometry[0].header.stamp

        def age(message):
            return (message.header.stamp - first).to_sec()

        self.wait(lambda: any(age(fix) > 9.5 for fix in self.fixes), "the last fixes")

        self.assertFalse([age(fix) for fix in self.fixes if 2.0 < age(fix) < 4.0], "the outage")
        self.assertEqual(len(self.fixes), len(sent) - 10)
        for fix in self.fixes:
            moved = fix.longitude != sent[fix.header.stamp.to_nsec()].longitude
            self.assertEqual(moved, 6.0 <= age(fix) < 8.0, age(fix))
        for odometry in self.odometry:
            standing = odometry.twist.twist.linear.x == 0.0
            self.assertEqual(standing, 6.0 <= age(odometry) < 8.0, age(odometry))
        self.wait(lambda: self.faults[-1].data == "none", "the faults to end")
        told = [message.data for message in self.faults]
        self.assertEqual(told, ["none", "fix: outage", "none",
                                "fix: bias of 8 m east, 0 m north\nodometry: both encoders dead", "none"])


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "fault_injector_node", FaultInjectorTest)
