#!/usr/bin/python3
"""gnss_receiver_node makes of a receiver's stream, and of its driver's topics, epochs that localise a robot that stands."""
import math
import shutil
import struct
import threading
import time
import unittest

import genpy.dynamic
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from multipath_localization.msg import GnssEpoch
from nav_msgs.msg import Odometry

RAWX = """uint8 CLASS_ID = 2
uint8 MESSAGE_ID = 21
float64 rcvTOW
uint16 week
int8 leapS
uint8 numMeas
uint8 recStat
uint8 REC_STAT_LEAP_SEC = 1
uint8 REC_STAT_CLK_RESET = 2
uint8 version
uint8[2] reserved1
RxmRAWX_Meas[] meas
================================================================================
MSG: ublox_msgs/RxmRAWX_Meas
float64 prMes
float64 cpMes
float32 doMes
uint8 gnssId
uint8 svId
uint8 reserved0
uint8 freqId
uint16 locktime
int8 cno
uint8 prStdev
uint8 cpStdev
uint8 doStdev
uint8 trkStat
uint8 reserved1
"""
SFRBX = """uint8 CLASS_ID = 2
uint8 MESSAGE_ID = 19
uint8 gnssId
uint8 svId
uint8 reserved0
uint8 freqId
uint8 numWords
uint8 chn
uint8 version
uint8 reserved1
uint32[] dwrd
"""
RxmRAWX = genpy.dynamic.generate_dynamic('ublox_msgs/RxmRAWX', RAWX)
RxmSFRBX = genpy.dynamic.generate_dynamic('ublox_msgs/RxmSFRBX', SFRBX)['ublox_msgs/RxmSFRBX']


def payloads(stream):
    """The UBX messages of class RXM: identifier and payload of each."""
    place = stream.find(b'\xb5\x62')
    while place >= 0:
        kind, identifier, length = struct.unpack_from('<BBH', stream, place + 2)
        if kind == 2:
            yield identifier, stream[place + 6:place + 6 + length]
        place = stream.find(b'\xb5\x62', place + 8 + length)


def rawx(payload):
    message = RxmRAWX['ublox_msgs/RxmRAWX']()
    (message.rcvTOW, message.week, message.leapS, message.numMeas, message.recStat,
     message.version) = struct.unpack_from('<dHbBBB', payload)
    message.reserved1 = b'\0\0'
    for place in range(16, len(payload), 32):
        message.meas.append(RxmRAWX['ublox_msgs/RxmRAWX_Meas'](*struct.unpack_from('<ddfBBBBHbBBBBB', payload, place)))
    return message


def sfrbx(payload):
    words = struct.unpack_from('<%dI' % payload[4], payload, 8)
    return RxmSFRBX(*struct.unpack_from('<8B', payload), list(words))


def satellites(epoch):
    return [(p.constellation, p.satellite, p.pseudorange, p.range_rate, p.position.x) for p in epoch.pseudoranges]


class GnssReceiverNodeTest(unittest.TestCase):
    def setUp(self):
        self.lock = threading.Lock()
        self.seen = {'stream': [], 'driver': [], 'poses': [], 'statuses': []}
        self.subscribers = [self.record('gnss/epoch', GnssEpoch, 'stream'),
                            self.record('driver/gnss/epoch', GnssEpoch, 'driver'),
                            self.record('odometry/filtered_map', Odometry, 'poses'),
                            self.record('/diagnostics', DiagnosticArray, 'statuses')]

    def record(self, topic, kind, name):
        def take(message):
            with self.lock:
                self.seen[name].append(message)
        return rospy.Subscriber(topic, kind, take, queue_size=1000)

    def stand(self, seconds):
        odom = rospy.Publisher('odom', Odometry, queue_size=10)
        message = Odometry()
        message.header.frame_id, message.child_frame_id = 'odom', 'base_link'
        message.pose.pose.orientation.w = 1.0
        for _ in range(int(20 * seconds)):
            message.header.stamp = rospy.Time.now()
            odom.publish(message)
            time.sleep(0.05)

    def test_stream_and_driver_give_epochs_and_a_pose(self):
        raw = rospy.Publisher('driver/rxmraw', RxmRAWX['ublox_msgs/RxmRAWX'], queue_size=1000)
        frames = rospy.Publisher('driver/rxmsfrb', RxmSFRBX, queue_size=1000)
        self.stand(10.0)
        with open(rospy.get_param('/gnss_receiver_test/stream'), 'rb') as file:
            stream = file.read()
        for identifier, payload in payloads(stream):
            if identifier == 0x15:
                raw.publish(rawx(payload))
            else:
                frames.publish(sfrbx(payload))
            time.sleep(0.01)
        self.stand(3.0)
        with self.lock:
            self.check()
        self.check_ephemerides('/tmp/gnss_receiver_node_test')

    def check(self):
        stream, driver = self.seen['stream'], self.seen['driver']
        self.assertGreater(len(stream), 50)
        self.assertGreater(len(driver), 140)
        stamps = [message.header.stamp for message in stream]
        self.assertEqual(stamps, sorted(stamps))
        self.assertEqual(driver[0].header.stamp.to_sec() // 3600, 1719216000 // 3600, 'when it was recorded, UTC')
        self.assertEqual(stream[-1].header.frame_id, 'gps')
        self.assertGreater(len(stream[-1].pseudoranges), 5)
        by_driver = [satellites(epoch) for epoch in driver]
        self.assertGreater(sum(satellites(epoch) in by_driver for epoch in stream), 0.9 * len(stream))
        position = self.seen['poses'][-1].pose.pose.position
        self.assertLess(math.hypot(position.x, position.y), 5.0, 'metres')
        said = [status.message for array in self.seen['statuses'] for status in array.status
                if status.name == 'gnss_receiver: receiver' and status.level == 0]
        self.assertTrue(any('epochs of' in message for message in said), said)

    def check_ephemerides(self, folder):
        with open(folder + '/ephemerides.rnx', encoding='ascii') as file:
            lines = file.readlines()
        shutil.rmtree(folder)
        self.assertIn('RINEX VERSION / TYPE', lines[0])
        self.assertGreater(sum(line.startswith('G') for line in lines[2:]), 5)


if __name__ == '__main__':
    rospy.init_node('gnss_receiver_node_test')
    rostest.rosrun('multipath_localization', 'gnss_receiver_node', GnssReceiverNodeTest)
