#!/usr/bin/python3
"""scripts/report: what stands on its page of a simulated run and of a robot's bag, and what it makes no page of."""
import json
import math
import pathlib
import re
import subprocess
import tempfile
import unittest

import browser
import recorded_run
import rosbag
import rospkg
import rostest
import yaml
from genpy.dynamic import generate_dynamic
from roslib.packages import find_node
from std_msgs.msg import String

PACKAGE = 'multipath_localization'
SCENARIO = pathlib.Path(rospkg.RosPack().get_path(PACKAGE)) / 'config/scenarios/street.yaml'


def run(program, *arguments):
    command = [find_node(PACKAGE, program)[0], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


def data_of(page):
    return json.loads(re.search(r'<script type="application/json" id="run">(.*?)</script>', page, re.S)[1])


def figures_of(page):
    """The table: {title: cells}."""
    rows = re.findall(r'<tr><th scope="row">(.*?)</th>(.*?)</tr>', page)
    return {title.strip(): re.findall(r'<td>(.*?)</td>', cells) for title, cells in rows}


class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / 'out.html'

    def page_of(self, file):
        done = run('report', file, self.out)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, '', ''))
        return self.out.read_text()

    def page_of_bag(self, **how):
        recorded_run.write_run(self.folder / 'run.bag', **how)
        return self.page_of(self.folder / 'run.bag')

    def simulated(self, *options):
        """The page of forty seconds in the street."""
        scenario = dict(yaml.safe_load(SCENARIO.read_text()), duration=40.0)
        (self.folder / 'short.yaml').write_text(yaml.safe_dump(scenario))
        done = run('evaluate', '--scenario', self.folder / 'short.yaml', '--report', self.out, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.out.read_text()

    def refused(self, file, *reasons):
        done = run('report', file, self.out)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertFalse(self.out.exists())
        self.assertNotIn('Traceback', done.stderr)
        for reason in reasons:
            self.assertIn(reason, done.stderr)

    def refused_trace(self, trace, *reasons):
        (self.folder / 'trace.json').write_text(trace if isinstance(trace, str) else json.dumps(trace))
        self.refused(self.folder / 'trace.json', *reasons)

    def refused_bag(self, change, *reasons):
        recorded_run.write_run(self.folder / 'run.bag', change=change)
        self.refused(self.folder / 'run.bag', *reasons)

    def test_a_simulated_run_has_all_there_is_to_see(self):
        page = self.simulated('--estimators', 'multipath_particle_filter,gated_ekf')
        data, figures = data_of(page), figures_of(page)
        self.assertEqual([run['name'] for run in data['runs']], ['multipath_particle_filter', 'gated_ekf'])
        self.assertEqual(len(data['streams']), 2, 'each estimator steered another way')
        for run_of_page, stream in zip(data['runs'], data['streams']):
            for key in ('error', 'sigma3', 'state'):
                self.assertEqual(len(run_of_page[key]), len(run_of_page['t']))
            self.assertGreater(len(run_of_page['nis']['t']), 50)
            self.assertGreater(len(stream['truth']['t']), 300)
            self.assertGreater(len(stream['fixes']['t']), 50)
            self.assertTrue(any(speed > 0.5 for speed in stream['odometry']['speed']))
        shown = max(error for error in data['runs'][0]['error'])
        self.assertAlmostEqual(shown, float(figures['Largest error [m]'][1]), delta=0.01)
        self.assertNotRegex(page, r'(src|href)=|https?://|@import|url\(', 'the page wants nothing else')

    def test_titles_are_text(self):
        page = self.simulated('--estimators', '<b>&</script>=gated_ekf')
        self.assertEqual(data_of(page)['runs'][0]['name'], '<b>&</script>')
        self.assertNotIn('<b>&', page)

    def test_a_bag_without_truth_tells_how_far_fixes_lay(self):
        page = self.page_of_bag()
        data, figures = data_of(page), figures_of(page)
        self.assertIsNone(data['streams'][0]['truth'])
        self.assertAlmostEqual(float(figures['Median distance to the fixes [m]'][0]), 1.5, delta=0.02)
        self.assertEqual(figures['Measurements of position used'], ['56 of 63'])
        self.assertAlmostEqual(float(figures['Time MULTIPATH [%]'][0]), 52.2, delta=0.5)
        self.assertNotIn('Root mean square error [m]', figures)
        self.assertIn('2020-09-13 12:26:40 UTC', page)

    def test_a_bag_with_truth_is_scored(self):
        page = self.page_of_bag(truth='map')
        figures = figures_of(page)
        self.assertEqual(figures['Root mean square error [m]'], ['2.00', '0.50'])
        self.assertEqual(figures['Longest time beyond its own 3 sigma [s]'], ['–', '0.0'])

    def test_truth_in_another_frame_is_left_out_and_named(self):
        page = self.page_of_bag(truth='utm')
        self.assertIn("Truth is in the frame &#x27;utm&#x27;", page)
        self.assertIsNone(data_of(page)['streams'][0]['truth'])

    def test_nodes_in_namespaces_are_runs_in_one_map(self):
        def elsewhere(_, topic, message):
            if topic == '/second/local_xy_origin':
                return recorded_run.origin_at(52.5 + 1.0 / 111267.0, 13.4)  # a metre to the north
            return message
        data = data_of(self.page_of_bag(spaces=('/first', '/second'), change=elsewhere))
        first, second = data['runs']
        self.assertEqual([first['name'], second['name']], ['first', 'second'])
        self.assertAlmostEqual(second['y'][100] - first['y'][100], 1.0, delta=0.01)
        self.assertAlmostEqual(second['x'][100] - first['x'][100], 0.0, delta=0.01)

    def test_what_is_missing_is_named(self):
        kept = ('/odometry/filtered_map',)
        page = self.page_of_bag(change=lambda _, topic, message: message if topic in kept else None)
        for topic in ('localization/state', 'localization/fix_report', 'odometry/gps'):
            self.assertIn(f'The recording has no {topic}', page)

    def test_a_bag_of_sensors_alone_is_refused_with_the_way_to_a_page(self):
        with rosbag.Bag(self.folder / 'run.bag', 'w') as bag:
            bag.write('/chatter', String('hello'))
        self.refused(self.folder / 'run.bag', 'no pose of localization_node', '/chatter', 'evaluate --bag')

    def test_a_damaged_bag_is_refused(self):
        (self.folder / 'run.bag').write_bytes(b'#ROSBAG V9.9\n' + bytes(range(256)) * 20)
        self.refused(self.folder / 'run.bag', 'cannot be read as a bag')

    def test_a_bag_that_was_not_closed_is_refused_with_the_remedy(self):
        recorded_run.write_run(self.folder / 'run.bag')
        whole = (self.folder / 'run.bag').read_bytes()
        (self.folder / 'run.bag').write_bytes(whole[:len(whole) // 2])
        self.refused(self.folder / 'run.bag', 'rosbag reindex')

    def test_messages_of_another_version_are_refused(self):
        name = 'multipath_localization/FixReport'
        other = generate_dynamic(name, 'bool accepted\n')[name]
        self.refused_bag(lambda step, topic, message: other() if topic == '/localization/fix_report' else message,
                         'another version', 'predicted_sigma')

    def test_poses_that_are_none_are_refused(self):
        def broken(step, topic, message):
            if topic == '/odometry/filtered_map' and step == 7:
                message.pose.pose.position.x = math.nan
            return message
        self.refused_bag(broken, 'localization_node, odometry/filtered_map', 'x 8 is nan')

    def test_covariances_that_are_none_are_refused(self):
        def broken(step, topic, message):
            if topic == '/odometry/filtered_map' and step == 7:
                message.pose.covariance[0] = -1.0
            return message
        self.refused_bag(broken, 'at 0.700 s the covariance')

    def test_times_that_jump_are_refused(self):
        for seconds, reason in ((-20.0, 'goes back'), (1e8, 'jumps')):
            def jump(step, topic, message, seconds=seconds):
                if topic == '/odometry/filtered_map' and step > 250:
                    message.header.stamp.secs += int(seconds)
                return message
            self.refused_bag(jump, f'time {reason}')

    def test_traces_that_are_none_are_refused(self):
        self.refused(self.folder / 'missing.json', 'No such file')
        self.refused_trace('', 'neither a bag nor JSON')
        self.refused_trace('[1, 2]', "no 'runs'")
        self.refused_trace({}, "no 'runs'")
        self.refused_trace({'title': 'none', 'runs': []}, 'no run of it has an estimate')
        columns = {'estimator': 'one', 't': [0.0, 1.0], 'x': [0.0, 1.0], 'y': [0.0, 1.0], 'yaw': [0.0, 0.0]}
        self.refused_trace({'runs': [dict(columns, y=[0.0])]}, 'run one', 'differ in length', 'y 1')
        self.refused_trace({'runs': [dict(columns, y=[0.0, math.nan])]}, 'run one: y 2 is nan')
        self.refused_trace({'runs': [dict(columns, t=[1.0, 0.0])]}, 'time goes back')
        self.refused_trace({'runs': [dict(columns, t=[0.0, 'x'])]}, 'run one: t 2 is x')
        self.refused_trace({'runs': [dict(columns, t=[0.0, 10 ** 400])]}, 'run one: t 2 is 1000')
        self.refused_trace({'runs': [columns]}, "run one has no 'covariance'")

    def test_without_two_files_it_says_how_it_is_used(self):
        done = run('report')
        self.assertEqual(done.returncode, 2)
        self.assertIn('usage: report', done.stderr)
        self.assertEqual(run('report', '--help').returncode, 0)

    def looked_at(self, charts):
        found, console = browser.used(self.out)
        self.assertEqual((console, found.get('errors')), ([], []))
        self.assertEqual(found['charts'], charts)
        self.assertEqual((set(found['drawn']), set(found['marked'])), ({True}, {True}))
        self.assertLess(found['window'][1] - found['window'][0], found['whole'][1] - found['whole'][0])
        return found

    @unittest.skipUnless(browser.BROWSER, 'no Chromium is installed')
    def test_a_browser_shows_a_simulated_run_without_errors(self):
        self.simulated('--estimators', 'multipath_particle_filter,gated_ekf')
        found = self.looked_at(['Position error', 'State', 'NIS', 'Heading error', 'Speed'])
        self.assertRegex(found['pointed'], r'\d\d\.\d s, truth.*multipath_particle_filter')

    @unittest.skipUnless(browser.BROWSER, 'no Chromium is installed')
    def test_a_browser_shows_a_bag_without_truth_without_errors(self):
        self.page_of_bag()
        found = self.looked_at(['Distance to the fixes', 'State', 'NIS', 'Speed'])
        self.assertRegex(found['pointed'], r'GOOD\s*1\.5')


if __name__ == '__main__':
    rostest.rosrun(PACKAGE, 'report', Report)
