#!/usr/bin/env python3
"""The node bag_player: plays a recorded drive as if the robot drove now, for a mapper that follows the ROS clock.

It publishes the bag's scans, odometry and transforms, each when /clock reaches its stamp, whatever the time at which it was
recorded. A transform to the odometry frame, such as the `map -> odom` of another mapper, is left out.

Parameters: ~bag (file), ~scan and ~odom (topics; empty: it chooses), ~base_frame (base_footprint), ~odom_frame (odom),
~map_frame (map), ~mount ("x y yaw" of the scanner on the base, where the bag does not say it [m m rad]), ~speed (recorded over
real time), ~save_map (path; empty: none), ~stay (whether the clock goes on at the end, for rviz).
Exit code: 0 when the bag was played to its end, 1 otherwise.
"""
import math
import sys
import time

import rosbag
import rospy
from frontier_pilot.srv import SaveMap
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from nav_msgs.srv import GetMap
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

PERIOD = 0.01  # between two looks at the clock [s]
LONGEST_STEP = 0.1  # of real time [s]: a player that was held up does not let the clock jump
PATIENCE = 30.0  # for the mapper to subscribe [s]
SETTLING = 5.0  # for which the clock goes on at the end, so that the mapper can finish [s]
LEAST_HOLE = 2.0  # [s]
MOST_SKEW = 1.0  # [s] between the clocks of scans and odometry before they are aligned
LATCHED = '/tf_static'
SAMPLES = 50  # of a topic's scans, whose field of view is looked at
FEW = 0.1  # a topic with a smaller share of the most frequent one's messages is not chosen


class BagError(Exception):
    """What is wrong with a bag, or with how it is to be played."""


def bare(name):
    """A topic or frame without its leading slash."""
    return name.lstrip('/')


