"""The topics of a recorded drive, and which of them are played."""
import math
import struct

import rosbag
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

from readable_bag import DAMAGE, why_no_bag

MOST_BYTES = 300_000  # of a message: 36000 ranges and intensities, as many as the nodes take, have 288 kB
MOST_MEMORY = 4_000_000_000  # of all messages that are played [bytes], as map_log takes for a bag
OVERHEAD = 390  # of Python's objects for a message [bytes]
OF_A_TRANSFORM = 800  # of those for a transform, which is kept as objects [bytes]
LEAST_TRANSFORM = 76  # of the message [bytes]: one with empty names
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
    """A scan's field of view; 0 where it has none."""
    width = math.degrees(abs(scan.angle_increment)) * max(0, len(scan.ranges) - 1)
    return width if math.isfinite(width) else 0.0


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


class Topic:
    """The messages of one topic of a bag, raw, with the times at which they were recorded [s]."""

    def __init__(self, name, message_class):
        self.name = name
        self.message_class = message_class
        self.raw = []
        self.too_long = 0  # messages that are left out, of more than MOST_BYTES

    def message(self, index):
        return self._read(self.raw[index][1])

    def messages(self):
        for recorded, data in self.raw:
            yield recorded, self._read(data)

    def _read(self, data):
        try:
            return self.message_class().deserialize(data)
        except DAMAGE as error:
            raise BagError('%s: a message cannot be read: %s' % (self.name, str(error) or type(error).__name__))


def memory_for(message_class, data):
    """What a message takes while it is kept [bytes], with what is made of it to be played."""
    memory = len(data) + OVERHEAD
    if message_class is TFMessage and len(data) >= 4:
        memory += OF_A_TRANSFORM * min(struct.unpack_from('<I', data)[0], len(data) // LEAST_TRANSFORM)
    return memory


def read_bag(path):
    """Topics of the types that are played, by type; and the names and types of all others."""
    classes = {'sensor_msgs/LaserScan': LaserScan, 'nav_msgs/Odometry': Odometry, 'tf2_msgs/TFMessage': TFMessage,
               'tf/tfMessage': TFMessage}
    topics, others, memory = {}, {}, 0
    why = why_no_bag(path)
    if why:
        raise BagError('%s: %s' % (path, why))
    try:
        with rosbag.Bag(path) as bag:
            # Raw, because the bag may hold types whose definition nobody has.
            for name, (kind, data, md5, *_), recorded in bag.read_messages(raw=True):
                message_class = classes.get(kind)
                if message_class is None or message_class._md5sum != md5:
                    others[name] = kind
                    continue
                topic = topics.setdefault(name, Topic(name, message_class))
                if len(data) > MOST_BYTES:
                    topic.too_long += 1
                    continue
                topic.raw.append((recorded.to_sec(), data))
                memory += memory_for(message_class, data)
                if memory > MOST_MEMORY:
                    raise BagError('%s: its scans, odometry and transforms take more than %.0f GB of memory; rosbag filter makes a '
                                   'shorter bag of it' % (path, MOST_MEMORY / 1e9))
    except rosbag.ROSBagUnindexedException:
        raise BagError("%s: has no index, because its recording did not end in an orderly way; 'rosbag reindex' may recover what it "
                       'holds' % path)
    except DAMAGE as error:
        raise BagError('%s: %s' % (path, str(error) or type(error).__name__))
    return topics, others


def those_with_many_messages(topics):
    """The topics without those that have far fewer messages than another."""
    most = max(len(topic.raw) for topic in topics.values())
    return {name: topic for name, topic in topics.items() if len(topic.raw) >= FEW * most}


def choose_scan(topics, wanted):
    """The topic of the scans and why it was chosen."""
    every = {name: topic for name, topic in topics.items() if topic.message_class is LaserScan}
    scans = {name: topic for name, topic in every.items() if topic.raw}
    if every and not scans:
        raise BagError('all messages of %s are longer than %d bytes' % (', '.join(sorted(every)), MOST_BYTES))
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
    odometry = {name: topic for name, topic in topics.items() if topic.message_class is Odometry and topic.raw}
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
