#!/usr/bin/python3
"""A recorded exploration, its report, and what a real browser makes of that. [REC-3]"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import unittest

import roslib.packages
import rosgraph
import rospy
import rostest
from std_msgs.msg import String
from std_srvs.srv import SetBool

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from system_watch import SystemWatch, pid_of, wait_until  # noqa: E402

LIMIT = 400.0  # seconds of wall time
PLOTS = {'map', 'area', 'drivers', 'load'}


def browse(page, *words):
    """What the browser says of the page, as JSON; in a process of its own, which a browser is best ended with."""
    done = subprocess.run([sys.executable, str(ROOT / 'test/support/browser.py'), page, *words], stdout=subprocess.PIPE, timeout=300)
    return json.loads(done.stdout)


class Report(unittest.TestCase):
    def setUp(self):
        self.run = None
        rospy.Subscriber('run_recorder/info', String, self.on_info)

    def on_info(self, message):
        self.run = json.loads(message.data)['run']

    @staticmethod
    def rosbag_listens():
        """It subscribes to the topics in the order of their names."""
        listeners = dict(rosgraph.Master('/report_test').getSystemState()[1])
        return '/run_recorder_rosbag' in listeners.get('/wait/result', [])

    def record(self):
        """Explores, ends the recorder, and returns what was seen of the system."""
        watch = SystemWatch()
        self.assertTrue(wait_until(lambda: self.run and self.rosbag_listens(), 120.0), 'nothing is recorded')
        self.assertTrue(rospy.ServiceProxy('set_exploration_enabled', SetBool)(True).success)
        self.assertTrue(wait_until(watch.done, LIMIT), 'not done in time\n' + watch.describe())
        end = watch.time + 3.0  # so that the record holds the last status, which is sent once a second
        self.assertTrue(wait_until(lambda: watch.time > end, 60.0))
        os.kill(pid_of('/run_recorder'), signal.SIGINT)
        self.assertTrue(wait_until(lambda: pid_of('/run_recorder') is None and os.path.exists(self.run + '/run_0.bag'), 60.0))
        return watch

    def make_report(self):
        report = roslib.packages.find_node('frontier_pilot', 'report')[0]
        done = subprocess.run([report, self.run], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300,
                              universal_newlines=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.strip()

    def test_its_figures_are_those_of_the_explorer_and_a_browser_shows_all_of_it(self):
        watch = self.record()
        page = self.make_report()
        self.assertLess(os.path.getsize(page), 2e6)
        for words in ((), ('--width', '380', '--dark')):
            shown = browse(page, *words)
            self.assertEqual((shown['loaded'], shown['console'], shown['requests']), (True, [], []))
            self.assertLessEqual(shown['overflow'], 0, 'it is wider than the window')
            self.check_figures(shown['figures'], watch)
            self.assertLessEqual(PLOTS, {plot['name'] for plot in shown['plots'] if plot['width'] > 300 and plot['height'] > 40})
            self.assertEqual(len(shown['ids']), len(set(shown['ids'])), 'two elements have the same id')
            self.assertEqual(sorted(shown['images']), ['inline', 'none'], 'one map for each of the two colour schemes')
        for words in ('“small”', 'ended by itself', 'no contact', 'burger'):
            self.assertIn(words, shown['text'])
        self.assertIn('speed', shown['text'].split('Parameters that differ')[1])

    def check_figures(self, figures, watch):
        status = watch.status
        self.assertAlmostEqual(figures['explored_area'], status.explored_area, delta=0.2)
        self.assertAlmostEqual(figures['distance'], status.distance_travelled, delta=0.1)
        self.assertEqual((figures['goals'], figures['goals_reached'], figures['goals_failed']),
                         (status.goals_sent, status.goals_reached, status.goals_failed))
        self.assertEqual((figures['contacts'], figures['stops']), (watch.contacts, 0))


if __name__ == '__main__':
    rospy.init_node('report_test')
    rostest.rosrun('frontier_pilot', 'report', Report)
