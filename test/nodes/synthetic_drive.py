"""A drive over open ground for tests of localization_node: messages made here, one at a time, on their own stamps."""
import math
import random
import threading

import rospy
from geometry_msgs.msg import Quaternion
from multipath_localization.msg import FixReport, LocalizationState
from nav_msgs.msg import Odometry
from sensor_msgs.msg import NavSatFix, NavSatStatus

DATUM = (52.5, 13.4, 40.0)
MAJOR, ECCENTRICITY2 = 6378137.0, 6.69437999014e-3


def to_geodetic(east, north):
    """Latitude and longitude of a point within a few hundred metres of the datum, to a centimetre."""
    latitude = math.radians(DATUM[0])
    w = math.sqrt(1.0 - ECCENTRICITY2 * math.sin(latitude) ** 2)
    along_meridian = MAJOR * (1.0 - ECCENTRICITY2) / w ** 3 + DATUM[2]
    across = (MAJOR / w + DATUM[2]) * math.cos(latitude)
    return DATUM[0] + math.degrees(north / along_meridian), DATUM[1] + math.degrees(east / across)


class Robot:
    """Drives arcs from the map's origin; the odometry is perfect, the fixes have white noise."""

    def __init__(self, seed=1, start=1.0e9, yaw=1.0, speed=2.0, yaw_rate=0.1, noise=0.3, antenna=(0.0, 0.0)):
        self.random = random.Random(seed)
        self.stamp, self.x, self.y, self.yaw = start, 0.0, 0.0, yaw
        self.speed, self.yaw_rate, self.noise, self.antenna = speed, yaw_rate, noise, antenna
        self.start = (self.x, self.y, self.yaw)

    def step(self, duration=0.05):
        turn = self.yaw_rate * duration
        self.x += self.speed * duration * math.cos(self.yaw + 0.5 * turn)
        self.y += self.speed * duration * math.sin(self.yaw + 0.5 * turn)
        self.yaw += turn
        self.stamp += duration

    def odometry(self):
        message = Odometry()
        message.header.stamp = rospy.Time.from_sec(round(self.stamp, 6))
        message.header.frame_id, message.child_frame_id = 'odom', 'base_link'
        dx, dy, yaw0 = self.x - self.start[0], self.y - self.start[1], self.start[2]
        message.pose.pose.position.x = math.cos(yaw0) * dx + math.sin(yaw0) * dy
        message.pose.pose.position.y = -math.sin(yaw0) * dx + math.cos(yaw0) * dy
        half = 0.5 * (self.yaw - yaw0)
        message.pose.pose.orientation = Quaternion(0.0, 0.0, math.sin(half), math.cos(half))
        message.twist.twist.linear.x, message.twist.twist.angular.z = self.speed, self.yaw_rate
        return message

    def fix(self):
        message = NavSatFix()
        message.header.stamp = rospy.Time.from_sec(round(self.stamp, 6))
        message.header.frame_id = 'gps'
        message.status.status = NavSatStatus.STATUS_FIX
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        east = self.x + c * self.antenna[0] - s * self.antenna[1] + self.random.gauss(0.0, self.noise)
        north = self.y + s * self.antenna[0] + c * self.antenna[1] + self.random.gauss(0.0, self.noise)
        message.latitude, message.longitude = to_geodetic(east, north)
        message.altitude = DATUM[2]
        message.position_covariance = [0.09, 0, 0, 0, 0.09, 0, 0, 0, 1.0]
        message.position_covariance_type = NavSatFix.COVARIANCE_TYPE_DIAGONAL_KNOWN
        return message

    def error_of(self, pose):
        return math.hypot(pose.position.x - self.x, pose.position.y - self.y)


def yaw_of(orientation):
    return 2.0 * math.atan2(orientation.z, orientation.w)


def numbers_of(message):
    """All floats of a message."""
    if isinstance(message, float):
        yield message
    elif isinstance(message, (list, tuple)):
        for item in message:
            yield from numbers_of(item)
    elif hasattr(message, '__slots__'):
        for slot in message.__slots__:
            yield from numbers_of(getattr(message, slot))


class Session:
    """Talks with the node under test and remembers its answers by stamp."""

    def __init__(self):
        self.condition = threading.Condition()
        self.poses, self.reports, self.states, self.seen = {}, [], [], []
        self.odom = rospy.Publisher('odom', Odometry, queue_size=1000)
        self.gps = rospy.Publisher('gps/fix', NavSatFix, queue_size=1000)
        self.subscribers = [
            rospy.Subscriber('odometry/filtered_map', Odometry, self.on_pose, tcp_nodelay=True),
            rospy.Subscriber('localization/fix_report', FixReport, self.on_report, tcp_nodelay=True),
            rospy.Subscriber('localization/state', LocalizationState, self.on_state, tcp_nodelay=True)]
        self.wait(lambda: self.odom.get_num_connections() and self.gps.get_num_connections() and
                  all(s.get_num_connections() for s in self.subscribers), 'the node')

    def on_pose(self, message):
        self.note(lambda: self.poses.setdefault(message.header.stamp.to_nsec(), []).append(message))

    def on_report(self, message):
        self.note(lambda: self.reports.append(message))

    def on_state(self, message):
        self.note(lambda: self.states.append(message))

    def note(self, action):
        with self.condition:
            action()
            self.condition.notify_all()

    def wait(self, done, what, timeout=10.0):
        with self.condition:
            for _ in range(int(timeout / 0.05)):
                if done():
                    return
                self.condition.wait(0.05)
        raise AssertionError('waited in vain for ' + what)

    def send_odometry(self, message, answered=True):
        """Sends odometry and, if it has to be answered, waits for its pose and returns it."""
        self.odom.publish(message)
        if not answered:
            return None
        stamp = message.header.stamp.to_nsec()
        self.wait(lambda: stamp in self.poses, 'a pose at %f' % message.header.stamp.to_sec())
        return self.poses[stamp][-1]

    def send_fix(self, message):
        """Sends a fix and waits for its report."""
        number = len(self.reports)
        self.gps.publish(message)
        self.wait(lambda: len(self.reports) > number, 'a report on the fix at %f' % message.header.stamp.to_sec())
        return self.reports[-1]

    def drive(self, robot, seconds, fix_every=4, answered=True):
        """Odometry at 20 Hz, a fix with every `fix_every`-th; returns the poses."""
        poses = []
        for i in range(int(round(seconds * 20))):
            robot.step()
            poses.append(self.send_odometry(robot.odometry(), answered))
            if fix_every and i % fix_every == 0:
                self.send_fix(robot.fix())
        return poses

    def begin(self, robot):
        """The first odometry and fix; the pose comes with the fix."""
        self.send_odometry(robot.odometry(), answered=False)
        self.send_fix(robot.fix())
        stamp = robot.odometry().header.stamp.to_nsec()
        self.wait(lambda: stamp in self.poses, 'the first pose')
