"""What tests of steering_node share: poses and states made up here, and what the node makes of them."""
import math
import subprocess
import time
import unittest

import rospy
from geometry_msgs.msg import Pose, PoseArray, Twist
from multipath_localization.msg import LocalizationState, SteeringCommand
from nav_msgs.msg import Odometry
from roslib.packages import find_node
from std_msgs.msg import Float64, String
from std_srvs.srv import SetBool, Trigger


class Last:
    """The last message of a topic."""

    def __init__(self, topic, kind):
        self.message = None
        self.count = 0
        self.subscriber = rospy.Subscriber(topic, kind, self.take, queue_size=100)

    def take(self, message):
        self.message = message
        self.count += 1


def wait_for_subscribers(*publishers):
    end = time.time() + 10.0
    while time.time() < end and 0 in [publisher.get_num_connections() for publisher in publishers]:
        time.sleep(0.05)


def waypoint_array(points, frame="map", stamp=None):
    message = PoseArray()
    message.header.frame_id = frame
    message.header.stamp = stamp or rospy.Time()
    for x, y in points:
        pose = Pose()
        pose.position.x, pose.position.y, pose.orientation.w = x, y, 1.0
        message.poses.append(pose)
    return message


class SteeringCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("steering_test")
        cls.pose = rospy.Publisher("odometry/filtered_map", Odometry, queue_size=10)
        cls.state = rospy.Publisher("localization/state", LocalizationState, queue_size=10, latch=True)
        cls.steering = Last("steering", SteeringCommand)
        cls.cmd_vel = Last("cmd_vel", Twist)
        cls.status = Last("steering/status", String)
        cls.progress = Last("steering/progress", Float64)

    def begin(self, *arguments):
        """Starts the node, ended with the test at the latest."""
        self.steering.message = self.cmd_vel.message = self.status.message = None
        node = find_node("multipath_localization", "steering_node")[0]
        self.node = subprocess.Popen([node, "__name:=steering", *arguments])
        self.addCleanup(self.node.wait)
        self.addCleanup(self.node.kill)
        wait_for_subscribers(self.pose, self.state)
        self.set_state(LocalizationState.GOOD)

    def order(self, name, *data):
        """Calls a service of the node; whether it was done, and the message."""
        service = f"steering/{name}"
        rospy.wait_for_service(service, 10.0)
        answer = rospy.ServiceProxy(service, SetBool if data else Trigger)(*data)
        return answer.success, answer.message

    def set_state(self, state):
        self.state.publish(LocalizationState(state=state))

    def send_pose(self, x, y, yaw, age=0.0, frame="map", stamp=None, sigma=0.0):
        message = Odometry()
        message.header.stamp = stamp or rospy.Time.now() - rospy.Duration(age)
        message.header.frame_id = frame
        message.pose.pose.position.x = x
        message.pose.pose.position.y = y
        message.pose.covariance = [sigma ** 2] + 6 * [0.0] + [sigma ** 2] + 28 * [0.0]
        message.pose.pose.orientation.z = math.sin(0.5 * yaw)
        message.pose.pose.orientation.w = math.cos(0.5 * yaw)
        self.pose.publish(message)

    def expect(self, status, x=0.0, y=0.0, yaw=0.0, **how):
        """Sends a pose at 20 Hz until the status is as expected and the command changes no more; that command."""
        return self.settled(status, lambda: self.send_pose(x, y, yaw, **how))

    def expect_silent(self, status):
        """The same without sending poses."""
        return self.settled(status, lambda: None)

    def settled(self, status, act):
        end = time.time() + 8.0
        same, before = 0, (math.nan, math.nan)
        while time.time() < end:
            act()
            time.sleep(0.05)
            last = self.steering.message
            command = (last.speed, last.steering_angle) if last else (0.0, 0.0)
            expected = self.status.message and self.status.message.data.startswith(status)
            # A pose is carried forward by its age, which is not the same each time.
            unchanged = command[0] == before[0] and abs(command[1] - before[1]) < 0.02
            same = same + 1 if expected and unchanged else 0
            before = command
            if same > 3:
                return last
        self.fail(f"status is {self.status.message}, not {status}, or the command {before} still changes")
