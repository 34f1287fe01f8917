#!/usr/bin/python3
"""steering_node halts before what a scanner sees and at the stop input, says why, and goes on as its parameters tell."""
import math

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage

from steering_case import Last, SteeringCase, wait_for_subscribers

BEAMS = 360


def scanner_on_the_robot():
    """It looks backwards: what it sees ahead of it is behind the robot."""
    transform = TransformStamped()
    transform.header.frame_id, transform.child_frame_id = "base_link", "laser"
    transform.transform.rotation.z = 1.0
    return TFMessage([transform])


class SteeringSafetyTest(SteeringCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scan = rospy.Publisher("scan", LaserScan, queue_size=1)
        cls.stop = rospy.Publisher("emergency_stop", Bool, queue_size=1)
        cls.tf = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        cls.tf.publish(scanner_on_the_robot())
        cls.diagnostics = Last("/diagnostics", DiagnosticArray)
        rospy.set_param("/steering/waypoints", [[1000, 0], [1000, 10]])

    def begin(self, *arguments):
        self.addCleanup(lambda: rospy.delete_param("/steering/safety"))
        super().begin("_safety/clear_time:=0.2", *arguments)

    def begin_with_scans(self):
        self.begin("_safety/stop_before_obstacles:=true")
        wait_for_subscribers(self.scan, self.stop)

    def send_scan(self, frame="laser", obstacles=()):
        """Obstacles by angle [deg] and distance [m], about the robot."""
        message = LaserScan()
        message.header.stamp, message.header.frame_id = rospy.Time.now(), frame
        message.angle_min, message.angle_increment = -math.pi, 2.0 * math.pi / BEAMS
        message.range_min, message.range_max = 0.05, 20.0
        message.ranges = BEAMS * [math.inf]
        for angle, distance in obstacles:
            message.ranges[angle % BEAMS] = distance  # angle_min is the front of a scanner that looks back
        self.scan.publish(message)

    def expect_scanning(self, status, **how):
        def act():
            self.send_scan(**how)
            self.send_pose(0.0, 0.0, 0.0)
        return self.settled(status, act)

    def test_stands_where_it_sees_nothing_by(self):
        self.begin_with_scans()
        self.assertEqual(self.expect("stopped: no scan yet").speed, 0.0)
        self.assertEqual(self.expect_scanning("stopped: no transform from elsewhere", frame="elsewhere").speed, 0.0)
        self.assertEqual(self.expect_scanning("driving").speed, 1.5)
        self.assertEqual(self.expect("stopped: scan is").speed, 0.0)

    def test_stops_before_what_is_in_its_way_and_goes_on_by_itself(self):
        self.begin_with_scans()
        self.expect_scanning("driving")
        self.assertEqual(self.expect_scanning("stopped: obstacle", obstacles=[(0, 1.0)]).speed, 0.0)
        self.assertEqual(self.cmd_vel.message.linear.x, 0.0)
        slow = self.expect_scanning("slow: obstacle", obstacles=[(0, 2.0)]).speed
        self.assertGreater(slow, 0.5)
        self.assertLess(slow, 1.4)
        self.assertEqual(self.expect_scanning("driving", obstacles=[(90, 1.0), (180, 0.5)]).speed, 1.5)

    def test_stops_while_it_is_asked_to(self):
        self.begin()
        wait_for_subscribers(self.stop)
        self.assertEqual(self.expect("driving").speed, 1.5)
        self.stop.publish(True)
        self.assertEqual(self.expect("stopped: emergency stop").speed, 0.0)
        self.await_diagnosis("stopped: emergency stop")
        self.stop.publish(False)
        self.assertEqual(self.expect("driving").speed, 1.5)

    def test_goes_on_when_called_where_it_is_told_so(self):
        self.begin("_safety/resume_by_call:=true")
        wait_for_subscribers(self.stop)
        self.expect("driving")
        self.stop.publish(True)
        self.assertEqual(self.expect("paused: emergency stop, waiting for resume").speed, 0.0)
        self.stop.publish(False)
        self.assertEqual(self.expect("paused: emergency stop, waiting for resume").speed, 0.0)
        self.assertEqual(self.order("resume"), (True, "driving on"))
        self.assertEqual(self.expect("driving").speed, 1.5)

    def test_stands_where_a_stop_input_that_has_to_speak_is_silent(self):
        self.begin("_safety/max_stop_input_age:=0.5")
        wait_for_subscribers(self.stop)
        self.assertEqual(self.expect("stopped: emergency_stop is silent").speed, 0.0)

        def act():
            self.stop.publish(False)
            self.send_pose(0.0, 0.0, 0.0)
        self.assertEqual(self.settled("driving", act).speed, 1.5)
        self.assertEqual(self.expect("stopped: emergency_stop is silent").speed, 0.0)

    def await_diagnosis(self, text):
        end = rospy.get_time() + 8.0
        while rospy.get_time() < end:
            self.send_pose(0.0, 0.0, 0.0)
            rospy.sleep(0.05)
            message = self.diagnostics.message
            if message and any(status.message == text and status.level == 1 for status in message.status):
                return
        self.fail(f"no diagnosis says {text}")


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "steering_safety", SteeringSafetyTest)
