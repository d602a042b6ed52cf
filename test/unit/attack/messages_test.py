#!/usr/bin/env python3
"""The messages of the fuzzer."""
import math
import pathlib
import sys
import unittest

import genpy.dynamic
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
from run_attack.messages import RANGES, Generator, holds_field, serialised, set_field  # noqa: E402

PLAIN = sorted(RANGES) + ['bool', 'float32', 'float64', 'string', 'time', 'duration']
DEFINITION = '\n'.join('%s %s_value\n%s[] %s_list\n%s[3] %s_three' % ((kind,) * 6) for kind in PLAIN)
Everything = genpy.dynamic.generate_dynamic('attack_test/Everything', DEFINITION)['attack_test/Everything']


class Messages(unittest.TestCase):
    def test_every_type_of_field_is_filled_with_values_that_can_be_sent(self):
        generator, seen = Generator(1), set()
        self.assertEqual(len(PLAIN), 16)
        for _ in range(300):
            message = generator.message(Everything)
            data = serialised(message)
            self.assertEqual(serialised(Everything().deserialize(data)), data)
            seen |= {name for name in message.__slots__ if getattr(message, name) != getattr(Everything(), name)}
        self.assertEqual(seen, set(Everything.__slots__), 'no field keeps its default')

    def test_the_same_seed_makes_the_same_messages_and_another_one_makes_others(self):
        def series(seed):
            generator = Generator(seed)
            return [serialised(generator.message(kind)) for kind in (Everything, LaserScan, TFMessage) for _ in range(50)]
        self.assertEqual(series(5), series(5))
        self.assertNotEqual(series(5), series(6))

    def test_extremes_occur(self):
        generator = Generator(2)
        floats = [generator.value('float32', True) for _ in range(300)]
        self.assertTrue(any(math.isnan(value) for value in floats) and math.inf in floats and -math.inf in floats)
        stamps = [generator.value('time', True).secs for _ in range(300)]
        self.assertTrue({0, 2 ** 32 - 1} <= set(stamps))
        lengths = {len(generator.value('float32[]', True)) for _ in range(300)}
        self.assertTrue({0, 20000} <= lengths and max(lengths) == 20000, lengths)
        words = {generator.value('string', True) for _ in range(300)}
        self.assertTrue(any('\x1b' in word for word in words) and '' in words)
        for kind, (least, most) in RANGES.items():
            values = {generator.value(kind, True) for _ in range(300)}
            self.assertTrue({least, most} <= values, kind)

    def test_plausible_messages_have_unit_quaternions_and_known_frames(self):
        generator = Generator(3, frames=('map', 'odom'))
        for _ in range(50):
            message = generator.fill(PoseStamped(), hostile=False)
            rotation = message.pose.orientation
            self.assertAlmostEqual(rotation.z ** 2 + rotation.w ** 2, 1.0)
            self.assertIn(message.header.frame_id, ('map', 'odom'))

    def test_a_mutation_of_a_recorded_message_keeps_most_of_it(self):
        grid = OccupancyGrid()
        grid.info.width = grid.info.height = 10
        grid.info.resolution = 0.05
        grid.data = [0] * 100
        generator = Generator(4, samples={OccupancyGrid._type: [serialised(grid)]})
        made = [generator.message(OccupancyGrid) for _ in range(300)]
        kept = [message for message in made if message.info.width == 10 and len(message.data) == 100]
        self.assertGreater(len(kept), 100)
        self.assertTrue(any(serialised(message) != serialised(grid) for message in kept))

    def test_without_paths_no_string_leads_out_of_a_folder(self):
        generator = Generator(5, paths=False)
        for _ in range(500):
            word = generator.value('string', True)
            self.assertFalse('/' in word or '.' in word, word)

    def test_damaged_bytes_are_cut_off_or_changed_and_never_longer(self):
        data, generator = bytes(100), Generator(6)
        made = {generator.damaged(data) for _ in range(300)}
        self.assertTrue(any(len(each) < 100 for each in made) and any(len(each) == 100 and each != data for each in made))
        self.assertEqual(max(map(len, made)), 100)
        self.assertEqual(generator.damaged(b''), b'')

    def test_a_field_is_found_and_set_at_any_depth(self):
        self.assertTrue(holds_field(TFMessage, 'child_frame_id'))
        self.assertFalse(holds_field(TFMessage, 'ranges'))
        message = Generator(7).value('geometry_msgs/TransformStamped[]', False)
        whole = TFMessage(message or [Generator(8).value('geometry_msgs/TransformStamped', False)])
        set_field(whole, 'w', 7.0)
        self.assertTrue(all(each.transform.rotation.w == 7.0 for each in whole.transforms))


if __name__ == '__main__':
    unittest.main()
