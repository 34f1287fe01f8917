#!/usr/bin/python3
"""Services as robot_localization's clients call them, and the datum that outlives the node."""
import math
import os
import subprocess
import tempfile
import unittest

import robot_localization_services
import rospy
import rostest
from geometry_msgs.msg import Point, PoseStamped, PoseWithCovarianceStamped, Quaternion
from roslib.packages import find_node
from std_srvs.srv import Empty
from synthetic_drive import DATUM, Robot, Session, to_geodetic

msg, srv = robot_localization_services.define()
HERE = msg.GeoPoint(*DATUM)


def client(name, space=''):
    """A client of one of the services."""
    types = {'datum': srv.SetDatum, 'toLL': srv.ToLL, 'fromLL': srv.FromLL, 'set_pose': srv.SetPose}
    rospy.wait_for_service(space + name, 10.0)
    return rospy.ServiceProxy(space + name, types[name])


def pose_at(x, y, yaw, frame='map'):
    message = PoseWithCovarianceStamped()
    message.header.frame_id = frame
    message.pose.pose.position = Point(x, y, 0.0)
    message.pose.pose.orientation = Quaternion(0.0, 0.0, math.sin(0.5 * yaw), math.cos(0.5 * yaw))
    message.pose.covariance[0] = message.pose.covariance[7] = 0.04
    message.pose.covariance[35] = 0.01
    return message


