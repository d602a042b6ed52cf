#!/usr/bin/env python3
"""What the launch files give to the nodes: all the same robot. [ROB-1]"""
import glob
import os
import unittest

import rospkg
import roslaunch.config
import rostest
import yaml

ROOT = rospkg.RosPack().get_path('frontier_pilot')
FILES = sorted(glob.glob(ROOT + '/launch/*.launch'))
NEEDS_NOTHING = {'rviz', 'bag_player.py'}  # all the others know the robot
OBEYS_NO_LIMITS = {'rviz', 'bag_player.py', 'mapper', 'frontier_explorer', 'obstacle_avoider'}


def flat(values, prefix=''):
    """The dictionary as roslaunch gives it to the parameter server: one entry per leaf."""
    out = {}
    for key, value in values.items():
        out.update(flat(value, prefix + key + '/') if isinstance(value, dict) else {prefix + key: value})
    return out


def robot(name):
    with open(ROOT + '/config/robots/' + name + '.yaml') as file:
        return flat(yaml.safe_load(file))


class LaunchFilesTest(unittest.TestCase):
    def load(self, file, **arguments):
        """What each node of `file` is given, by its name."""
        if os.path.basename(file) == 'robot.launch':
            arguments['name'] = 'robot1'
        if os.path.basename(file) == 'play.launch':
            arguments['bag'] = 'drive.bag'
        words = ['%s:=%s' % item for item in arguments.items()]
        config = roslaunch.config.load_config_default([(file, words)], None, verbose=False, assign_machines=False)
        given = {}
        for node in config.nodes:
            prefix = node.namespace + node.name + '/'
            given[prefix] = (node.type, {name[len(prefix):]: param.value for name, param in config.params.items()
                                         if name.startswith(prefix)})
        self.assertTrue(given, file)
        return given

    def expect_robot(self, file, expected, **arguments):
        for name, (type_name, given) in self.load(file, **arguments).items():
            if type_name in NEEDS_NOTHING:
                continue
            of_the_robot = {key[len('robot/'):]: value for key, value in given.items() if key.startswith('robot/')}
            self.assertEqual(of_the_robot, expected, file + ' ' + name)

    def test_every_node_of_every_launch_file_is_given_the_robot(self):
        """[ROB-1]"""
        for file in FILES:
            self.expect_robot(file, robot('waffle'), robot='waffle')

    def test_each_robot_that_the_package_ships_can_be_named(self):
        """[ROB-1]"""
        for name in ('burger', 'turtlebot2', 'fast'):
            self.expect_robot(ROOT + '/launch/system.launch', robot(name), robot=name)

    def test_a_burger_is_the_default_and_needs_no_parameters(self):
        """[ROB-1]"""
        for file in FILES:
            self.expect_robot(file, {})

    def test_a_robot_can_be_a_file_of_ones_own_also_relative_to_the_folder_one_stands_in(self):
        """[ROB-1]"""
        path = ROOT + '/config/robots/turtlebot2.yaml'
        relative = os.path.relpath(path, os.environ['PWD'])
        for word in (path, relative if '/' in relative else './' + relative):
            self.expect_robot(ROOT + '/launch/system.launch', robot('turtlebot2'), robot=word)

    def test_limits_override_those_of_the_robot(self):
        """[ROB-1]"""
        with open(ROOT + '/config/limits_fast.yaml') as file:
            expected = yaml.safe_load(file)
        for file in FILES:
            if os.path.basename(file) in ('mapper_explorer.launch', 'play.launch'):
                continue  # nothing in them drives
            for name, (type_name, given) in self.load(file, robot='waffle', limits='fast').items():
                limits = {key[len('limits/'):]: value for key, value in given.items() if key.startswith('limits/')}
                self.assertEqual(limits, {} if type_name in OBEYS_NO_LIMITS else expected, file + ' ' + name)

    def test_a_robot_that_is_not_there_is_named(self):
        """[ROB-1]"""
        with self.assertRaisesRegex(Exception, 'config/robots/wafle.yaml'):
            self.load(ROOT + '/launch/navigation.launch', robot='wafle')

    def test_a_saved_map_is_given_to_every_mapper(self):
        """[MAP-5]"""
        for file in ('navigation', 'system', 'robot', 'robots', 'play'):
            path = ROOT + '/launch/' + file + '.launch'
            for word, expected in (('/maps/floor.yaml', '/maps/floor.yaml'),
                                   ('maps/floor', os.environ['PWD'] + '/maps/floor')):
                self.expect_map(path, (expected, True), map_file=word, localize_only='true')
            self.expect_map(path, ('', False))

    def expect_map(self, file, expected, **arguments):
        mappers = [given for type_name, given in self.load(file, **arguments).values() if type_name == 'mapper']
        self.assertTrue(mappers, file)
        for given in mappers:
            self.assertEqual((given['map_file'], given['localize_only']), expected, file)

    def test_every_rviz_configuration_can_say_where_the_robot_is_and_where_it_is_to_go(self):
        """[MAP-5]"""
        for path in glob.glob(ROOT + '/rviz/*.rviz'):
            with open(path) as file:
                tools = yaml.safe_load(file)['Visualization Manager']['Tools']
            topics = {tool['Class']: tool.get('Topic', '') for tool in tools}
            self.assertEqual(os.path.basename(topics.get('rviz/SetInitialPose', '')), 'initialpose', path)
            self.assertEqual(os.path.basename(topics.get('rviz/SetGoal', '')), 'goal', path)


if __name__ == '__main__':
    rostest.rosrun('frontier_pilot', 'launch_files', LaunchFilesTest)
