"""Which messages a run can have. Anybody may publish others, and a recorder keeps what it hears."""
import functools
import math

from genpy.message import get_message_class

MOST_COORDINATE = 1e6  # [m] kMostCoordinate in core/bounds.h
MOST = 1e12  # of any other finite number: NaN and infinities have a meaning in some of our messages
# Of what a report reads. No other module is imported because a bag names it.
PACKAGES = ('actionlib_msgs', 'diagnostic_msgs', 'frontier_pilot', 'geometry_msgs', 'map_msgs', 'nav_msgs', 'rosgraph_msgs',
            'std_msgs', 'tf2_msgs')
MOST_NESTED = 50  # lists and groups of parameters in each other
POINTS = ('geometry_msgs/Point', 'geometry_msgs/Point32', 'geometry_msgs/Vector3')
NUMBERS = ('bool', 'byte', 'char', 'float32', 'float64', 'int8', 'int16', 'int32', 'int64', 'uint8', 'uint16', 'uint32', 'uint64')


def check(message):
    """Raises ValueError if a message, or one that it is made of, is of another form than ours, or has a number that no run can
    have. Arrays of numbers are not looked at."""
    check_form(type(message))
    is_point = message._type in POINTS
    for name in message.__slots__:
        value = getattr(message, name)
        if isinstance(value, float):
            _check_float(value, is_point)
        elif hasattr(value, '_type'):
            check(value)
        elif isinstance(value, (list, tuple)) and value and hasattr(value[0], '_type'):
            for part in value:
                check(part)


@functools.lru_cache(maxsize=None)
def check_form(kind):
    """Raises ValueError if a class of messages has a field that is something else in the installed one of its name: a bag holds its
    own definitions. Fields that only one of the two has are those of another version."""
    ours = get_message_class(kind._type) if kind._type.split('/')[0] in PACKAGES else None
    forms = dict(zip(ours.__slots__, ours._slot_types)) if ours else {}
    for name, form in zip(kind.__slots__, kind._slot_types):
        if _alike(form) != _alike(forms.get(name, form)):
            raise ValueError('they have another kind of %s' % name)


def _alike(form):
    """The type of a field, where all numbers are one, and arrays of any length."""
    element, *array = form.split('[')
    return 'number' if element in NUMBERS else element, bool(array)


def is_nested_too_deep(value):
    """Whether this, read from JSON, holds more in each other than could be gone through again."""
    level = [value]
    for _ in range(MOST_NESTED):
        level = [part for whole in level if isinstance(whole, (dict, list))
                 for part in (whole.values() if isinstance(whole, dict) else whole)]
    return bool(level)


def _check_float(value, is_point):
    if is_point and not abs(value) <= MOST_COORDINATE:
        raise ValueError('they have coordinates that are not finite or farther than 1000 km')
    if math.isfinite(value) and abs(value) > MOST:
        raise ValueError('they have numbers that cannot be')
