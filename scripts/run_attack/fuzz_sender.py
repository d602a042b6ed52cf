"""Sends made messages at a high rate, and keeps the last ones for a replay."""
import base64
import collections
import json
import struct
import time
import warnings

import roslib.message
import rospy

from run_attack import fuzz_plan
from run_attack.messages import holds_field, serialised, set_field

POOL = 150  # messages of each topic that are made at a time
KEPT = 5000  # last messages
DAMAGED = 0.05  # the share of messages that are no longer well-formed


def written_class(kind):
    """A message class whose instances are bytes that were serialised before."""
    class Written(kind):
        __slots__ = ('data',)
        _has_header = False  # or rospy would count in it

        def __init__(self, data):
            self.data = data

        def serialize(self, buff):
            buff.write(self.data)
    return Written


class Sender:
    """Publishes on topics ({topic: class}); a connection is written to at once, so that what was sent has left."""

    def __init__(self, kinds):
        self.sent = 0
        self.kept = collections.deque(maxlen=KEPT)
        self._kinds = kinds
        self._written = {topic: written_class(kind) for topic, kind in kinds.items()}
        with warnings.catch_warnings():  # of a publisher without a queue
            warnings.simplefilter('ignore')
            self._publishers = {topic: rospy.Publisher(topic, kind, queue_size=None, tcp_nodelay=True)
                                for topic, kind in kinds.items()}
        self._pools = {}

    def fill_pools(self, generator, honest, topics):
        """Makes messages for some topics. In an honest round no goal says that the robot may drive blindly."""
        self._pools = {}
        for topic, kind in ((topic, self._kinds[topic]) for topic in topics):
            blind = honest and holds_field(kind, fuzz_plan.BLIND)
            self._pools[topic] = [self._made(kind, generator, blind) for _ in range(POOL)]

    @staticmethod
    def _made(kind, generator, blind):
        message = generator.message(kind)
        if blind:
            set_field(message, fuzz_plan.BLIND, False)
        data = serialised(message)
        return data if blind or generator.chance() >= DAMAGED else generator.damaged(data)

    def send_for(self, seconds, rate, draw):
        """Bursts on one topic after the other, `rate` messages a second altogether if the receivers keep up."""
        begin, sent = time.monotonic(), 0
        while time.monotonic() < begin + seconds:
            topic = draw.choice(sorted(self._pools))
            for _ in range(draw.choice((1, 5, 30))):
                self.send(topic, draw.choice(self._pools[topic]), draw.random() < 0.5)
                sent += 1
            time.sleep(max(0.0, begin + sent / rate - time.monotonic()))

    def send(self, topic, data, fresh=False):
        """`fresh`: a header that the message begins with gets the present time, so that the message is not just old."""
        if fresh and self._kinds[topic]._has_header and len(data) >= 12:
            now = rospy.Time.now()
            data = data[:4] + struct.pack('<2I', now.secs, now.nsecs) + data[12:]
        self.kept.append((time.monotonic(), topic, self._kinds[topic]._type, data))
        self._publishers[topic].publish(self._written[topic](data))
        self.sent += 1

    def close(self):
        for publisher in self._publishers.values():
            publisher.unregister()


def write_kept(kept, path):
    """Writes messages that can be replayed: a line of JSON for each."""
    with open(path, 'w') as file:
        for at, topic, kind, data in list(kept):
            file.write(json.dumps([round(at, 4), topic, kind, base64.b64encode(data).decode()]) + '\n')


def read_kept(path):
    """What write_kept has written: (time, topic, type, bytes) of each message."""
    with open(path) as file:
        return [(at, topic, kind, base64.b64decode(data)) for at, topic, kind, data in map(json.loads, file)]


def replay(path):
    """Sends the messages of a file again, with the pauses between them. Gives how many."""
    kept = read_kept(path)
    sender = Sender({topic: roslib.message.get_message_class(kind) for _, topic, kind, _ in kept})
    time.sleep(2.0)  # for the nodes to connect
    begin = time.monotonic()
    for at, topic, _, data in kept:
        time.sleep(max(0.0, begin + at - kept[0][0] - time.monotonic()))
        sender.send(topic, data)
    sender.close()
    return len(kept)

