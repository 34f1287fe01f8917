#!/usr/bin/python3
"""steering_node leaves the robot standing when it ends, and to others when it has been told to stand."""
import signal
import time
import xmlrpc.client

import rosgraph
import rospy
import rostest

from steering_case import SteeringCase


def kill_by_name():
    uri = rosgraph.Master("steering_end_test").lookupNode("/steering")
    xmlrpc.client.ServerProxy(uri).shutdown("steering_end_test", "as rosnode kill does")


class SteeringEndTest(SteeringCase):
    def drive_until_the_node_has_ended(self):
        """Poses go on, so that no watchdog stops the robot."""
        end = time.time() + 10.0
        while self.node.poll() is None and time.time() < end:
            self.send_pose(0.0, 0.0, 0.0)
            time.sleep(0.02)
        self.assertEqual(self.node.poll(), 0)
        time.sleep(0.3)

    def test_commands_zero_at_its_end(self):
        rospy.set_param("/steering/waypoints", [[1000, 0], [1000, 10]])
        ends = {"SIGINT": lambda: self.node.send_signal(signal.SIGINT),
                "SIGTERM": lambda: self.node.send_signal(signal.SIGTERM),
                "rosnode kill": kill_by_name}
        for name, end in ends.items():
            with self.subTest(name):
                self.begin()
                self.assertGreater(self.expect("driving").speed, 0.0)
                end()
                self.drive_until_the_node_has_ended()
                self.assertEqual(self.steering.message.speed, 0.0)
                self.assertEqual(self.cmd_vel.message.linear.x, 0.0)
        rospy.delete_param("/steering/waypoints")

    def commands_within(self, seconds):
        """How many commands come while poses do; all are to stand."""
        before = self.steering.count
        end = time.time() + seconds
        while time.time() < end:
            self.send_pose(0.0, 0.0, 0.0)
            time.sleep(0.02)
            self.assertEqual(self.steering.message.speed, 0.0)
        return self.steering.count - before

    def test_leaves_the_robot_to_others_when_it_is_to_stand(self):
        self.begin("_autostart:=false")
        self.addCleanup(rospy.delete_param, "/steering/autostart")
        self.assertEqual(self.expect("stopped: waiting for start").speed, 0.0)
        time.sleep(1.0)
        self.assertEqual(self.commands_within(0.5), 0)
        self.assertFalse(self.order("record")[0])
        self.assertEqual(self.commands_within(0.5), 0)
        time.sleep(0.7)  # nor does it speak when poses have ceased
        self.assertEqual(self.commands_within(0.3), 0)
        self.assertTrue(self.order("stop")[0])
        self.assertGreater(self.commands_within(0.7), 10)
        time.sleep(0.5)
        self.assertEqual(self.commands_within(0.5), 0)


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "steering_end", SteeringEndTest)
