"""A drive over open ground for tests of localization_node: messages made here, one at a time, on their own stamps."""
import copy
import math
import os
import random
import threading
import time

import rospy
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from multipath_localization.msg import FixReport, GnssEpoch, LocalizationState, Pseudorange
from nav_msgs.msg import Odometry
from sensor_msgs.msg import NavSatFix, NavSatStatus

DATUM = (52.5, 13.4, 40.0)
MAJOR, ECCENTRICITY2 = 6378137.0, 6.69437999014e-3
EARTH_RATE, LIGHT = 7.2921151467e-5, 299792458.0
CLOCK = -136902.0  # of the receiver [m]
SKY = [(45.0 * i, elevation) for i, elevation in enumerate((20.0, 45.0, 70.0, 30.0) * 2)]  # azimuth, elevation [deg]
# Under a sanitizer all takes several times as long.
PATIENCE = float(os.environ.get('TEST_PATIENCE', '1'))


def to_geodetic(east, north):
    """Latitude and longitude of a point within a few hundred metres of the datum, to a centimetre."""
    latitude = math.radians(DATUM[0])
    w = math.sqrt(1.0 - ECCENTRICITY2 * math.sin(latitude) ** 2)
    along_meridian = MAJOR * (1.0 - ECCENTRICITY2) / w ** 3 + DATUM[2]
    across = (MAJOR / w + DATUM[2]) * math.cos(latitude)
    return DATUM[0] + math.degrees(north / along_meridian), DATUM[1] + math.degrees(east / across)


def to_ecef(east, north, up):
    """A point of the map in ECEF."""
    latitude, longitude = math.radians(DATUM[0]), math.radians(DATUM[1])
    s, c, sl, cl = math.sin(latitude), math.cos(latitude), math.sin(longitude), math.cos(longitude)
    across = MAJOR / math.sqrt(1.0 - ECCENTRICITY2 * s * s)
    outward = (across + DATUM[2]) * c - s * north + c * up
    return (cl * outward - sl * east, sl * outward + cl * east,
            (across * (1.0 - ECCENTRICITY2) + DATUM[2]) * s + c * north + s * up)


def pseudorange_of(satellite, azimuth, elevation, antenna):
    """What a receiver without error but in its clock measures of a satellite 22000 km off."""
    a, e = math.radians(azimuth), math.radians(elevation)
    place = [2.2e7 * part for part in (math.sin(a) * math.cos(e), math.cos(a) * math.cos(e), math.sin(e))]
    message = Pseudorange(constellation=Pseudorange.GPS, satellite=satellite, cn0=45.0, elevation=e, sigma=3.0)
    message.pseudorange = math.dist(place, antenna) + CLOCK
    message.range_rate = message.velocity.x = message.velocity.y = message.velocity.z = math.nan
    turn = EARTH_RATE * math.hypot(*place) / LIGHT  # of the Earth while the signal flies
    x, y, message.position.z = to_ecef(*place)
    message.position.x = math.cos(turn) * x - math.sin(turn) * y
    message.position.y = math.sin(turn) * x + math.cos(turn) * y
    return message


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

    def pair(self, baseline=1.0):
        """Fixes of antennas to the left and to the right, good to a centimetre."""
        fixes = []
        for frame, side in (('gps_left', 0.5), ('gps_right', -0.5)):
            antenna = copy.copy(self)
            antenna.antenna, antenna.noise = (0.0, side * baseline), 0.01
            fixes.append(antenna.fix())
            fixes[-1].header.frame_id = frame
            fixes[-1].position_covariance = [1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1.0]
        return fixes

    def epoch(self):
        """Pseudoranges of eight satellites with white noise."""
        message = GnssEpoch()
        message.header.stamp = rospy.Time.from_sec(round(self.stamp, 6))
        message.header.frame_id = 'gps'
        for satellite, (azimuth, elevation) in enumerate(SKY, 1):
            message.pseudoranges.append(pseudorange_of(satellite, azimuth, elevation, (self.x, self.y, 0.0)))
            message.pseudoranges[-1].pseudorange += self.random.gauss(0.0, self.noise)
        return message

    def error_of(self, pose):
        return math.hypot(pose.position.x - self.x, pose.position.y - self.y)


