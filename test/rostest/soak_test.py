#!/usr/bin/python3
"""The tool soak finds nothing wrong with twelve minutes of faults at random, stamps from zero and leaps of them included."""
import subprocess
import unittest

import rosnode
import rostest


class Soak(unittest.TestCase):
    def test_finds_nothing(self):
        find = ['catkin_find', '--first-only', '--libexec', 'multipath_localization', 'soak']
        soak = subprocess.check_output(find, universal_newlines=True).strip()
        run = subprocess.run([soak, '_hours:=0.2', '_seed:=3'],
                             stdout=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(len([line for line in run.stdout.splitlines() if 'MB' in line]), 1, run.stdout)
        self.assertIn('/localization', rosnode.get_node_names())


if __name__ == '__main__':
    rostest.rosrun('multipath_localization', 'soak', Soak)
