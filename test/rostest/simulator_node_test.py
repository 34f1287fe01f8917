#!/usr/bin/python3
"""simulator_node alone: what it publishes, that it obeys and that it stops. All times are simulated seconds."""
import math
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import Twist, Vector3Stamped
from multipath_localization.msg import GnssEpoch, SteeringCommand
from nav_msgs.msg import Odometry
from sensor_msgs.msg import NavSatFix
from visualization_msgs.msg import MarkerArray


class Recorder:
    """The messages of a topic, with the time of their arrival."""

    def __init__(self, topic, kind):
        self.messages = []
        self.arrivals = []
        self.subscriber = rospy.Subscriber(topic, kind, self.take, queue_size=1000)

    def take(self, message):
        self.messages.append(message)
        self.arrivals.append(rospy.Time.now())

    def wait(self, count, timeout=15.0):
        goal = len(self.messages) + count
        end = rospy.Time.now() + rospy.Duration(timeout)
        while len(self.messages) < goal and rospy.Time.now() < end:
            rospy.sleep(0.02)
        assert len(self.messages) >= goal, f"only {len(self.messages)} of {goal} messages"
        return self.messages[-count:]


class SimulatorNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("simulator_node_test")
        cls.fix = Recorder("gps/fix", NavSatFix)
        cls.left = Recorder("gps/left/fix", NavSatFix)
        cls.right = Recorder("gps/right/fix", NavSatFix)
        cls.epoch = Recorder("sky/gnss/epoch", GnssEpoch)
        cls.odometry = Recorder("odom", Odometry)
        cls.truth = Recorder("truth", Odometry)
        cls.bias = Recorder("truth/bias", Vector3Stamped)
        cls.markers = Recorder("simulator/markers", MarkerArray)
        cls.steering = rospy.Publisher("steering", SteeringCommand, queue_size=1)
        cls.cmd_vel = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        cls.buffer = tf2_ros.Buffer()
        cls.listener = tf2_ros.TransformListener(cls.buffer)
        cls.truth.wait(1)

    def command(self, publisher, message, duration):
        """Commands at 20 Hz; the truth at the end."""
        end = rospy.Time.now() + rospy.Duration(duration)
        while rospy.Time.now() < end:
            publisher.publish(message)
            rospy.sleep(0.05)
        return self.truth.wait(1)[-1]

    def wait_for_rest(self):
        end = rospy.Time.now() + rospy.Duration(6.0)
        while rospy.Time.now() < end:
            if abs(self.truth.wait(1)[-1].twist.twist.linear.x) < 1e-9:
                return
        self.fail("the robot does not stop")

    def test_publishes_with_sane_stamps(self):
        for recorder, count in ((self.odometry, 50), (self.truth, 50), (self.fix, 5), (self.bias, 50)):
            stamps = [m.header.stamp.to_sec() for m in recorder.wait(count)]
            self.assertEqual(stamps, sorted(set(stamps)))
            age = (rospy.Time.now() - recorder.messages[-1].header.stamp).to_sec()
            self.assertLess(abs(age), 2.0)
        steps = [m.header.stamp.to_sec() for m in self.odometry.messages[-20:]]
        self.assertAlmostEqual((steps[-1] - steps[0]) / 19.0, 0.02, places=5)

    def test_fixes_say_what_the_receiver_claims(self):
        fix = self.fix.wait(1)[0]
        self.assertEqual(fix.header.frame_id, "gps")
        self.assertEqual(fix.position_covariance_type, NavSatFix.COVARIANCE_TYPE_KNOWN)
        self.assertAlmostEqual(fix.position_covariance[0], 0.09, places=9)
        self.assertAlmostEqual(fix.latitude, 33.894, delta=0.001)
        self.assertAlmostEqual(fix.longitude, 130.839, delta=0.001)

    def test_pairs_come_from_antennas_that_tf_knows(self):
        left, right = self.left.wait(1)[0], self.right.wait(1)[0]
        self.assertEqual((left.header.frame_id, right.header.frame_id), ("gps_left", "gps_right"))
        baseline = self.buffer.lookup_transform("gps_right", "gps_left", rospy.Time(0), rospy.Duration(5.0))
        self.assertAlmostEqual(baseline.transform.translation.y, 0.3)
        metres_per_degree = 111e3
        self.assertLess(abs(left.latitude - right.latitude) * metres_per_degree, 0.5)

    def test_epochs_come_from_simulated_satellites_alone(self):
        epoch = self.epoch.wait(2)[-1]
        self.assertEqual(epoch.header.frame_id, "sky_gps")
        self.assertGreater(len(epoch.pseudoranges), 10, "in the open")
        for observed in epoch.pseudoranges:
            centre = math.dist((observed.position.x, observed.position.y, observed.position.z), (0.0, 0.0, 0.0))
            self.assertTrue(2.4e7 < centre < 3.2e7, centre)
            self.assertTrue(1.8e7 < observed.pseudorange < 3.0e7, observed.pseudorange)
        topics = [topic for topic, _ in rospy.get_published_topics()]
        self.assertIn("/sky/gps/fix", topics)
        self.assertNotIn("/gnss/epoch", topics)
        self.assertNotIn("/sky/gps/left/fix", topics)

    def test_fixes_come_late(self):
        self.fix.wait(5)
        ages = [(t - m.header.stamp).to_sec() for t, m in zip(self.fix.arrivals, self.fix.messages)]
        self.assertGreater(min(ages), 0.05)  # /clock may lag behind the fix

    def test_frames_and_covariances(self):
        odometry = self.odometry.wait(1)[0]
        self.assertEqual((odometry.header.frame_id, odometry.child_frame_id), ("odom", "base_link"))
        self.assertGreater(odometry.twist.covariance[0], 0.0)
        self.assertGreater(odometry.twist.covariance[35], 0.0)
        self.assertEqual(self.truth.wait(1)[0].header.frame_id, "map")
        lever = self.buffer.lookup_transform("base_link", "gps", rospy.Time(0), rospy.Duration(5.0))
        self.assertAlmostEqual(lever.transform.translation.x, 0.3)
        self.buffer.lookup_transform("odom", "base_link", rospy.Time(0), rospy.Duration(5.0))

    def test_markers_are_latched(self):
        end = rospy.Time.now() + rospy.Duration(5.0)
        while not self.markers.messages and rospy.Time.now() < end:
            rospy.sleep(0.05)
        kinds = [m.ns for m in self.markers.messages[0].markers]
        self.assertEqual(kinds.count("shadow zones"), 3)
        self.assertGreaterEqual(kinds.count("buildings"), 3)

    def test_obeys_steering_and_stops_without(self):
        truth = self.command(self.steering, SteeringCommand(speed=1.0, steering_angle=0.2), 3.0)
        self.assertAlmostEqual(truth.twist.twist.linear.x, 1.0, delta=0.15)
        self.assertAlmostEqual(truth.twist.twist.angular.z, 2.0 * math.tan(0.2), delta=0.25)
        self.wait_for_rest()

    def test_obeys_cmd_vel_and_stops_without(self):
        message = Twist()
        message.linear.x, message.angular.z = -0.8, 0.3
        truth = self.command(self.cmd_vel, message, 3.0)
        self.assertAlmostEqual(truth.twist.twist.linear.x, -0.8, delta=0.15)
        self.assertAlmostEqual(truth.twist.twist.angular.z, 0.3, delta=0.2)
        self.wait_for_rest()

    def test_stays_finite_under_hostile_commands(self):
        self.command(self.steering, SteeringCommand(speed=1.0), 1.0)
        for bad in (float("nan"), float("inf"), -1e308):
            message = Twist()
            message.linear.x = message.angular.z = bad
            self.command(self.steering, SteeringCommand(speed=bad, steering_angle=bad), 0.3)
            self.command(self.cmd_vel, message, 0.3)
        self.command(self.steering, SteeringCommand(speed=float("nan")), 2.5)
        self.wait_for_rest()
        truth = self.truth.wait(1)[0]
        position = truth.pose.pose.position
        self.assertTrue(all(math.isfinite(v) for v in (position.x, position.y, truth.twist.twist.linear.x)))
        self.assertTrue(math.isfinite(self.fix.wait(1)[0].latitude))


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "simulator_node", SimulatorNodeTest)
