#!/usr/bin/python3
"""The node bag_player: plays a recorded drive as if the robot drove now, for a mapper that follows the ROS clock.

It publishes the bag's scans, odometry and transforms, each when /clock reaches its stamp, whatever the time at which it was
recorded. A transform to the odometry frame, such as the `map -> odom` of another mapper, is left out.

Parameters: ~bag (file), ~scan and ~odom (topics; empty: it chooses), ~base_frame (base_footprint), ~odom_frame (odom),
~map_frame (map), ~mount ("x y yaw" of the scanner on the base, where the bag does not say it [m m rad]), ~speed (recorded over
real time), ~save_map (path; empty: none), ~stay (whether the clock goes on at the end, for rviz).
While the mapper is away, because it died and is started again, the clock stands still.
It plays nothing at a master where another node publishes /clock, scan or odom, in whatever namespace: a robot or a simulation.
Exit code: 0 when the bag was played to its end, 1 otherwise.
"""
import math
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))  # catkin starts this file by way of another one
from command_line import CommandLine, end_quietly_until_main, exit_with, printable, say  # noqa: E402

if __name__ == '__main__':
    end_quietly_until_main()

import rospy  # noqa: E402
from geometry_msgs.msg import TransformStamped  # noqa: E402
from nav_msgs.msg import Odometry  # noqa: E402
from nav_msgs.srv import GetMap  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from sensor_msgs.msg import LaserScan  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402

from bag_drive import LATCHED, LEAD_IN, Drive  # noqa: E402
from bag_mapper import BagMapper  # noqa: E402
from bag_topics import BagError, numbers_in, read_bag  # noqa: E402
import ros_program  # noqa: E402
from saved_maps import Saved, save_map  # noqa: E402

PERIOD = 0.01  # between two looks at the clock [s]
LONGEST_STEP = 0.1  # of real time [s]: a player that was held up does not let the clock jump
PATIENCE = 30.0  # for the mapper to subscribe [s]
OTHERS_FIRST = 5.0  # for the mapper, once somebody listens, such as rviz [s]
MOST_SPEED = 1000.0
OF_A_ROBOT = ('clock', 'scan', 'odom')  # the last words of topics that are played, and that a robot or a simulation publishes as well
LONGEST_NAME = 250  # of a map [bytes], without .yaml
SETTLING = 5.0  # for which the clock goes on at the end, so that the mapper can finish [s]


def speed_in(text):
    """How much faster than real time the bag is to be played."""
    speed, = numbers_in(text, 1, 'speed', '2')
    if not 0.0 < speed <= MOST_SPEED:
        raise BagError('speed:=%s: the speed must be greater than 0 and at most %g' % (text, MOST_SPEED))
    return speed


def require_writable(path):
    """Raises BagError if no map can be saved there: before the bag is played, which may take hours. Where a path that is not a whole
    one leads is known to the mapper alone."""
    folder, name = os.path.split(path)
    if not name or len(os.fsencode(name)) > LONGEST_NAME or printable(name) != name:
        raise BagError('save_map:=%s: that is not the name of a file' % path)
    if not os.path.isabs(path):
        return
    if not os.path.isdir(folder):
        raise BagError('save_map:=%s: there is no folder %s; make it first, or give another path' % (path, folder))
    if not os.access(folder, os.W_OK | os.X_OK):
        raise BagError('save_map:=%s: nothing can be written to its folder' % path)


def require_no_robot():
    """Raises BagError if another node publishes at this master what is played: the clock and the scans would be those of neither."""
    try:
        publishers = ros_program.master(rospy.get_name()).getSystemState()[0]
    except ros_program.FAILURES:
        return
    for topic, nodes in publishers:
        others = [node for node in nodes if node != rospy.get_name()] if topic.split('/')[-1] in OF_A_ROBOT else []
        for node in others:
            if ros_program.lives(node) is not False:
                raise BagError('%s publishes %s at this master, where a robot or a simulation runs: end it first, or play the bag at a '
                               'master of its own (export ROS_MASTER_URI=http://127.0.0.1:PORT)' % (node, topic))