def median(values):
    return sorted(values)[len(values) // 2]


def degrees(scan):
    """A scan's field of view."""
    return math.degrees(abs(scan.angle_increment)) * max(0, len(scan.ranges) - 1)


def field_of_view(topic):
    """The widest field of view of a topic's first scans [deg]."""
    return max(degrees(topic.message(index)) for index in range(min(SAMPLES, len(topic.raw))))


def numbers_in(text, count, name, example):
    """The `count` finite numbers that an option consists of."""
    try:
        numbers = [float(word) for word in str(text).split()]
    except ValueError:
        numbers = []
    if len(numbers) != count or not all(math.isfinite(number) for number in numbers):
        raise BagError("%s:='%s' is not understood; an example: %s:='%s'" % (name, text, name, example))
    return numbers


def speed_in(text):
    """How much faster than real time the bag is to be played."""
    speed, = numbers_in(text, 1, 'speed', '2')
    if speed <= 0.0:
        raise BagError('speed:=%s: the speed must be greater than 0' % text)
    return speed


class Topic:
    """The messages of one topic of a bag, raw, with the times at which they were recorded [s]."""

    def __init__(self, name, message_class):
        self.name = name
        self.message_class = message_class
        self.raw = []

    def message(self, index):
        return self.message_class().deserialize(self.raw[index][1])

    def messages(self):
        for recorded, data in self.raw:
            yield recorded, self.message_class().deserialize(data)


def read_bag(path):
    """Topics of the types that are played, by type; and the names and types of all others."""
    classes = {'sensor_msgs/LaserScan': LaserScan, 'nav_msgs/Odometry': Odometry, 'tf2_msgs/TFMessage': TFMessage,
               'tf/tfMessage': TFMessage}
    topics, others = {}, {}
    try:
        with rosbag.Bag(path) as bag:
            # Raw, because the bag may hold types whose definition nobody has.
            for name, (kind, data, md5, *_), recorded in bag.read_messages(raw=True):
                message_class = classes.get(kind)
                if message_class is None or message_class._md5sum != md5:
                    others[name] = kind
                    continue
                topics.setdefault(name, Topic(name, message_class)).raw.append((recorded.to_sec(), data))
    except (rosbag.ROSBagException, OSError, ValueError) as error:
        raise BagError('%s: %s' % (path, error))
    return topics, others


def those_with_many_messages(topics):
    """The topics without those that have far fewer messages than another."""
    most = max(len(topic.raw) for topic in topics.values())
    return {name: topic for name, topic in topics.items() if len(topic.raw) >= FEW * most}


def choose_scan(topics, wanted):
    """The topic of the scans and why it was chosen."""
    scans = {name: topic for name, topic in topics.items() if topic.message_class is LaserScan}
    if not scans:
        raise BagError('no LaserScan topic')
    if wanted:
        return named(scans, wanted, 'LaserScan')
    often = those_with_many_messages(scans)
    fields = {name: field_of_view(topic) for name, topic in scans.items()}
    # map_log rounds in the same way, half a step up.
    best = max(often, key=lambda name: (math.floor(fields[name] / 10.0 + 0.5), bare(name) == 'scan', len(often[name].raw), name))
    why = 'scans from %s' % best
    if len(scans) > 1:
        left = ', '.join('%s (%.0f deg, %d scans)' % (name, fields[name], len(scans[name].raw))
                         for name in sorted(scans) if name != best)
        why += ': of %d LaserScan topics the widest field of view, %.0f deg, %d scans; not %s; scan:= chooses another' % (
            len(scans), fields[best], len(scans[best].raw), left)
    return scans[best], why


def choose_odometry(topics, wanted):
    """The topic of odometry and why it was chosen; no topic where the bag has none."""
    odometry = {name: topic for name, topic in topics.items() if topic.message_class is Odometry}
    if wanted:
        return named(odometry, wanted, 'Odometry')
    if not odometry:
        return None, 'no Odometry topic: odometry from the recorded transforms'
    often = those_with_many_messages(odometry)
    best = max(often, key=lambda name: (bare(name) == 'odom', len(often[name].raw), name))
    why = 'odometry from %s' % best
    if len(odometry) > 1:
        why += ', not %s; odom:= chooses another' % ', '.join(name for name in sorted(odometry) if name != best)
    return odometry[best], why


def named(topics, wanted, kind):
    for name, topic in topics.items():
        if bare(name) == bare(wanted):
            return topic, '%s from %s, as told' % ('scans' if kind == 'LaserScan' else 'odometry', name)
    raise BagError("no %s topic '%s'; there are: %s" % (kind, wanted, ', '.join(sorted(topics)) or 'none'))


def holes(stamps):
    """Begin and length of each stretch without a message, in a sorted list of stamps [s]."""
    gaps = [b - a for a, b in zip(stamps, stamps[1:])]
    least = max(LEAST_HOLE, 10.0 * median(gaps)) if gaps else LEAST_HOLE
    return [(begin, gap) for begin, gap in zip(stamps, gaps) if gap >= least]


class Drive:
    """What is played: messages by the stamp at which they are due, and what was noticed of the bag."""

    def __init__(self, topics, others, options):
        self.options = options
        self.words = []  # for the operator
        self.entries = []  # (stamp, order, kind, message)
        self.fixed = {}  # transforms that never change, by child frame
        self.scan, why = choose_scan(topics, options['scan'])
        self.words.append(why)
        self.odometry, why = choose_odometry(topics, options['odom'])
        self.words.append(why)
        if others:
            self.words.append('not played: %s' % ', '.join('%s (%s)' % item for item in sorted(others.items())))
        self.transforms = [topic for topic in topics.values() if topic.message_class is TFMessage]
        self.base = options['base_frame']
        self.lead = self.lead_of(self.scan)
        if self.lead is None:
            raise BagError('the scans have no stamps')
        if abs(self.lead) >= 1.0:
            self.words.append('stamps are %.1f s %s the time of recording: the clock follows the stamps' % (
                abs(self.lead), 'ahead of' if self.lead > 0.0 else 'behind'))
        self.take_transforms()
        self.take_odometry()
        self.take_scans()
        self.entries.sort(key=lambda entry: entry[:2])
        if not self.entries:
            raise BagError('nothing to play')

    @staticmethod
    def lead_of(topic):
        """How far the stamps of a topic are ahead of the times of recording [s]; none without stamps."""
        leads = [message.header.stamp.to_sec() - recorded for recorded, message in topic.messages()
                 if not message.header.stamp.is_zero()]
        return median(leads) if leads else None

    def due(self, header, recorded, skew=0.0):
        """When a message is to be played, by its stamp [s]; without a stamp, by when it was recorded."""
        return max(0.0, recorded + self.lead if header.stamp.is_zero() else header.stamp.to_sec() - skew)

    def add(self, stamp, order, kind, message):
        self.entries.append((stamp, order, kind, message))

    def take_scans(self):
        stamps = []
        for index, (recorded, message) in enumerate(self.scan.messages()):
            stamp = self.due(message.header, recorded)
            stamps.append(stamp)
            self.add(stamp, 2, 'scan', (self.scan, index))
        frame = bare(self.scan.message(0).header.frame_id)
        self.check_mount(frame)
        self.note_holes('scans', sorted(stamps))

    def take_odometry(self):
        if self.odometry is None:
            return self.note_holes('odometry', sorted(entry[0] for entry in self.entries if entry[2] == 'odom'))
        skew = (self.lead_of(self.odometry) or self.lead) - self.lead
        if abs(skew) > MOST_SKEW:
            self.words.append("odometry's clock is %.1f s %s that of the scans: its stamps are moved by that" % (
                abs(skew), 'ahead of' if skew > 0.0 else 'behind'))
        else:
            skew = 0.0
        stamps = []
        for index, (recorded, message) in enumerate(self.odometry.messages()):
            stamp = self.due(message.header, recorded, skew)
            stamps.append(stamp)
            self.add(stamp, 1, 'odom', (self.odometry, index))
            if not self.odometry_is_transformed:
                self.add(stamp, 0, 'tf_of_odom', (self.odometry, index))
        self.note_holes('odometry', sorted(stamps))

    def note_holes(self, what, stamps):
        for begin, length in holes(stamps):
            self.words.append('%s: nothing for %.1f s from %.1f s on; the clock goes on through it' % (
                what, length, begin - stamps[0]))

    def frame(self, name):
        """A recorded frame under the name that our nodes know it by."""
        name = bare(name)
        return self.renamed.get(name, name)

    def take_transforms(self):
        """Transforms that vary, and those that are fixed: on tf_static, or between parts of the robot."""
        self.renamed = {}
        frames = set()
        for topic in self.transforms:
            for _, message in topic.messages():
                for transform in message.transforms:
                    frames.update((bare(transform.header.frame_id), bare(transform.child_frame_id)))
        odom_frame, base = self.recorded_frames()
        if odom_frame and odom_frame != self.options['odom_frame']:
            self.renamed[odom_frame] = self.options['odom_frame']
        if self.base not in frames and base and base != self.base:
            self.renamed[base] = self.base
        for old, new in self.renamed.items():
            self.words.append('the frame %s of the bag is played as %s' % (old, new))
        dropped = {}
        self.odometry_is_transformed = False
        for topic in self.transforms:
            is_static = bare(topic.name) == bare(LATCHED)
            for recorded, message in topic.messages():
                for transform in message.transforms:
                    self.take_transform(transform, recorded, is_static, dropped)
        for (parent, child), count in sorted(dropped.items()):
            self.words.append('left out: %d recorded transforms %s -> %s of another mapper' % (count, parent, child))

    def recorded_frames(self):
        """The frame of odometry and that of the robot in it."""
        if self.odometry is None:
            return self.options['odom_frame'], self.base
        first = self.odometry.message(0)
        return bare(first.header.frame_id), bare(first.child_frame_id)

    def take_transform(self, transform, recorded, is_static, dropped):
        parent, child = self.frame(transform.header.frame_id), self.frame(transform.child_frame_id)
        if child == self.options['odom_frame'] or parent == self.options['map_frame']:
            dropped[parent, child] = dropped.get((parent, child), 0) + 1
            return
        transform.header.frame_id, transform.child_frame_id = parent, child
        if is_static:
            self.fixed[child] = transform
            return
        if parent == self.options['odom_frame']:
            self.odometry_is_transformed = True
        stamp = self.due(transform.header, recorded)
        self.add(stamp, 0, 'tf', transform)
        if self.odometry is None and parent == self.options['odom_frame'] and child == self.base:
            self.add(stamp, 1, 'odom', transform)

    def check_mount(self, frame):
        """Whether the recorded transforms lead from the base to the scanner; if not, the mount has to be given."""
        if self.options['mount']:
            x, y, yaw = numbers_in(self.options['mount'], 3, 'mount', '0.1 0 3.14')
            mount = TransformStamped()
            mount.header.frame_id, mount.child_frame_id = self.base, self.frame(frame)
            mount.transform.translation.x, mount.transform.translation.y = x, y
            mount.transform.rotation.z, mount.transform.rotation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
            self.fixed[mount.child_frame_id] = mount
            return
        links = {}
        moving = [entry[3] for entry in self.entries if entry[2] == 'tf']
        for transform in list(self.fixed.values()) + moving:
            links.setdefault(transform.header.frame_id, set()).add(transform.child_frame_id)
            links.setdefault(transform.child_frame_id, set()).add(transform.header.frame_id)
        reached, new = set(), {self.base}
        while new:
            reached |= new
            new = {frame for at in new for frame in links.get(at, ())} - reached - {self.options['odom_frame']}
        if self.frame(frame) not in reached:
            raise BagError("the transforms of the bag do not lead from %s to the scanner's frame %s: give mount:='x y yaw', or "
                           'another base_frame:=' % (self.base, frame))


class Player:
    """Publishes a drive on the clock."""

    def __init__(self, drive, speed):
        self.drive = drive
        self.speed = speed
        self.now = max(PERIOD, drive.entries[0][0] - 0.5)  # a clock at 0 means that none runs
        self.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        self.scan = rospy.Publisher('scan', LaserScan, queue_size=100)
        self.odom = rospy.Publisher('odom', Odometry, queue_size=1000)
        self.tf = rospy.Publisher('/tf', TFMessage, queue_size=1000)
        self.tf_static = rospy.Publisher(LATCHED, TFMessage, queue_size=1, latch=True)
        self.last_pose = None  # of odometry from transforms
        self.played = {'scan': 0, 'odom': 0, 'tf': 0, 'tf_of_odom': 0}

    def tick(self, seconds):
        """Lets the clock go on by recorded `seconds`."""
        self.now += seconds
        self.clock.publish(rospy.Time.from_sec(self.now))

    def run_until(self, end, each=None):
        """Lets the clock run to `end`; `each` is called at every step. False when the node was shut down."""
        last = time.monotonic()
        while self.now < end and not rospy.is_shutdown():
            time.sleep(PERIOD)
            now = time.monotonic()
            self.tick(self.speed * min(now - last, LONGEST_STEP))
            last = now
            if each is not None:
                each()
        return not rospy.is_shutdown()

    def await_mapper(self):
        self.tf_static.publish(TFMessage(list(self.drive.fixed.values())))
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end and not rospy.is_shutdown():
            self.tick(0.0)
            if self.scan.get_num_connections() > 0 and self.odom.get_num_connections() > 0:
                return
            time.sleep(10.0 * PERIOD)
        rospy.logwarn('nobody listens to scan and odom; the bag is played all the same')

    def play(self):
        """Gives whether it came to the end of the bag."""
        entries = self.drive.entries
        self.next = 0

        def publish_due():
            while self.next < len(entries) and entries[self.next][0] <= self.now:
                self.publish(*entries[self.next])
                self.next += 1
        return self.run_until(entries[-1][0] + PERIOD, publish_due)

    def publish(self, stamp, _, kind, content):
        self.played[kind] += 1
        if kind == 'tf':
            content.header.stamp = rospy.Time.from_sec(stamp)
            self.tf.publish(TFMessage([content]))
        elif kind == 'scan':
            message = content[0].message(content[1])
            message.header.frame_id = self.drive.frame(message.header.frame_id)
            if message.header.stamp.is_zero():
                message.header.stamp = rospy.Time.from_sec(stamp)
            self.scan.publish(message)
        elif kind == 'odom':
            self.odom.publish(self.odometry_of(stamp, content))
        else:
            self.tf.publish(TFMessage([transform_of(self.odometry_of(stamp, content))]))

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


def save_map(path):
    """Whether the map was saved."""
    try:
        answer = rospy.ServiceProxy('mapper/save_map', SaveMap)(path)
    except rospy.ServiceException as error:
        rospy.logerr('the map is not saved: %s', error)
        return False
    (rospy.loginfo if answer.success else rospy.logerr)(answer.message)
    return answer.success


def main():
    if any(word in ('-h', '--help') for word in sys.argv[1:]):
        print(__doc__)
        return 0
    rospy.init_node('bag_player')
    defaults = {'scan': '', 'odom': '', 'base_frame': 'base_footprint', 'odom_frame': 'odom', 'map_frame': 'map', 'mount': ''}
    options = {name: str(rospy.get_param('~' + name, default)) for name, default in defaults.items()}
    try:
        speed = speed_in(rospy.get_param('~speed', 1.0))
        drive = Drive(*read_bag(rospy.get_param('~bag', '')), options)
    except BagError as error:
        rospy.logfatal('%s', error)
        return 1
    for words in drive.words:
        rospy.loginfo(words)
    player = Player(drive, speed)
    player.await_mapper()
    if not player.play():
        return 1
    player.run_until(player.now + SETTLING * max(1.0, player.speed))
    say_what_was_mapped(drive, player)
    path = rospy.get_param('~save_map', '')
    saved = save_map(path) if path else True
    if rospy.get_param('~stay', False):
        player.speed = 1.0
        player.run_until(math.inf)
    return 0 if saved else 1


if __name__ == '__main__':
    sys.exit(main())