def antenna_transform(frame, x, y, yaw=0.0):
    """Where on the base an antenna is, for a StaticTransformBroadcaster."""
    transform = TransformStamped()
    transform.header.frame_id, transform.child_frame_id = 'base_link', frame
    transform.transform.translation = Vector3(x, y, 1.5)
    transform.transform.rotation = Quaternion(0.0, 0.0, math.sin(0.5 * yaw), math.cos(0.5 * yaw))
    return transform


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
    """Talks with the node under test in a namespace ('' or 'name/') and remembers its answers by stamp."""

    def __init__(self, space=''):
        self.condition = threading.Condition()
        self.poses, self.reports, self.states, self.seen = {}, [], [], []
        self.odom = rospy.Publisher(space + 'odom', Odometry, queue_size=1000)
        self.gps = rospy.Publisher(space + 'gps/fix', NavSatFix, queue_size=1000)
        self.left = rospy.Publisher(space + 'gps/left/fix', NavSatFix, queue_size=1000)
        self.right = rospy.Publisher(space + 'gps/right/fix', NavSatFix, queue_size=1000)
        self.raw = rospy.Publisher(space + 'gnss/epoch', GnssEpoch, queue_size=1000)
        self.subscribers = [
            rospy.Subscriber(space + 'odometry/filtered_map', Odometry, self.on_pose, tcp_nodelay=True),
            rospy.Subscriber(space + 'localization/fix_report', FixReport, self.on_report, tcp_nodelay=True),
            rospy.Subscriber(space + 'localization/state', LocalizationState, self.on_state, tcp_nodelay=True)]
        self.links = [self.odom, self.gps, self.left, self.right, self.raw] + self.subscribers
        self.wait(lambda: all(link.get_num_connections() for link in self.links), 'the node')

    def close(self):
        """Lets go of a node that is gone, so that the next session waits for the next one."""
        for link in self.links:
            link.unregister()

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
        deadline = time.monotonic() + timeout * PATIENCE
        with self.condition:
            while not done():
                if time.monotonic() > deadline:
                    raise AssertionError('waited in vain for ' + what)
                self.condition.wait(0.05)

    def send_odometry(self, message, answered=True):
        """Sends odometry and, if it has to be answered, waits for its pose and returns it."""
        self.odom.publish(message)
        if not answered:
            return None
        stamp = message.header.stamp.to_nsec()
        self.wait(lambda: stamp in self.poses, 'a pose at %f' % message.header.stamp.to_sec())
        return self.poses[stamp][-1]

    def reported(self, send, stamp):
        """Calls what sends a measurement and waits for the report on it."""
        number = len(self.reports)
        send()
        self.wait(lambda: len(self.reports) > number, 'a report on the measurement at %f' % stamp.to_sec())
        return self.reports[-1]

    def send_fix(self, message):
        """Sends a fix and waits for its report."""
        return self.reported(lambda: self.gps.publish(message), message.header.stamp)

    def send_epoch(self, message):
        """Sends an epoch and waits for its report."""
        return self.reported(lambda: self.raw.publish(message), message.header.stamp)

    def send_pair(self, pair):
        """Sends the fixes of two antennas and waits for the report on both."""
        left, right = pair
        return self.reported(lambda: (self.left.publish(left), self.right.publish(right)), left.header.stamp)

    def drive(self, robot, seconds, fix_every=4, answered=True, send=None):
        """Odometry at 20 Hz, a fix (or what `send` sends) with every `fix_every`-th; returns the poses."""
        poses = []
        for i in range(int(round(seconds * 20))):
            robot.step()
            poses.append(self.send_odometry(robot.odometry(), answered))
            if fix_every and i % fix_every == 0:
                if send:
                    send(robot)
                else:
                    self.send_fix(robot.fix())
        return poses

    def begin(self, robot, fixes=1):
        """The first odometry and fix, or three where they have to tell the datum; the pose comes with the fix."""
        self.send_odometry(robot.odometry(), answered=False)
        time.sleep(0.1)  # a fix takes a way of its own and may be faster, which after a jump in time is too early
        for _ in range(fixes - 1):
            self.gps.publish(robot.fix())
        self.send_fix(robot.fix())
        stamp = robot.odometry().header.stamp.to_nsec()
        self.wait(lambda: stamp in self.poses, 'the first pose')
