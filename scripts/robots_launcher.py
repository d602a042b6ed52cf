#!/usr/bin/python3
"""Starts the robots of robots.launch: the simulator and map_merger, and robot.launch for each robot.

A launch file cannot repeat a part of itself for each entry of a list. This program is started by robots.launch, runs the other
launch files as roslaunch does, and ends them when it is ended or when roslaunch itself has died. The arguments of robots.launch are
its private parameters: words of its command line would be split at spaces and quotes.

Exit code: 0 when it was ended or the simulator has ended, 1 when it could not start: the reason is printed,
2 for wrong arguments.
"""
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))  # catkin starts this file by way of another one
from command_line import CommandLine, end_quietly_until_main, exit_with, say  # noqa: E402

if __name__ == '__main__':
    end_quietly_until_main()

import rosgraph  # noqa: E402
import roslaunch  # noqa: E402
import roslaunch.core  # noqa: E402
import rospkg  # noqa: E402
import yaml  # noqa: E402

import leftovers  # noqa: E402
from robot_starts import MOST_ROBOTS, StartsError, draw_starts, read_world, read_yaml, robot_name, text_of  # noqa: E402
from robots_rviz import view_of, write_configuration  # noqa: E402

ROOT = rospkg.RosPack().get_path('frontier_pilot')
OF_THE_WORLD = ('world', 'gui', 'known_starts', 'robot', 'limits', 'speed', 'seed', 'odom_noise')
OF_AN_ENTRY = ('name', 'x', 'y', 'yaw', 'robot')  # of a list of robots
OF_A_ROBOT = ('explore', 'limits', 'map_file', 'localize_only')
MARK = 'FRONTIER_PILOT_ROBOTS'  # in the environment of all that is started here
PATIENCE = (8.0, 2.0)  # for a node to end on SIGINT, and on SIGTERM [s]: together less than roslaunch gives to this program


def absolute(path):
    """A relative path starts where roslaunch was called."""
    return os.path.join(os.environ.get('PWD', '.'), path)


def world_file(world):
    """The path of a world's YAML. `world`: a path, or the name of a world in config/worlds."""
    return absolute(world) if '/' in world or '.' in world else '%s/config/worlds/%s.yaml' % (ROOT, world)


def whole_number(text):
    """The number that is written with at most ten digits; None if the text is anything else, such as a path."""
    return int(text) if re.fullmatch('[0-9]{1,10}', text) else None


def robots_of(arguments, world):
    """The list of the robots with their starts and kinds: of the file, or that many at free places of the World."""
    count, seed = (whole_number(arguments[name]) for name in ('robots', 'seed'))
    if count is None:
        return listed_robots(arguments['robots'], arguments['robot'])
    if seed is None:
        raise StartsError('seed:=%s is not a whole number of at most ten digits' % arguments['seed'])
    return [dict(start, robot=arguments['robot']) for start in draw_starts(world, count, seed)]


def listed_robots(path, kind):
    """The robots of a YAML file; `kind` is that of those for which it gives none."""
    listed = read_yaml(absolute(path))
    try:
        robots = [{'name': robot_name(entry['name']), 'x': float(entry['x']), 'y': float(entry['y']), 'yaw': float(entry.get('yaw', 0.0)),
                   'robot': text_of(entry.get('robot') or kind)} for entry in listed['robots']]
    except (AttributeError, KeyError, TypeError, ValueError, OverflowError) as error:
        raise StartsError('robots:=%s: no list `robots` of name, x, y, yaw: %s' % (path, error))
    unknown = sorted({str(key) for entry in listed['robots'] for key in entry} - set(OF_AN_ENTRY))
    if unknown:
        raise StartsError('robots:=%s: a robot has %s, which is none of %s' % (path, unknown[0], ', '.join(OF_AN_ENTRY)))
    if not 1 <= len(robots) <= MOST_ROBOTS:
        raise StartsError('robots:=%s: the list has %d robots, it may have from 1 to %d' % (path, len(robots), MOST_ROBOTS))
    twice = [robot['name'] for robot in robots if [other['name'] for other in robots].count(robot['name']) > 1]
    if twice:
        raise StartsError('robots:=%s: two robots are called %s' % (path, twice[0]))
    return robots


def kind_of(robot, limits):
    """A kind of robots as the simulator reads it. `robot`: a name in config/robots, or a path."""
    is_path = '/' in robot or robot.endswith('.yaml')
    kind = {'name': robot, 'robot': read_yaml(absolute(robot) if is_path else '%s/config/robots/%s.yaml' % (ROOT, robot)) or {}}
    if limits not in ('', 'auto'):
        kind['limits'] = read_yaml('%s/config/limits_%s.yaml' % (ROOT, limits)) or {}
    return kind


