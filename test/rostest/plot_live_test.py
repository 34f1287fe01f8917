#!/usr/bin/python3
"""plot.launch: each topic it listens to changes the picture."""
import os
import time
import unittest

import matplotlib.image
import numpy
import rospy
import rostest

from multipath_localization.msg import FixReport, GnssBias, LocalizationState

STATE = LocalizationState(position_sigma=2.0, shadow_probability=0.5, dominance=1.0)
BIAS = GnssBias(x=3.0, y=-2.0, sigma=1.0)
REPORT = FixReport(innovation_x=1.0, innovation_y=-1.0, declared_sigma=0.3, predicted_sigma=0.5)


class PlotLiveTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("plot_live_test")
        cls.file = rospy.get_param("~file")

    def picture(self):
        """The next one that is whole, counted from now."""
        start, end = time.time(), time.time() + 20.0
        while time.time() < end:
            time.sleep(0.2)
            try:
                if os.path.getmtime(self.file) > start + 0.5:
                    return matplotlib.image.imread(self.file)
            except (OSError, SyntaxError, ValueError):
                continue  # not there yet, or half written
        self.fail("no picture")

    def changes(self, topic, message):
        publisher = rospy.Publisher(topic, type(message), queue_size=10)
        while publisher.get_num_connections() == 0:
            time.sleep(0.1)
        before = self.picture()
        for i in range(10):
            message.header.stamp = rospy.Time(1000 + i)
            publisher.publish(message)
            time.sleep(0.02)
        time.sleep(1.0)
        return not numpy.array_equal(before, self.picture())

    def test_draws_state_bias_and_fixes(self):
        self.assertTrue(self.changes("localization/state", STATE))
        self.assertTrue(self.changes("localization/bias", BIAS))
        self.assertTrue(self.changes("localization/fix_report", REPORT))


if __name__ == "__main__":
    rostest.rosrun("multipath_localization", "plot_live", PlotLiveTest)