class LocalizationServices(unittest.TestCase):
    def setUp(self):
        self.datum, self.to_ll, self.from_ll = client('datum'), client('toLL'), client('fromLL')

    def assert_refused(self, service, *request):
        self.assertRaises(rospy.ServiceException, service, *request)

    def test_0_the_clients_are_those_of_the_published_package(self):
        self.assertEqual(srv.SetDatum._md5sum, 'fe903ca95d0210defda73a1629604439')
        self.assertEqual(srv.ToLL._md5sum, 'ad0cbea3b8423e9ccf1b2ebeefc50b92')
        self.assertEqual(srv.FromLL._md5sum, 'a6cd7064e35acbe3e4c3ac3dc5fd8265')

    def test_1_without_a_datum_everything_is_refused(self):
        self.assert_refused(self.to_ll, Point())
        self.assert_refused(self.from_ll, HERE)
        self.assert_refused(client('set_pose'), pose_at(0.0, 0.0, 0.0))

    def test_2_unusable_datums_are_refused(self):
        self.assert_refused(self.datum, msg.GeoPose(msg.GeoPoint(91.0, 0.0, 0.0), Quaternion()))
        self.assert_refused(self.datum, msg.GeoPose(msg.GeoPoint(math.nan, 0.0, 0.0), Quaternion()))
        self.assert_refused(self.datum, msg.GeoPose(HERE, Quaternion(0.0, 0.0, math.sin(0.1), math.cos(0.1))))
        self.assert_refused(self.datum, msg.GeoPose(HERE, Quaternion(0.0, 0.0, 0.0, math.nan)))
        self.assert_refused(self.to_ll, Point())

    def test_3_places_and_points(self):
        self.datum(msg.GeoPose(HERE, Quaternion(0.0, 0.0, 0.0, 1.0)))
        origin = self.to_ll(Point()).ll_point
        self.assertAlmostEqual(origin.latitude, DATUM[0], 9)
        self.assertAlmostEqual(origin.longitude, DATUM[1], 9)
        self.assertAlmostEqual(origin.altitude, DATUM[2], 6)
        place = self.to_ll(Point(100.0, -50.0, 7.0)).ll_point
        latitude, longitude = to_geodetic(100.0, -50.0)
        self.assertAlmostEqual(place.latitude, latitude, 6)
        self.assertAlmostEqual(place.longitude, longitude, 6)
        self.assertAlmostEqual(place.altitude, DATUM[2] + 7.0, 2)
        back = self.from_ll(place).map_point
        for got, expected in ((back.x, 100.0), (back.y, -50.0), (back.z, 7.0)):
            self.assertAlmostEqual(got, expected, 6)
        self.assertLess(abs(self.from_ll(msg.GeoPoint(latitude, longitude, math.nan)).map_point.z), 0.01)
        self.assert_refused(self.from_ll, msg.GeoPoint(math.nan, 0.0, 0.0))
        self.assert_refused(self.to_ll, Point(math.inf, 0.0, 0.0))

    def assert_origin(self, longitude, latitude):
        origin = rospy.wait_for_message('local_xy_origin', PoseStamped, 10.0)
        self.assertEqual(origin.header.frame_id, 'map')
        self.assertAlmostEqual(origin.pose.position.x, longitude, 9)
        self.assertAlmostEqual(origin.pose.position.y, latitude, 9)

    def test_4_a_datum_in_the_middle_of_a_drive_starts_afresh(self):
        self.datum(msg.GeoPose(HERE, Quaternion()))
        session, robot = Session(), Robot(seed=1)
        session.begin(robot)
        pose = session.drive(robot, 25.0)[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 0.8, 'metres')
        self.assert_origin(DATUM[1], DATUM[0])
        east = self.to_ll(Point(100.0, 0.0, 0.0)).ll_point
        self.datum(msg.GeoPose(east, Quaternion()))
        self.assert_origin(east.longitude, east.latitude)
        session.wait(lambda: session.states[-1].name == 'NOT_READY', 'the state after the datum')
        robot.step()
        session.begin(robot)
        pose = session.drive(robot, 25.0)[-1].pose.pose
        pose.position.x += 100.0
        self.assertLess(robot.error_of(pose), 0.8, 'metres')
        rospy.ServiceProxy('global_localization', Empty)()
        session.wait(lambda: session.states[-1].name == 'NOT_READY', 'the state after global_localization')

    def test_5_a_pose_is_set(self):
        self.datum(msg.GeoPose(HERE, Quaternion()))
        session, robot = Session(), Robot(seed=2, start=2.0e9)
        session.send_odometry(robot.odometry(), answered=False)
        session.begin(robot)
        set_pose = client('set_pose')
        self.assert_refused(set_pose, pose_at(30.0, -20.0, 0.5, frame='odom'))
        set_pose(pose_at(30.0, -20.0, 0.5))
        robot.x, robot.y, robot.yaw = robot.start = (30.0, -20.0, 0.5)
        pose = session.drive(robot, 2.0, fix_every=0)[-1]
        self.assertLess(robot.error_of(pose.pose.pose), 0.8, 'metres')

    def site(self):
        """The file of a datum that is not there yet, and the command for a node that keeps its datum in it."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = os.path.join(folder.name, 'site', 'datum.yaml')
        node = find_node('multipath_localization', 'localization_node')[0]
        return file, [node, '__name:=saving', '__ns:=site', '_datum_file:=' + file]

    @staticmethod
    def run_node(command, use):
        """Starts a node and stops it after `use` has been called."""
        process = subprocess.Popen(command)
        try:
            return use()
        finally:
            process.terminate()
            process.wait(10.0)

    def test_6_a_saved_datum_outlives_the_node(self):
        command = self.site()[1]
        self.run_node(command, lambda: client('datum', 'site/')(msg.GeoPose(HERE, Quaternion())))
        origin = self.run_node(command, lambda: client('toLL', 'site/')(Point())).ll_point
        self.assertAlmostEqual(origin.latitude, DATUM[0], 8)
        self.assertAlmostEqual(origin.longitude, DATUM[1], 8)
        self.assertAlmostEqual(origin.altitude, DATUM[2], 3)

    def test_7_a_damaged_datum_is_refused(self):
        path, command = self.site()
        os.mkdir(os.path.dirname(path))
        with open(path, 'w', encoding='utf-8') as file:
            file.write('datum: [52.5, 13')
        run = subprocess.run(command, capture_output=True, text=True, timeout=20)
        self.assertEqual(run.returncode, 1)
        self.assertIn(path + ' is damaged', run.stderr + run.stdout)


if __name__ == '__main__':
    rospy.init_node('localization_services_test')
    rostest.rosrun('multipath_localization', 'localization_services', LocalizationServices)