class Player:
    """Publishes a drive on the clock."""

    def __init__(self, drive, speed):
        self.drive = drive
        self.speed = speed
        self.now = max(PERIOD, drive.entries[0][0] - LEAD_IN)  # a clock at 0 means that none runs
        self.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        self.scan = rospy.Publisher('scan', LaserScan, queue_size=100)
        self.odom = rospy.Publisher('odom', Odometry, queue_size=1000)
        self.tf = rospy.Publisher('/tf', TFMessage, queue_size=1000)
        self.tf_static = rospy.Publisher(LATCHED, TFMessage, queue_size=1, latch=True)
        self.last_pose = None  # of odometry from transforms
        self.played = {'scan': 0, 'odom': 0, 'tf': 0, 'tf_of_odom': 0}
        self.mapper = BagMapper(self.played, self.clock, self.scan, self.odom)

    def tick(self, seconds):
        """Lets the clock go on by recorded `seconds`."""
        self.now += seconds
        ros_program.publish(self.clock, Clock(rospy.Time.from_sec(self.now)))

    def run_until(self, end, each=None):
        """Lets the clock run to `end`, but not while the mapper is away; `each` is called at every step. False when the node was shut
        down, or the mapper stays away."""
        last = time.monotonic()
        while self.now < end and not rospy.is_shutdown() and not self.mapper.is_lost():
            time.sleep(PERIOD)
            now = time.monotonic()
            self.tick(0.0 if self.mapper.is_away() else self.speed * min(now - last, LONGEST_STEP))
            last = now
            if each is not None:
                each()
        return not rospy.is_shutdown() and not self.mapper.is_lost()

    def await_mapper(self):
        ros_program.publish(self.tf_static, TFMessage(list(self.drive.fixed.values())))
        end = time.monotonic() + PATIENCE
        somebody_listens = False
        while time.monotonic() < end and not rospy.is_shutdown():
            self.tick(0.0)
            if self.mapper.find():
                return
            if self.scan.get_num_connections() > 0 and self.odom.get_num_connections() > 0:
                somebody_listens = True
                end = min(end, time.monotonic() + OTHERS_FIRST)
            time.sleep(10.0 * PERIOD)
        if not somebody_listens:
            rospy.logwarn('nobody listens to scan and odom; the bag is played all the same')

    def play(self):
        """Gives whether it came to the end of the bag."""
        def publish_due():
            for entry in self.drive.due_until(self.now):
                self.publish(*entry)
            self.now = self.drive.time_after(self.now)
        return self.run_until(self.drive.entries[-1][0] + PERIOD, publish_due)

    def publish(self, stamp, _, kind, content):
        self.played[kind] += 1
        if kind == 'tf':
            content.header.stamp = rospy.Time.from_sec(stamp)
            ros_program.publish(self.tf, TFMessage([content]))
        elif kind == 'scan':
            message = content[0].message(content[1])
            message.header.frame_id = self.drive.frame(message.header.frame_id)
            if message.header.stamp.is_zero():
                message.header.stamp = rospy.Time.from_sec(stamp)
            ros_program.publish(self.scan, message)
        elif kind == 'odom':
            ros_program.publish(self.odom, self.odometry_of(stamp, content))
        else:
            ros_program.publish(self.tf, TFMessage([transform_of(self.odometry_of(stamp, content))]))

    def odometry_of(self, stamp, content):
        if isinstance(content, TransformStamped):
            message = self.odometry_from(content)
        else:
            message = content[0].message(content[1])
        message.header.stamp = rospy.Time.from_sec(stamp)
        message.header.frame_id = self.drive.options['odom_frame']
        message.child_frame_id = self.drive.base
        return message

    @staticmethod
    def odometry_from(transform):
        message = Odometry()
        position = transform.transform.translation
        message.pose.pose.position.x, message.pose.pose.position.y = position.x, position.y
        message.pose.pose.orientation = transform.transform.rotation
        return message


def transform_of(odometry):
    transform = TransformStamped()
    transform.header = odometry.header
    transform.child_frame_id = odometry.child_frame_id
    position = odometry.pose.pose.position
    transform.transform.translation.x, transform.transform.translation.y = position.x, position.y
    transform.transform.rotation = odometry.pose.pose.orientation
    return transform


def say_what_was_mapped(drive, player):
    seconds = drive.entries[-1][0] - drive.entries[0][0]
    played = '%d scans of %.0f s' % (player.played['scan'], seconds)
    try:
        grid = rospy.ServiceProxy('dynamic_map', GetMap)().map
    except rospy.ServiceException:
        return rospy.logerr('end of the bag: %s played, and there is no map', played)
    area = sum(1 for value in grid.data if 0 <= value < 50) * grid.info.resolution ** 2
    rospy.loginfo('end of the bag: %s played; the map is %.1f m x %.1f m, %.1f m2 of it known to be free', played,
                  grid.info.width * grid.info.resolution, grid.info.height * grid.info.resolution, area)


def main():
    CommandLine(__doc__, 'rosrun frontier_pilot bag_player.py _bag:=/path/drive.bag _speed:=2').parse_args(rospy.myargv()[1:])
    os.environ.setdefault('ROSCONSOLE_FORMAT', '[${severity}] [${time}] [${node}]: ${message}')  # as the other nodes of the launch
    ros_program.begin('bag_player')
    if not rospy.get_param('~bag', ''):
        say('bag_player: which bag? _bag:=/path/drive.bag', sys.stderr)
        return 2
    defaults = {'scan': '', 'odom': '', 'base_frame': 'base_footprint', 'odom_frame': 'odom', 'map_frame': 'map', 'mount': ''}
    options = {name: str(rospy.get_param('~' + name, default)) for name, default in defaults.items()}
    path = str(rospy.get_param('~save_map', ''))
    try:
        require_no_robot()
        if path:
            require_writable(path)
        speed = speed_in(rospy.get_param('~speed', 1.0))
        drive = Drive(*read_bag(rospy.get_param('~bag', '')), options)
    except BagError as error:
        rospy.logfatal('%s', printable(str(error)))
        return 1
    for words in drive.words:
        rospy.loginfo('%s', printable(words))
    player = Player(drive, speed)
    player.await_mapper()
    if not (player.play() and player.run_until(player.now + SETTLING * max(1.0, player.speed))):
        if player.mapper.is_lost():
            rospy.logfatal('the mapper ended and is not back: the rest of the bag is not played')
        if path:
            say('bag_player: ended before the end of the bag: no map is saved as %s' % path, sys.stderr)
        return 1
    say_what_was_mapped(drive, player)
    player.mapper.say_loss()
    player.mapper.leave()
    saved = save_map(path) is Saved.WHERE_ASKED if path else True
    if rospy.get_param('~stay', False):
        player.speed = 1.0
        player.run_until(math.inf)
    return 0 if saved else 1


if __name__ == '__main__':
    exit_with(main)