def written(folder, name, values):
    """The path of a YAML file with `values`."""
    path = os.path.join(folder, name)
    with open(path, 'w') as file:
        yaml.safe_dump(values, file)
    return path


def starts_of(robots, arguments):
    """What the simulator is told of the robots: their starts, and the kinds of those that differ from robot:=."""
    kinds = sorted({robot['robot'] for robot in robots} - {arguments['robot']})
    return {'robots': [dict(robot, robot=robot['robot'] if robot['robot'] in kinds else '') for robot in robots],
            'kinds': [kind_of(kind, arguments['limits']) for kind in kinds]}


def places_of(robots, arguments):
    """Where the robots' maps begin in a frame that they have in common: maps that begin with one saved map are all in its frame."""
    in_one_frame = arguments['map_file'] not in ('', 'none')
    return [{'name': robot['name'], **{key: 0.0 if in_one_frame else robot[key] for key in ('x', 'y', 'yaw')}} for robot in robots]


def launches(arguments, folder):
    """The launch files that are to run, each with its arguments; the files that they read are written into `folder`."""
    in_rviz = arguments['rviz'].lower() == 'true'
    # Its picture is large: it is read once, and only if it is asked for.
    world = read_world(world_file(arguments['world'])) if in_rviz or whole_number(arguments['robots']) is not None else None
    robots = robots_of(arguments, world)
    places = places_of(robots, arguments)
    words = {name: '%s:=%s' % (name, arguments[name]) for name in set(OF_THE_WORLD + OF_A_ROBOT)}
    of_world = [words[name] for name in OF_THE_WORLD]
    of_world += ['starts:=' + written(folder, 'starts.yaml', starts_of(robots, arguments)),
                 'places:=' + written(folder, 'places.yaml', {'robots': places})]
    trust = 'trust_odometry:=%s' % ('false' if arguments['odom_noise'].lower() == 'true' else 'true')
    files = [(ROOT + '/launch/robots_world.launch', of_world)]
    for robot in robots:
        own = ['name:=' + robot['name'], 'robot:=' + robot['robot'], trust] + [words[name] for name in OF_A_ROBOT]
        files.append((ROOT + '/launch/robot.launch', own))
    if in_rviz:
        shown = os.path.join(folder, 'robots.rviz')
        view = view_of(world, places[0])
        write_configuration(ROOT + '/rviz/robots.rviz', shown, [robot['name'] for robot in robots], view)
        files.append((ROOT + '/launch/robots_rviz.launch', ['configuration:=' + shown]))
    return files


def arguments_in(given):
    """The arguments of robots.launch among the private parameters of this program."""
    missing = sorted(set(OF_THE_WORLD + OF_A_ROBOT + ('robots', 'rviz')) - set(given))
    if missing:
        raise StartsError('its parameter %s is missing: robots.launch sets it' % missing[0])
    return {name: str(value) for name, value in given.items()}


def own_parameters(master):
    node = rosgraph.names.ns_join(rosgraph.names.get_ros_namespace(), 'robots_launcher')
    return master.getParam(node) if master.hasParam(node) else {}


def main():
    CommandLine(__doc__, 'roslaunch frontier_pilot robots.launch robots:=3').parse_args(rosgraph.myargv(sys.argv[1:]))
    leftovers.end_with_the_parent()  # which is roslaunch
    with tempfile.TemporaryDirectory() as folder:
        leftovers.end_after_this_process(MARK, folder, folder)
        os.environ[MARK] = folder
        try:
            master = rosgraph.Master('/robots_launcher')
            files = launches(arguments_in(own_parameters(master)), folder)
            parent = roslaunch.parent.ROSLaunchParent(master.getParam('/run_id'), files, is_core=False, show_summary=False,
                                                      sigint_timeout=PATIENCE[0], sigterm_timeout=PATIENCE[1])
            parent.start()
            parent.spin()  # rviz reads its file from the folder after it has started
        except ConnectionRefusedError:
            say('robots_launcher: no ROS master answers at %s: robots.launch starts one' % rosgraph.get_master_uri(), sys.stderr)
            return 1
        except (OSError, StartsError, rosgraph.MasterException, roslaunch.core.RLException) as error:
            say('robots_launcher: %s' % error, sys.stderr)
            return 1
        finally:
            # When the simulator ends while nodes are being started, roslaunch forgets those that come after.
            leftovers.end(MARK, folder)
    return 0


if __name__ == '__main__':
    exit_with(main)
