"""A bag of what localization_node publishes while a robot drives once round a circle, made here."""
import math

import rosbag
import rospy
from geometry_msgs.msg import PoseStamped
from multipath_localization.msg import FixReport, LocalizationState
from nav_msgs.msg import Odometry

START, STEP, RADIUS, OFF = 1.6e9, 0.1, 20.0, 0.5  # [s], [s], [m], error of the estimate [m]


def stamped(message, step, frame):
    message.header.stamp = rospy.Time.from_sec(START + STEP * step)
    message.header.frame_id = frame
    return message


def pose_at(step, off, frame):
    """The pose on the circle, `off` metres outside it, with a sigma of 0.3 m."""
    turn = 0.02 * step
    message = stamped(Odometry(), step, frame)
    message.pose.pose.position.x, message.pose.pose.position.y = [
        (RADIUS + off) * part for part in (math.cos(turn), math.sin(turn))]
    yaw = turn + 0.5 * math.pi
    message.pose.pose.orientation.z, message.pose.pose.orientation.w = math.sin(0.5 * yaw), math.cos(0.5 * yaw)
    message.pose.covariance[0] = message.pose.covariance[7] = 0.09
    message.twist.twist.linear.x = RADIUS * 0.02 / STEP
    return message


def report_at(step, accepted):
    message = stamped(FixReport(), step, 'map')
    message.kind, message.accepted, message.reason = 'fix', accepted, 'accepted' if accepted else 'gated'
    message.nis, message.predicted_sigma = 1.5 if accepted else 40.0, 1.0
    return message


def origin_at(latitude, longitude):
    message = PoseStamped()
    message.pose.position.x, message.pose.position.y = longitude, latitude
    return message


def messages_at(step):
    """(topic, message) of one estimator: fixes 2 m outside the circle, in shadow from the middle on."""
    state = LocalizationState.MULTIPATH if step >= 150 else LocalizationState.GOOD
    yield 'odometry/filtered_map', pose_at(step, OFF, 'map')
    if step % 5 == 0:
        yield 'odometry/gps', pose_at(step, 2.0, 'map')
        yield 'localization/fix_report', report_at(step, step % 50 != 0)
        yield 'localization/state', stamped(LocalizationState(state=state), step, 'map')


def write_run(file, spaces=('',), truth='', change=None):
    """Writes the bag: an estimator in each of the namespaces, truth where it has a frame. `change(step, topic, message)`
    gives the message that is written instead, None for none."""
    with rosbag.Bag(file, 'w') as bag:
        def write(step, topic, message):
            message = change(step, topic, message) if change else message
            if message is not None:
                bag.write(topic, message, rospy.Time.from_sec(START + STEP * step))
        for space in spaces:
            write(0, space + '/local_xy_origin', origin_at(52.5, 13.4))
        for step in range(315):
            for space in spaces:
                for topic, message in messages_at(step):
                    write(step, f'{space}/{topic}', message)
            if truth:
                write(step, '/truth', pose_at(step, 0.0, truth))
