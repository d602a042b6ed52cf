#!/usr/bin/env python3
"""scripts/fuzz sees what is a finding, and says what it was."""
import pathlib
import random
import re
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'scripts'))
from run_fuzz import bags, build, targets  # noqa: E402


class Bags(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def problem(self, script):
        """What is said of a map_log that does this; $3 is where the map belongs."""
        program = pathlib.Path(self.folder.name) / 'map_log'
        program.write_text('#!/bin/sh\n' + script + '\n')
        program.chmod(0o755)
        return bags.problem_of(program, pathlib.Path('broken.bag'), self.folder.name)

    # [FLT-1]
    def test_a_map_and_a_refusal_in_words_are_no_findings(self):
        self.assertIsNone(self.problem('touch $3.bt $3.yaml'))
        self.assertIsNone(self.problem('echo "map_log: broken.bag: is broken" >&2; exit 1'))

    # [FLT-1]
    def test_a_crash_a_silent_refusal_and_half_a_map_are_findings(self):
        self.assertIn('-6', self.problem('kill -ABRT $$'))
        self.assertIn('ended with 1', self.problem('exit 1'))
        self.assertIn('ended with 2', self.problem('echo "map_log: what?" >&2; exit 2'))
        self.assertIn('map.yaml', self.problem('touch $3.yaml; echo "map_log: no" >&2; exit 1'))
        self.assertIn('made no map', self.problem('exit 0'))

    def test_a_seed_breaks_a_bag_in_the_same_way_again(self):
        whole = bytes(range(256)) * 20 + b'op=chunk_pos='
        broken = [[bags.broken(whole, draw) for _ in range(50)] for draw in (random.Random(3), random.Random(3), random.Random(4))]
        self.assertEqual(broken[0], broken[1])
        self.assertNotEqual(broken[0], broken[2])
        self.assertGreater(sum(data != whole for data in broken[0]), 40)


class Targets(unittest.TestCase):
    def test_each_target_that_is_built_has_a_corpus_and_each_corpus_a_target(self):
        text = (ROOT / 'test/fuzz/CMakeLists.txt').read_text()
        built = re.findall(r'^ *fuzz_target\((\w+) ', text, re.MULTILINE)
        self.assertEqual(sorted(built + [targets.BAGS]), targets.names())

    def test_each_dictionary_belongs_to_a_target(self):
        for path in (ROOT / 'test/fuzz/dictionaries').iterdir():
            self.assertIn(path.stem, targets.names())

    # [FLT-1]
    def test_a_finding_is_kept_and_named(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(build, 'BUILD', pathlib.Path(folder)):
            build.program('octree').parent.mkdir()
            build.program('octree').write_text('#!/bin/sh\necho "does not hold: a refusal changes nothing" >&2\n'
                                               'touch %s/findings/octree-crash-1\nexit 77\n' % folder)
            build.program('octree').chmod(0o755)
            held, words = targets.fuzz('octree', 1.0, 1)
            self.assertFalse(held)
            self.assertIn('does not hold: a refusal changes nothing', words)
            self.assertIn('scripts/fuzz --replay %s/findings/octree-crash-1 octree' % folder, words)

    def test_the_reason_of_a_finding_is_the_first_line_that_gives_one(self):
        self.assertIn('out of bounds', targets.reason('#1 INITED\nx.cpp:3:4: runtime error: index 8 out of bounds\nSUMMARY: a\n'))
        self.assertEqual(targets.reason('does not hold: a cell is free\n==1== ERROR: deadly signal\n'), 'does not hold: a cell is free')
        self.assertIn('timeout', targets.reason('ALARM: working\nSUMMARY: libFuzzer: timeout\n'))

    def test_the_summary_has_the_speed_and_the_edges(self):
        log = '#9 DONE   cov: 361 ft: 12 corp: 1\nstat::number_of_executed_units: 99\nstat::average_exec_per_sec:     33\n'
        self.assertEqual(targets.summary(log), '99 inputs, 33 a second, 361 edges')


if __name__ == '__main__':
    unittest.main()
