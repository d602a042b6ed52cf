"""A recorded drive as bag_player.py plays it: its messages by the stamps at which they are due."""
import math

from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

from bag_topics import MOST_BYTES, BagError, bare, choose_odometry, choose_scan, median, numbers_in
from command_line import printable

LONGEST_NAME = 100  # of a frame in a line of the log
LEAST_HOLE = 2.0  # [s]
MOST_SKEW = 1.0  # [s] between the clocks of scans and odometry before they are aligned
MOST_APART = 3600.0  # [s] between two messages, by their stamps, before the fewer ones on one side may be astray
LEAST_SHARE = 0.1  # of the messages of the largest stretch that a stretch apart from it has to have to be played
LONGEST_SILENCE = 60.0  # [s] without any message before the clock jumps to the next one
LATEST = 2.0 ** 32 - 86400.0  # [s] stamp that is played: the clock needs some time after it, and ROS counts to 2^32 s
LEAD_IN = 0.5  # [s] from which the clock runs before the first message is due
LATCHED = '/tf_static'


def holes(stamps):
    """Begin and length of each stretch without a message, in a sorted list of stamps [s]."""
    gaps = [b - a for a, b in zip(stamps, stamps[1:])]
    least = max(LEAST_HOLE, 10.0 * median(gaps)) if gaps else LEAST_HOLE
    return [(begin, gap) for begin, gap in zip(stamps, gaps) if gap >= least]


def span_of(stamps):
    """From when to when messages are played, by the stamps of the scans [s]. A few stamps that are far from all the others are
    false, and the clock would have to go on for years until they are due."""
    stretches = []
    for stamp in sorted(stamps):
        if not stretches or stamp - stretches[-1][-1] > MOST_APART:
            stretches.append([])
        stretches[-1].append(stamp)
    most = max(len(stretch) for stretch in stretches)
    kept = [stretch for stretch in stretches if len(stretch) >= LEAST_SHARE * most]
    return kept[0][0] - MOST_APART, kept[-1][-1] + MOST_APART


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
        self.words += ['%s: %d messages of more than %d bytes are left out' % (topic.name, topic.too_long, MOST_BYTES)
                       for topic in topics.values() if topic.too_long]
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
        self.astray = 0  # messages that were left out for their stamps
        self.scans_due = [self.due(message.header, recorded) for recorded, message in self.scan.messages()]
        self.span = span_of(self.scans_due)
        self.take_transforms()
        self.take_odometry()
        self.take_scans()
        if self.astray:
            self.words.append('left out: %d messages whose stamps are more than an hour away from those of the scans' % self.astray)
        self.entries.sort(key=lambda entry: entry[:2])
        self.note_jumps()
        self.next = 0  # of the entries to be played
        if not self.entries:
            raise BagError('nothing to play')
        if self.entries[-1][0] > LATEST:
            raise BagError('its last stamp is %.0f s; ROS cannot count far beyond that, so it is not played' % self.entries[-1][0])

    def due_until(self, now):
        """The entries that are due, each once."""
        while self.next < len(self.entries) and self.entries[self.next][0] <= now:
            self.next += 1
            yield self.entries[self.next - 1]

    def time_after(self, now):
        """The time to go on from at `now`: where there is nothing for more than a minute, the clock jumps over it. The clock of the
        robot may have been set while it drove."""
        is_hole = self.next < len(self.entries) and self.entries[self.next][0] - now > LONGEST_SILENCE
        return self.entries[self.next][0] - LEAD_IN if is_hole else now

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
        """Whether the message is played."""
        is_played = self.span[0] <= stamp <= self.span[1]
        if is_played:
            self.entries.append((stamp, order, kind, message))
        else:
            self.astray += 1
        return is_played

    def take_scans(self):
        stamps = []
        for index, stamp in enumerate(self.scans_due):
            if self.add(stamp, 2, 'scan', (self.scan, index)):
                stamps.append(stamp)
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
            is_played = self.add(stamp, 1, 'odom', (self.odometry, index))
            if is_played:
                stamps.append(stamp)
            if is_played and not self.odometry_is_transformed:
                self.add(stamp, 0, 'tf_of_odom', (self.odometry, index))
        self.note_holes('odometry', sorted(stamps))

    def note_holes(self, what, stamps):
        for begin, length in holes(stamps):
            self.words.append('%s: nothing for %.1f s from %.1f s on' % (what, length, begin - stamps[0]))

    def note_jumps(self):
        stamps = [entry[0] for entry in self.entries]
        self.words += ['no message at all for %.1f s from %.1f s on: the clock jumps over it' % (after - before, before - stamps[0])
                       for before, after in zip(stamps, stamps[1:]) if after - before > LONGEST_SILENCE]

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
            self.words.append('the frame %s of the bag is played as %s' % (printable(old, LONGEST_NAME), new))
        dropped = {}
        self.odometry_is_transformed = False
        for topic in self.transforms:
            is_static = bare(topic.name) == bare(LATCHED)
            for recorded, message in topic.messages():
                for transform in message.transforms:
                    self.take_transform(transform, recorded, is_static, dropped)
        for (parent, child), count in sorted(dropped.items()):
            self.words.append('left out: %d recorded transforms %s -> %s of another mapper' % (
                count, printable(parent, LONGEST_NAME), printable(child, LONGEST_NAME)))

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
                           'another base_frame:=' % (self.base, printable(frame, LONGEST_NAME)))
