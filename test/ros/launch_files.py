#!/usr/bin/env python3
"""What the launch files give to the nodes: all the same robot. [ROB-1]"""
import glob
import math
import os
import shutil
import sys
import tempfile
import unittest
from unittest import mock

import rospkg
import roslaunch.config
import rostest
import yaml
from PIL import Image

ROOT = rospkg.RosPack().get_path('frontier_pilot')
sys.path.insert(0, ROOT + '/scripts')
import robot_starts  # noqa: E402
import robots_launcher  # noqa: E402

FILES = sorted(glob.glob(ROOT + '/launch/*.launch'))
# All the others know the robot.
NEEDS_NOTHING = {'rviz', 'fitted_rviz.py', 'bag_player.py', 'run_recorder', 'map_merger', 'fleet_stop', 'robots_launcher.py', 'waypoint_follower'}
OWN_ROBOT = {'turtlebot2.launch', 'turtlebot3.launch'}  # their default need not be a Burger
TAKES_NAMES = {'navigation.launch', 'mapper_explorer.launch', 'operator.launch', 'gui_turtlebot_system.launch',
               'real_robot.launch', 'check_robot.launch'}
HAS_A_MAPPER = {name + '.launch' for name in ('navigation', 'system', 'robot', 'robots', 'real_robot', 'turtlebot2',
                                               'turtlebot3', 'play')}
