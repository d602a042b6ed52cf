#!/usr/bin/env python3
"""The arguments of robots.launch, as robots_launcher.py reads them."""
import os
import pathlib
import sys
import tempfile
import unittest

import roslaunch.config
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / 'scripts'))
import robots_launcher  # noqa: E402
from robots_launcher import StartsError  # noqa: E402


def given(*words):
    """What robots.launch gives to the launcher for these arguments."""
    config = roslaunch.config.load_config_default([(str(ROOT / 'launch/robots.launch'), list(words))], None, verbose=False,
                                                  assign_machines=False)
    prefix = '/robots_launcher/'
    return robots_launcher.arguments_in({name[len(prefix):]: param.value for name, param in config.params.items()
                                         if name.startswith(prefix)})


class Arguments(unittest.TestCase):
    def test_a_path_arrives_as_it_was_given_whatever_is_in_it(self):
        """[FLT-1]"""
        for path in ("/home/o'brien/my floor.yaml", '/a/"b"\\c.yaml', '/a/#b $c.yaml', '1e3'):
            with self.subTest(path=path):
                self.assertEqual(given('world:=' + path, 'map_file:=' + path)['world'], path)
        self.assertTrue(given()['world'].endswith('/config/worlds/office.yaml'))

    def test_a_world_of_the_package_has_a_name(self):
        flat = str(ROOT / 'config/worlds/flat.yaml')
        self.assertEqual(robots_launcher.world_file('flat'), flat)
        self.assertEqual(robots_launcher.world_file('/flat'), '/flat')
        for file in ('simulator', 'robots_world'):
            for word, path in (('flat', flat), ('/a/flat', '/a/flat'), ('flat.yaml', os.environ['PWD'] + '/flat.yaml')):
                words = ['world:=' + word] + (['starts:=' + str(ROOT / 'config/robots.yaml')] if file == 'robots_world' else [])
                config = roslaunch.config.load_config_default([(str(ROOT / 'launch' / (file + '.launch')), words)], None,
                                                              verbose=False, assign_machines=False)
                self.assertEqual(config.params['/simulator/world'].value.replace('//', '/'), path)

    def test_an_argument_that_is_missing_is_named(self):
        with self.assertRaisesRegex(StartsError, 'parameter explore is missing'):
            robots_launcher.arguments_in({})

    def test_what_only_looks_like_a_number_is_a_path_or_refused(self):
        """[FLT-1]"""
        for text in ('²', '٣', '-1', '1_0', ' 3', '', '9' * 11, '9' * 5000):
            with self.subTest(text=text[:20]):
                self.assertIsNone(robots_launcher.whole_number(text))
                with self.assertRaises(StartsError):
                    robots_launcher.robots_of({'robots': text, 'robot': 'burger', 'seed': '1'}, None)
                with self.assertRaisesRegex(StartsError, '^seed:='):
                    robots_launcher.robots_of({'robots': '3', 'robot': 'burger', 'seed': text}, None)
        self.assertEqual(robots_launcher.whole_number('1000000000'), 1000000000)


class Lists(unittest.TestCase):
    def read(self, names, **more):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'robots.yaml')
            with open(path, 'w') as file:
                yaml.safe_dump({'robots': [dict(more, name=name, x=0, y=0) for name in names]}, file)
            return robots_launcher.listed_robots(path, 'burger')

    def test_a_list_has_no_more_robots_than_can_be_drawn(self):
        """[FLT-1]"""
        self.assertEqual(len(self.read('robot%d' % i for i in range(20))), 20)
        for count in (0, 21):
            with self.assertRaisesRegex(StartsError, 'the list has %d robots, it may have from 1 to 20' % count):
                self.read('robot%d' % i for i in range(count))

    def test_a_name_that_is_given_twice_is_refused(self):
        """[FLT-1]"""
        with self.assertRaisesRegex(StartsError, 'two robots are called scout'):
            self.read(['scout', 'carrier', 'scout'])

    def test_a_key_that_is_none_is_refused(self):
        """A robot of another kind than was meant would drive with the wrong outline. [FLT-1]"""
        self.assertEqual(self.read(['scout'], robot='waffle')[0]['robot'], 'waffle')
        with self.assertRaisesRegex(StartsError, 'a robot has robt, which is none of name, x, y, yaw, robot'):
            self.read(['scout'], robt='waffle')


if __name__ == '__main__':
    unittest.main()
