"""Makes messages from their definitions: plausible ones, ones in which little is wrong, and ones in which everything is.

Nothing here knows a node. What is plausible comes from the types of the fields, from the frames that are in use, and from
messages that were recorded.
"""
import io
import math
import random
import re

import genpy
import roslib.message

MOST_NUMBERS = 20000  # elements of an array of numbers
MOST_PARTS = 200  # elements of an array of anything else
SAMPLED = 0.7  # the share of mutated messages that begin with a recorded one, if there is one

_BITS = {'int8': 8, 'int16': 16, 'int32': 32, 'int64': 64, 'byte': 8}
_UNSIGNED_BITS = {'uint8': 8, 'uint16': 16, 'uint32': 32, 'uint64': 64, 'char': 8}
RANGES = {name: (-2 ** (bits - 1), 2 ** (bits - 1) - 1) for name, bits in _BITS.items()}
RANGES.update({name: (0, 2 ** bits - 1) for name, bits in _UNSIGNED_BITS.items()})
NUMBERS = set(RANGES) | {'float32', 'float64', 'bool'}
FLOATS = {'float32': (math.nan, math.inf, -math.inf, 3.4028e38, -3.4028e38, 1e-45, 0.0, -0.0, 1e9, -1e9, 1e20),
          'float64': (math.nan, math.inf, -math.inf, 1.797e308, -1.797e308, 5e-324, 0.0, -0.0, 1e9, -1e9, 1e30)}
WORDS = ('', ' ', '\0', '\n', '\x1b[2J\x1b[31m', '\x7f\x9b\u2028', 'a' * 300, 'ü\u202e\ufffd', '%s%n%x', '~', 'nowhere', '-1')
PATHS = ('/', '/map', '//', 'a/../b', '../../x')
LATEST, MOST_SECONDS = 2 ** 32 - 1, 2 ** 31 - 1


def array_of(field_type):
    """(type of the elements, their fixed number or None) of an array's type; None if it is none."""
    match = re.fullmatch(r'(.+)\[(\d*)\]', field_type)
    return match and (match.group(1), int(match.group(2)) if match.group(2) else None)