NEEDS_MAP_FRAME = {'mapper', 'navigator', 'frontier_explorer', 'check_robot'}
PLACES_BEAMS = {'mapper', 'navigator', 'obstacle_avoider', 'behavior_server', 'patrol_server'}
LDS_01 = {'scanner/time_increment': 0.000556, 'scanner/reversed': True}
OBEYS_NO_LIMITS = {'rviz', 'fitted_rviz.py', 'bag_player.py', 'run_recorder', 'map_merger', 'fleet_stop', 'robots_launcher.py', 'check_robot', 'mapper', 'obstacle_avoider',
                   'waypoint_follower'}


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
    def config(self, file, **arguments):
        if os.path.basename(file) == 'robot.launch':
            arguments['name'] = 'robot1'
        if os.path.basename(file) == 'play.launch':
            arguments['bag'] = 'drive.bag'
        words = ['%s:=%s' % item for item in arguments.items()]
        files = [(file, words)]
        if os.path.basename(file) == 'robots.launch':
            files += self.launched_by(roslaunch.config.load_config_default(files, None, verbose=False, assign_machines=False))
        return roslaunch.config.load_config_default(files, None, verbose=False, assign_machines=False)

    def launched_by(self, config):
        """What robots_launcher.py starts."""
        launcher, = (node for node in config.nodes if node.type == 'robots_launcher.py')
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        prefix = launcher.namespace + launcher.name + '/'
        given = {name[len(prefix):]: param.value for name, param in config.params.items() if name.startswith(prefix)}
        return robots_launcher.launches(robots_launcher.arguments_in(given), folder)

    def remaps(self, name, **arguments):
        return {node.name: dict(node.remap_args) for node in self.config(ROOT + '/launch/' + name, **arguments).nodes}

    def load(self, file, **arguments):
        """What each node of `file` is given, by its name."""
        config = self.config(file, **arguments)
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
            prefixed = {'base_frame': 'robot1/base_footprint', 'odom_frame': 'robot1/odom'}
            if of_the_robot.get('odom_frame', '').startswith('robot2/'):
                prefixed = {key: value.replace('robot1', 'robot2') for key, value in prefixed.items()}
            has_a_prefix = os.path.basename(file) in ('robot.launch', 'robots.launch') and type_name != 'simulator'
            own = dict(prefixed) if has_a_prefix else {}
            is_turtlebot3 = arguments.get('robot', 'burger') in ('burger', 'waffle')
            if os.path.basename(file) == 'turtlebot3.launch' and is_turtlebot3 and type_name in PLACES_BEAMS:
                own = LDS_01
            if os.path.basename(file) == 'play.launch':
                own = {'odometry': 'topic', 'odom_frame': 'odom', 'base_frame': 'base_footprint'}  # the player's
            self.assertEqual(of_the_robot, dict(expected, **own), file + ' ' + name)

    def test_the_mapper_of_a_recorded_drive_takes_the_names_that_the_player_gives(self):
        """[ROB-1]"""
        foreign = ROOT + '/test/system/foreign_robot.yaml'
        with open(foreign) as file:
            robot_of_the_file = yaml.safe_load(file)
        self.assertNotEqual(robot_of_the_file.get('odom_frame', 'odom'), 'odom')
        params = {name: param.value for name, param in self.config(ROOT + '/launch/play.launch', robot=foreign, base_frame='base').params.items()}
        self.assertEqual([params['/mapper/robot/' + name] for name in ('odometry', 'odom_frame', 'base_frame')], ['topic', 'odom', 'base'])

    def test_every_node_of_every_launch_file_is_given_the_robot(self):
        """[ROB-1]"""
        for file in FILES:
            self.expect_robot(file, robot('waffle'), robot='waffle')

    def test_one_of_several_turtlebot3_is_told_of_its_scanner(self):
        """[ROB-1] [ROB-2]"""
        given = self.load(ROOT + '/launch/robot.launch', scanner='LDS-01')
        for name, (type_name, parameters) in given.items():
            if type_name in PLACES_BEAMS:
                self.assertEqual(LDS_01, {key: parameters.get('robot/' + key) for key in LDS_01}, name)

    def test_each_robot_that_the_package_ships_can_be_named(self):
        """[ROB-1]"""
        for name in ('burger', 'turtlebot2', 'fast'):
            self.expect_robot(ROOT + '/launch/system.launch', robot(name), robot=name)

    def test_a_burger_is_the_default(self):
        """[ROB-1]"""
        for file in FILES:
            if os.path.basename(file) not in OWN_ROBOT:
                self.expect_robot(file, robot('burger'))

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
            if os.path.basename(file) == 'play.launch':
                continue  # nothing in it drives, or reckons with how fast the robot drives
            for name, (type_name, given) in self.load(file, robot='waffle', limits='fast').items():
                limits = {key[len('limits/'):]: value for key, value in given.items() if key.startswith('limits/')}
                self.assertEqual(limits, {} if type_name in OBEYS_NO_LIMITS else expected, file + ' ' + name)

    def test_names_of_a_foreign_robot_reach_every_node_that_needs_them(self):
        """[ROB-2]"""
        names = {'odom': 'tf', 'base_frame': 'base_link', 'odom_frame': 'wheels', 'map_frame': 'floor'}
        for file in FILES:
            if os.path.basename(file) not in TAKES_NAMES:
                continue
            for name, (type_name, given) in self.load(file, robot='waffle', **names).items():
                if type_name in NEEDS_NOTHING:
                    continue
                self.assertEqual((given['robot/base_frame'], given['robot/odom_frame'], given['robot/odometry']),
                                 ('base_link', 'wheels', 'tf'), file + ' ' + name)
                self.assertEqual(given.get('map_frame'), 'floor' if type_name in NEEDS_MAP_FRAME else None, name)
            for type_name, given in self.load(file, robot='waffle', base_frame='7', odom_frame='8').values():
                if type_name not in NEEDS_NOTHING:
                    self.assertEqual((given['robot/base_frame'], given['robot/odom_frame']), ('7', '8'), file)

    def test_topics_of_a_foreign_robot_replace_ours(self):
        """[ROB-2]"""
        remaps = self.remaps('real_robot.launch', scan='/base_scan', odom='/wheels/odom', cmd_vel='/drive')
        for node in ('mapper', 'navigator', 'obstacle_avoider', 'teleop_gui', 'behavior_server'):
            self.assertEqual(remaps[node]['scan'], '/base_scan', node)
        for node in ('mapper', 'navigator', 'frontier_explorer', 'patrol_server'):
            self.assertEqual(remaps[node]['odom'], '/wheels/odom', node)
        for node in ('cmd_vel_arbiter', 'teleop_gui'):
            self.assertEqual(remaps[node]['cmd_vel'], '/drive', node)

    def test_a_turtlebot_is_driven_by_the_names_of_its_own_packages(self):
        """[ROB-2]"""
        for model, description in (('burger', 'burger'), ('waffle', 'waffle'), ('waffle_pi', 'waffle')):
            self.expect_robot(ROOT + '/launch/turtlebot3.launch', robot(description), model=model)
        self.expect_robot(ROOT + '/launch/turtlebot2.launch', robot('turtlebot2'))
        self.assertEqual(self.remaps('turtlebot2.launch')['cmd_vel_arbiter']['cmd_vel'], 'cmd_vel_mux/input/navi')
        for model in ('turtlebot2', 'turtlebot3'):
            config = self.config(ROOT + '/launch/%s.launch' % model)
            self.assertIs(config.params['/use_sim_time'].value, False)
            self.assertNotIn('simulator', {node.type for node in config.nodes})

    def test_a_turtlebot3_with_another_scanner_believes_its_driver(self):
        """[SCN-2]"""
        for name, (_, given) in self.load(ROOT + '/launch/turtlebot3.launch', scanner='LDS-02').items():
            self.assertNotIn('robot/scanner/time_increment', given, name)
            self.assertNotIn('robot/scanner/reversed', given, name)

    def test_the_range_of_the_scanner_is_that_of_the_robot_unless_another_one_is_given(self):
        """[ROB-1]"""
        launch = ROOT + '/launch/turtlebot3.launch'
        self.expect_robot(launch, robot('turtlebot2'), robot=ROOT + '/config/robots/turtlebot2.yaml')
        for sensor_range, expected in (('', 3.5), ('8.0', 8.0)):
            explorer, = (given for type_name, given in self.load(launch, sensor_range=sensor_range).values()
                         if type_name == 'frontier_explorer')
            self.assertEqual(explorer['robot/scanner/range_max'], expected)

    def test_rviz_shows_everything_in_the_frame_of_the_map(self):
        """[ROB-2]"""
        for name in ('real_robot', 'operator'):
            for given, frame in (({}, 'map'), ({'map_frame': 'floor'}, 'floor'), ({'map_frame': 5}, '5')):
                config = self.config(ROOT + '/launch/%s.launch' % name, **given)
                rviz, = (node for node in config.nodes if node.type == 'rviz')
                words = rviz.args.split()
                self.assertEqual(words[words.index('-f') + 1] if '-f' in words else self.fixed_frame(words), frame, name)

    def fixed_frame(self, words):
        with open(words[words.index('-d') + 1]) as file:
            return yaml.safe_load(file)['Visualization Manager']['Global Options']['Fixed Frame']

    def test_no_value_of_an_earlier_launch_stays_at_a_node(self):
        """[ROB-1]"""
        for file in FILES:
            config = self.config(file)
            ours = {node.namespace + node.name + '/' for node in config.nodes if node.package == 'frontier_pilot'}
            self.assertEqual(ours - set(config.clear_params), set(), file)

    def test_a_robot_that_is_not_there_is_named(self):
        """[ROB-1]"""
        with self.assertRaisesRegex(Exception, 'config/robots/wafle.yaml'):
            self.load(ROOT + '/launch/navigation.launch', robot='wafle')

    def test_a_saved_map_is_given_to_every_mapper(self):
        """[MAP-5]"""
        with_a_mapper = [path for path in FILES if 'mapper' in {kind for kind, _ in self.load(path).values()}]
        self.assertLessEqual(HAS_A_MAPPER, {os.path.basename(path) for path in with_a_mapper})
        for path in with_a_mapper:
            for word, expected in (('/maps/floor.yaml', '/maps/floor.yaml'),
                                   ('maps/floor', os.environ['PWD'] + '/maps/floor')):
                self.expect_map(path, (expected, True), map_file=word, localize_only='true')
            self.expect_map(path, ('', False))

    def test_any_number_of_robots_each_with_a_view_of_the_others_maps(self):
        """[MUL-1]"""
        for robots, names in (('3', ['robot1', 'robot2', 'robot3']), (ROOT + '/config/robots.yaml', ['robot1', 'robot2'])):
            config = self.config(ROOT + '/launch/robots.launch', robots=robots)
            remaps = {node.namespace + node.name: dict(node.remap_args) for node in config.nodes}
            for node in ('simulator', 'map_merger', 'fleet_stop'):
                listed = config.params['/%s/robots' % node].value
                self.assertEqual([robot['name'] for robot in listed], names)
            for name in names:
                for node in ('navigator', 'frontier_explorer'):
                    given = remaps['/%s/%s' % (name, node)]
                    self.assertEqual((given['map'], given['map_updates']), ('merged_map', 'merged_map_updates'), name)
                self.assertNotIn('map', remaps['/%s/mapper' % name])

    def robots_file(self, *robots):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        return robots_launcher.written(folder, 'robots.yaml', {'robots': [
            dict({'name': 'robot%d' % (i + 1), 'x': float(i), 'y': 0.0}, **robots[i]) for i in range(len(robots))]})

    def test_each_robot_of_the_list_may_be_of_its_own_kind(self):
        """[MUL-1] [ROB-1]"""
        own = self.robots_file() + '.mine.yaml'
        with open(own, 'w') as file:
            file.write('disc_radius: 0.3\n')
        listed = self.robots_file({}, {'robot': 'waffle'}, {'robot': own}, {'robot': 'waffle'})
        for limits in ('auto', 'burger'):
            given = self.load(ROOT + '/launch/robots.launch', robots=listed, robot='fast', limits=limits)
            simulator = given['/simulator/'][1]
            kinds = {kind['name']: kind for kind in simulator['kinds']}
            self.assertEqual([robot['robot'] for robot in simulator['robots']], ['', 'waffle', own, 'waffle'])
            self.assertEqual(flat(kinds['waffle']['robot']), robot('waffle'))
            self.assertEqual(kinds[own]['robot'], {'disc_radius': 0.3})
            self.assertEqual(kinds['waffle'].get('limits', {}).get('max_linear'), None if limits == 'auto' else 0.22)
            self.assertEqual(simulator['robot/limits/max_linear'], 0.5)
            for name, key, value in (('robot1', 'limits/max_linear', 0.5), ('robot2', 'limits/max_linear', 0.26),
                                     ('robot3', 'disc_radius', 0.3), ('robot4', 'limits/max_linear', 0.26)):
                self.assertEqual(given['/%s/navigator/' % name][1]['robot/' + key], value, name)

    def test_a_kind_that_is_not_there_is_named(self):
        """[MUL-1]"""
        with self.assertRaisesRegex(robots_launcher.StartsError, 'walker.yaml cannot be read'):
            self.config(ROOT + '/launch/robots.launch', robots=self.robots_file({}, {'robot': 'walker'}))

    def test_maps_that_begin_with_one_saved_map_are_in_one_frame(self):
        """[MUL-1]"""
        config = self.config(ROOT + '/launch/robots.launch', map_file='/maps/floor')
        self.assertEqual({(robot['x'], robot['y'], robot['yaw']) for robot in config.params['/map_merger/robots'].value},
                         {(0.0, 0.0, 0.0)})

    def test_rviz_shows_every_robot_of_the_list_in_a_colour_of_its_own(self):
        config = self.config(ROOT + '/launch/robots.launch', robots='5', rviz='true')
        rviz, = (node for node in config.nodes if node.type == 'rviz')
        with open(rviz.args.split()[1]) as file:
            displays = yaml.safe_load(file)['Visualization Manager']['Displays']
        groups = [display for display in displays if display['Class'] == 'rviz/Group']
        self.assertEqual([group['Name'] for group in groups], ['robot%d' % i for i in range(1, 6)])
        self.assertEqual(len({group['Displays'][0]['Color'] for group in groups}), 5)
        self.assertIn('/map', [display.get('Topic') for display in displays])

    def test_drawn_starts_are_apart_and_the_same_for_a_seed(self):
        for world in ('office', 'cave'):
            read = robot_starts.read_world(ROOT + '/config/worlds/%s.yaml' % world)
            starts = robot_starts.draw_starts(read, 6, 4)
            self.assertEqual(starts, robot_starts.draw_starts(read, 6, 4))
            self.assertNotEqual(starts, robot_starts.draw_starts(read, 6, 5))
            gaps = [math.dist((a['x'], a['y']), (b['x'], b['y'])) for a in starts for b in starts if a is not b]
            self.assertGreaterEqual(min(gaps), 0.8)
            self.assertLess(max(gaps), 4.0)

    def test_the_picture_of_the_world_is_read_once_and_only_for_what_needs_it(self):
        for robots, rviz, times in (('3', 'true', 1), ('3', 'false', 1), (ROOT + '/config/robots.yaml', 'false', 0)):
            with mock.patch('robot_starts.read_picture', wraps=robot_starts.read_picture) as read:
                self.config(ROOT + '/launch/robots.launch', robots=robots, rviz=rviz)
            self.assertEqual(read.call_count, times, (robots, rviz))

    def test_robots_that_cannot_be_started_are_named(self):
        for robots, why in (('0', 'from 1 to'), ('30', 'from 1 to'), ('/no/robots.yaml', '/no/robots.yaml')):
            with self.assertRaisesRegex(robots_launcher.StartsError, why):
                self.config(ROOT + '/launch/robots.launch', robots=robots)

    def test_a_list_of_robots_that_cannot_be_read_is_an_error_in_one_line(self):
        for text, why in (('robots: ' + '[' * 5000 + ']' * 5000, 'nested too deeply'), ('robots: [[]]', 'no list `robots`'),
                          ('robots: [{name: a, y: 0, x: 1%s}]' % ('0' * 400), 'no list `robots`'), ('robots: "\xff', 'cannot be read'),
                          ('robots: [{name: 5, x: 0, y: 0}]', 'instead of a text'), ('robots: [{name: /a/b, x: 0, y: 0}]', 'a name is'),
                          ('robots: [{name: fleet, x: 0, y: 0}]', "'fleet' cannot be a robot's name"),
                          ('robots: [{name: simulator, x: 0, y: 0}]', "'simulator' cannot be a robot's name"),
                          ('a: &a [1]\nrobots: [{name: *a, x: 0, y: 0}]', 'instead of a text'), ('#' * 1000001, 'more than')):
            with tempfile.NamedTemporaryFile('w', suffix='.yaml', encoding='latin-1') as file:
                file.write(text)
                file.flush()
                with self.assertRaisesRegex(robots_launcher.StartsError, why) as raised:
                    self.config(ROOT + '/launch/robots.launch', robots=file.name)
                self.assertNotIn('\n', str(raised.exception))

    def test_a_world_that_the_launcher_cannot_read_is_an_error_in_one_line(self):
        with tempfile.TemporaryDirectory() as folder:
            Image.new('L', (8001, 8000), 255).save(folder + '/large.png')
            Image.new('L', (200, 200), 255).save(folder + '/room.png')
            os.mkfifo(folder + '/pipe')
            with open(folder + '/room.png', 'rb') as whole, open(folder + '/broken.png', 'wb') as broken:
                content = bytearray(whole.read())
                content[content.index(b'IDAT') + 6] ^= 255
                broken.write(content[:-20])
            good = {'image': 'room.png', 'resolution': 0.05, 'origin': [0, 0, 0], 'negate': 0, 'occupied_thresh': 0.65, 'free_thresh': 0.196}
            for change in ({'start': [0]}, {'start': 'x'}, {'start': [math.nan, 0, 0]}, {'start': 7}, {'origin': 0}, {'resolution': 0}, {'image': 'large.png'},
                           {'image': 'pipe'}, {'image': 'broken.png'}, {'image': 3}, None):
                with open(folder + '/world.yaml', 'w') as file:
                    yaml.safe_dump(dict(good, **change) if change else [], file)
                with self.assertRaises(robots_launcher.StartsError, msg=change) as raised:
                    self.config(ROOT + '/launch/robots.launch', robots='3', world=folder + '/world.yaml')
                self.assertNotIn('\n', str(raised.exception))
            with self.assertRaisesRegex(robots_launcher.StartsError, 'no regular file'):
                self.config(ROOT + '/launch/robots.launch', robots=folder + '/pipe')

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
