#!/usr/bin/python3
"""Opens rviz with a view of the whole simulated world, in the frame of a map that begins where the robot does.

The world is known by simulator/world, and where the map begins by base_pose_ground_truth and odom. If they do not come within ten
seconds, or nothing can be written in ROS_HOME, rviz opens with the view that is in its configuration. Remappings and parameters are
passed on to rviz, whose exit code is that of this program.
"""
import collections
import math
import os
import queue
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))  # catkin starts this file by way of another one
from command_line import CommandLine, end_quietly_until_main, exit_with, say  # noqa: E402

if __name__ == '__main__':
    end_quietly_until_main()

import roslib.packages  # noqa: E402
import rospkg  # noqa: E402
import rospy  # noqa: E402
from nav_msgs.msg import OccupancyGrid, Odometry  # noqa: E402

import ros_program  # noqa: E402
from robots_rviz import view_of, write_configuration  # noqa: E402

PATIENCE = 10.0  # for each message [s]
World = collections.namedtuple('World', 'width height resolution origin')


def world_of(grid):
    """What view_of has to know of a world, from the simulator's picture of it."""
    info = grid.info
    return World(info.width, info.height, info.resolution, (info.origin.position.x, info.origin.position.y))


def pose_of(odometry):
    """x, y and yaw of a nav_msgs/Odometry."""
    pose = odometry.pose.pose
    return pose.position.x, pose.position.y, 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)


def beginning_of(truth, driven):
    """Where in the world the map begins: with the robot at `truth` after odometry has counted `driven`."""
    yaw = truth[2] - driven[2]
    cosine, sine = math.cos(yaw), math.sin(yaw)
    return {'x': truth[0] - cosine * driven[0] + sine * driven[1], 'y': truth[1] - sine * driven[0] - cosine * driven[1], 'yaw': yaw}


def poses_of_one_moment():
    """Where the robot is in the world, and where odometry has it, at the same time. rospy.ROSException if that is not heard."""
    heard, pairs = {}, queue.Queue()

    def take(message, topic):
        others = heard.setdefault(message.header.stamp, {})
        others[topic] = message
        if len(others) == 2:
            pairs.put(others)
    topics = 'base_pose_ground_truth', 'odom'
    subscribers = [rospy.Subscriber(topic, Odometry, take, callback_args=topic) for topic in topics]
    try:
        pair = pairs.get(timeout=PATIENCE)
    except queue.Empty:
        raise rospy.ROSException('no %s and %s of one moment came' % topics) from None
    finally:
        for subscriber in subscribers:
            subscriber.unregister()
    return [pose_of(pair[topic]) for topic in topics]


def fitted(configuration):
    """The path of this configuration with a view of the whole world."""
    ros_program.begin('fitted_rviz', argv=[], anonymous=True, disable_rosout=True)
    world = world_of(rospy.wait_for_message('simulator/world', OccupancyGrid, PATIENCE))
    truth, driven = poses_of_one_moment()
    path = os.path.join(rospkg.get_ros_home(), 'frontier_pilot', 'fitted.rviz')
    os.makedirs(os.path.dirname(path), exist_ok=True)
    part = '%s.%d' % (path, os.getpid())
    try:
        write_configuration(configuration, part, [], view_of(world, beginning_of(truth, driven)))
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)
    return path


def main():
    parser = CommandLine(__doc__, 'rosrun frontier_pilot fitted_rviz.py -d $(rospack find frontier_pilot)/rviz/explorer.rviz')
    parser.add_argument('-d', dest='configuration', required=True, help="rviz's configuration, whose view is fitted")
    parser.add_argument('-f', dest='frame', help='the fixed frame, in place of the one in the configuration')
    arguments = parser.parse_args(rospy.myargv()[1:])
    configuration = arguments.configuration
    try:
        configuration = fitted(configuration)
    except rospy.ROSInterruptException:
        return 130
    except (OSError, rospy.ROSException) as error:
        say('fitted_rviz.py: the view is not fitted to the world: %s' % error, sys.stderr)
    rospy.signal_shutdown('rviz takes its place')
    rviz = roslib.packages.find_node('rviz', 'rviz')
    if not rviz:
        say('fitted_rviz.py: rviz is not installed', sys.stderr)
        return 1
    frame = ['-f', arguments.frame] if arguments.frame else []
    os.execv(rviz[0], [rviz[0], '-d', configuration] + frame + [word for word in sys.argv[1:] if ':=' in word])


if __name__ == '__main__':
    exit_with(main)