class Generator:
    """Messages that depend only on the seed, `now` [s of ROS time], the frames and the samples ({type: [bytes]}).

    Without `paths`, no string has a slash or a dot, so that no service can be told to write outside of its own folder.
    """

    def __init__(self, seed, now=100.0, frames=('map', 'odom', 'base_link'), samples=None, paths=True):
        self._draw = random.Random(seed)
        self._now = now
        self._frames = tuple(frames)
        self._samples = samples or {}
        self._words = WORDS + (PATHS if paths else ())

    def message(self, kind):
        """A message of a class: one in three plausible, half of them mutated, the others hostile throughout."""
        fate = self._draw.random()
        if fate < 0.15:
            return self.fill(kind(), hostile=True)
        message = self._sample(kind) or self.fill(kind(), hostile=False)
        if fate < 0.65:
            for _ in range(self._draw.choice((1, 1, 1, 2, 5))):
                self.mutate(message)
        return message

    def _sample(self, kind):
        samples = self._samples.get(kind._type)
        if not samples or self._draw.random() > SAMPLED:
            return None
        return kind().deserialize(self._draw.choice(samples))

    def fill(self, message, hostile):
        """Gives the message with new values in all fields."""
        if message._type == 'geometry_msgs/Quaternion' and not hostile:
            angle = self._draw.uniform(-math.pi, math.pi)
            message.z, message.w = math.sin(angle / 2.0), math.cos(angle / 2.0)
            return message
        for name, field_type in zip(message.__slots__, message._slot_types):
            setattr(message, name, self.value(field_type, hostile, name))
        return message

    def mutate(self, message):
        """Makes one field at a random depth hostile."""
        fields = list(zip(message.__slots__, message._slot_types))
        if not fields:
            return
        name, field_type = self._draw.choice(fields)
        value = getattr(message, name)
        if isinstance(value, genpy.Message):
            self.mutate(value)
        elif array_of(field_type):
            setattr(message, name, self._mutated_array(value, *array_of(field_type)))
        else:
            setattr(message, name, self.value(field_type, True, name))

    def _mutated_array(self, values, element, count):
        if count is None and (not values or self._draw.random() < 0.4):
            return self._resized(values, element)
        values = list(values)
        index = self._draw.randrange(len(values)) if values else 0
        if values and isinstance(values[index], genpy.Message):
            self.mutate(values[index])
        elif values:
            values[index] = self.value(element, True)
        return bytes(values) if element in ('uint8', 'char') else values

    def _resized(self, values, element):
        """Shorter, longer, twice as long, or new."""
        choice = self._draw.randrange(4)
        if choice == 0 or not values:
            return self._array(element, None, True)
        if choice == 1:
            return values[:self._draw.randrange(len(values))]
        if choice == 2:
            return values[:MOST_PARTS] + values[:1]
        return (values + values)[:MOST_NUMBERS if element in NUMBERS else MOST_PARTS]

    def value(self, field_type, hostile, name=''):
        """A value for a field; strings that are the names of frames are known by the name of the field."""
        array = array_of(field_type)
        if array:
            return self._array(*array, hostile)
        if field_type in ('float32', 'float64'):
            return self._draw.choice(FLOATS[field_type]) if hostile else self._draw.uniform(-3.0, 3.0)
        if field_type == 'bool':
            return self._draw.random() < 0.5
        if field_type in RANGES:
            return self._integer(*RANGES[field_type], hostile)
        if field_type == 'string':
            return self._string(name, hostile)
        if field_type == 'time':
            return genpy.Time(*self._time(hostile))
        if field_type == 'duration':
            return genpy.Duration(*self._duration(hostile))
        return self.fill(roslib.message.get_message_class(_full_name(field_type))(), hostile)

    def _array(self, element, count, hostile):
        most = MOST_NUMBERS if element in NUMBERS else MOST_PARTS
        if count is None:
            count = self._draw.choice((0, 0, 1, 2, 17, most // 20, most)) if hostile else self._draw.randrange(6)
        if element in ('uint8', 'char'):
            return bytes(self._draw.choice((0, 1, 127, 255)) for _ in range(min(count, 4))).ljust(count, b'\x7f')
        if element in NUMBERS and count > 50:  # many numbers: a few, repeated
            few = [self.value(element, hostile) for _ in range(7)]
            return (few * (count // 7 + 1))[:count]
        return [self.value(element, hostile) for _ in range(count)]

    def _integer(self, least, most, hostile):
        if hostile:
            return self._draw.choice((least, most, 0, max(least, -1), 1, most // 2, self._draw.randint(least, most)))
        return self._draw.randint(0, 5)

    def _string(self, name, hostile):
        if hostile:
            return self._draw.choice(self._words)
        return self._draw.choice(self._frames if 'frame' in name else ('', 'one', 'two', 'robot') + self._frames[:1])

    def _time(self, hostile):
        if hostile:
            return self._draw.choice(((0, 0), (LATEST, 999999999), (LATEST, 0), (0, 1), (2 ** 31, 0), (2 ** 31 - 1, 999999999),
                                      (int(self._now) + 1000000, 0), (int(self._now) // 2, 0)))
        moment = max(0.0, self._now + self._draw.uniform(-0.1, 0.1))
        return self._draw.choice(((0, 0), (int(moment), int(moment % 1.0 * 1e9))))

    def _duration(self, hostile):
        if hostile:
            return self._draw.choice(((0, 0), (MOST_SECONDS, 999999999), (-MOST_SECONDS - 1, 0), (-1, 0), (0, 1)))
        return (self._draw.randrange(10), self._draw.randrange(10 ** 9))

    def chance(self):
        """A number from 0 to 1 for whoever decides by the same seed."""
        return self._draw.random()

    def damaged(self, data):
        """Serialised bytes that are cut off, or of which four that may be the length of an array are overwritten."""
        if len(data) < 4 or self._draw.random() < 0.3:
            return data[:self._draw.randrange(len(data) + 1)]
        place = self._draw.randrange(len(data) - 3)
        return data[:place] + self._draw.choice((b'\xff' * 4, b'\xff\xff\xff\x7f', b'\0\0\0\1', b'\0' * 4)) + data[place + 4:]


def _full_name(field_type):
    return 'std_msgs/Header' if field_type == 'Header' else field_type


def serialised(message):
    """The bytes of a message."""
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def holds_field(kind, name):
    """Whether a message class has a field of that name, at any depth."""
    for slot, field_type in zip(kind.__slots__, kind._slot_types):
        element = array_of(field_type)[0] if array_of(field_type) else field_type
        if slot == name:
            return True
        if '/' in _full_name(element) and holds_field(roslib.message.get_message_class(_full_name(element)), name):
            return True
    return False


def set_field(message, name, value):
    """Sets every field of that name, at any depth."""
    for slot in message.__slots__:
        field = getattr(message, slot)
        if slot == name:
            setattr(message, slot, value)
        for part in field if isinstance(field, list) else [field]:
            if isinstance(part, genpy.Message):
                set_field(part, name, value)
