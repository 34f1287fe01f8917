#!/usr/bin/env python3
"""localization_node goes on over the connections it has when the master dies and comes again."""
import os
import re
import socket
import subprocess
import time
import unittest

from roslib.packages import find_node
from synthetic_drive import PATIENCE


def free_port():
    with socket.socket() as probe:
        probe.bind(('localhost', 0))
        return probe.getsockname()[1]


class MasterRestart(unittest.TestCase):
    def setUp(self):
        self.port = free_port()
        self.env = dict(os.environ, ROS_MASTER_URI='http://localhost:%d' % self.port)

    def start(self, *command, **options):
        process = subprocess.Popen(command, env=self.env, universal_newlines=True, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def start_program(self, name, *arguments, **options):
        return self.start(find_node('multipath_localization', name)[0], *arguments, **options)

    def start_master(self):
        master = self.start('rosmaster', '--core', '-p', str(self.port), stdout=subprocess.DEVNULL)
        for _ in range(200):
            with socket.socket() as probe:
                if probe.connect_ex(('localhost', self.port)) == 0:
                    return master
            time.sleep(0.05)
        return self.fail('no master')

    def test_every_odometry_and_every_fix_is_answered_all_the_same(self):
        master = self.start_master()
        datum = ['rosparam', 'set', '/localization/datum', '[52.5, 13.4, 0.0, 40.0]']
        subprocess.check_call(datum, env=self.env)
        self.start_program('localization_node', '__name:=localization')
        soak = self.start_program('soak', '_hours:=2', stdout=subprocess.PIPE)
        first = soak.stdout.readline()
        self.assertIn('poses', first)
        master.kill()
        master.wait()
        time.sleep(1.0)
        self.assertIsNone(soak.poll(), 'the hours were over before the master was back')
        self.start_master()
        rest = soak.communicate(timeout=100 * PATIENCE)[0]
        self.assertEqual(soak.returncode, 0, first + rest)
        for line in [first] + rest.splitlines()[:-1]:
            poses = int(re.search(r'(\d+) poses', line).group(1))
            self.assertGreater(poses, 65000, 'of 72000 in the hour: ' + line)


if __name__ == '__main__':
    import rostest
    rostest.rosrun('multipath_localization', 'master_restart', MasterRestart)
