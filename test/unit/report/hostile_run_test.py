"""A page is made whatever texts, numbers and kinds of messages a stranger has published on the topics of a run."""
import copy
import io
import itertools
import json
import struct
import unicodedata
import unittest
import warnings

import genpy
import rosbag
import rospy
from frontier_pilot.msg import AvoiderStatus, ExplorerStatus, FrontierStatus, PatrolActionResult, SpinActionResult
from std_msgs.msg import String

from folder_case import FolderCase
import synthetic_bag
from run_report import parameters
from run_report.bag_files import BagFiles
from run_report.page import page
from run_report.run import Run

TEXTS = ('$$', r'a $\frac{1$ \N{ b', '%s %d {0} {', '<!-- --></svg><script> " id="', '\0\x01\x1b[31m\x7f\x85\n\n\r\t', '\u202e\u2028\ufeff\ufffe',
         '_', '', '²', '१', '9' + 400 * '0', 5000 * '1', 5000 * 'W', 'recovering')
NUMBERS = (0, -1, 3, 255, 2**31 - 1, -2**31, 2**64 - 1, float('nan'), float('inf'), float('-inf'), 1e12, -1e6, 1e308, 5e-324)
# What some topics could carry besides our messages, under the names of their types.
OTHER_FORMS = (
    ('/cmd_vel_arbiter/status', 'frontier_pilot/ArbiterStatus', 'int32 state\nint32 active_source\nstring emergency_stop_cause\n'),
    ('/rosout', 'rosgraph_msgs/Log', 'byte level\nint32 name\nstring msg\n'),
    ('/diagnostics', 'diagnostic_msgs/DiagnosticArray', 'string[] status\n'),
    ('/frontier_explorer/status', 'frontier_pilot/ExplorerStatus', 'float64 explored_area\nfloat64 distance_travelled\n'
                                  'int32 state\nint32 goals_sent\nint32 goals_reached\nint32 goals_failed\nstring reason_text\n'),
    ('/odom', 'nav_msgs/Odometry', 'uint8[] child_frame_id\n'),
    ('/run_recorder/info', 'std_msgs/String', 'int32 data\n'), ('/run_recorder/info', 'std_msgs/String', 'string text\n'),
    ('/rosout', 'rosgraph_msgs/Log', "string A=x'''y\\\nstring msg\n"))


def samples():
    """(topic, message) of each kind that a report reads."""
    yield from itertools.chain(*(synthetic_bag.messages_at(second) for second in (5, 21, 31)))
    yield from synthetic_bag.first_messages()
    yield next(synthetic_bag.last_messages())
    yield '/obstacle_avoider/status', AvoiderStatus(state=AvoiderStatus.ROTATE)
    yield '/frontier_explorer/status', ExplorerStatus(goals_sent=1, frontiers=[FrontierStatus()])
    yield '/spin/result', SpinActionResult()
    yield '/turtlebot3/result', PatrolActionResult()


def fields(message):
    """(message, name) of each text and number that a message is made of, but for arrays of numbers."""
    for name in message.__slots__:
        value = getattr(message, name)
        if hasattr(value, '_type'):
            yield from fields(value)
        elif isinstance(value, list) and value and hasattr(value[0], '_type'):
            yield from itertools.chain(*map(fields, value))
        elif isinstance(value, (str, int, float)):
            yield message, name


def changed(message, value):
    """Copies of the message with this value in one of the fields that can hold it, and one with it in all of them."""
    of_all = copy.deepcopy(message)
    for index, field in enumerate(fields(of_all)):
        one = copy.deepcopy(message)
        if holds(one, list(fields(one))[index], value) and holds(of_all, field, value):
            yield one
    yield of_all


def holds(message, field, value):
    """Sets that field, and returns whether the message can be sent so."""
    part, name = field
    before = getattr(part, name)
    if isinstance(value, str) != isinstance(before, str):
        return False
    setattr(part, name, value)
    try:
        message.serialize(io.BytesIO())
    except (genpy.SerializationError, struct.error, OverflowError):
        setattr(part, name, before)
        return False
    return True


class HostileRun(FolderCase):
    def setUp(self):
        super().setUp()
        warnings.simplefilter('ignore')  # as the program does
        self.bag = self.path('run_0.bag')
        synthetic_bag.write(self.bag)

    def add(self, messages):
        """Adds (topic, message) to the bag, after the start of the run."""
        with rosbag.Bag(self.bag, 'a') as bag:
            for index, (topic, message) in enumerate(messages):
                bag.write(topic, message, rospy.Time.from_sec(synthetic_bag.BEGIN + 30.0 + 0.01 * index))

    def page(self, settings=()):
        run = Run()
        with BagFiles([self.bag]) as bags:
            run.read(bags)
        made = page(run, settings, True, [self.bag])
        self.assertIn('</html>', made)
        made.encode('utf-8', 'replace')
        self.assertEqual({letter for letter in made if unicodedata.category(letter)[0] == 'C'} - {'\n'}, set())
        return run

    # [FLT-1]
    def test_any_text_and_any_number_in_any_field_of_any_message_gives_a_page(self):
        values = TEXTS + NUMBERS
        for some in (values[first:first + 7] for first in range(0, len(values), 7)):
            with self.subTest(values=[str(value)[:20] for value in some]):
                synthetic_bag.write(self.bag)
                self.add((topic, one) for value in some for topic, message in samples() if topic != '/run_recorder/info'
                         for one in changed(message, value))
                self.page()

    # [FLT-1]
    def test_any_name_and_any_value_of_a_parameter_gives_a_page(self):
        values = TEXTS + NUMBERS + (10**400, '\ud800', None, [], [[]], {}, [{}], {'': {}}, True)
        names = TEXTS + ('list[0]/x', 'list[%s]/x' % (5000 * '9'), 'list[९]/x', 'list[-1]/x')
        given = dict({name: 1 for name in names}, **{str(index): value for index, value in enumerate(values)})
        row = parameters.Described('double', '1, 2', '', '')
        tables = {'mapper': dict({name: row for name in given}, **{'list[i]/x': row})}
        for end in ({}, {'mapper': 7}, {'mapper': dict(given, x=[1])}):
            self.page(parameters.differing({'mapper': given, 'navigator': 7}, end, tables))

    # [FLT-1]
    def test_a_note_of_the_recorder_with_any_value_gives_a_page(self):
        good = json.loads(synthetic_bag.info('start').data)
        self.add(('/run_recorder/info', String(json.dumps(dict(good, **{key: value})))) for key in good
                 for value in TEXTS + NUMBERS + (10**400, '\ud800', None, [], {'navigator': {'robot': {'base_frame': [1]}}}))
        self.page()

    # [FLT-1]
    def test_a_message_of_another_form_than_ours_is_left_out_and_the_others_give_a_page(self):
        for topic, kind, definition in OTHER_FORMS:
            with self.subTest(kind=kind, definition=definition):
                synthetic_bag.write(self.bag)
                form = type('Form', (), {'_type': kind, '_md5sum': 'f' * 32, '_full_text': definition})
                with rosbag.Bag(self.bag, 'a') as bag:
                    bag.write(topic, (kind, b'\x04' + bytes(200), form._md5sum, (0, 0), form), rospy.Time(199), raw=True)
                rosbag.bag._message_types.clear()
                self.assertEqual(len(self.page().explorer), synthetic_bag.SECONDS)
                rosbag.bag._message_types.clear()


if __name__ == '__main__':
    unittest.main()
