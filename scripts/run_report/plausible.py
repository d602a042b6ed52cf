"""Which numbers a run can have. Anybody may publish others, and a recorder keeps what it hears."""
import math

MOST_COORDINATE = 1e6  # [m] kMostCoordinate in core/bounds.h
MOST = 1e12  # of any other finite number: NaN and infinities have a meaning in some of our messages
POINTS = ('geometry_msgs/Point', 'geometry_msgs/Point32', 'geometry_msgs/Vector3')


def check(message):
    """Raises ValueError if a message, or one that it is made of, has a number that no run can have. Arrays of numbers are not
    looked at."""
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


def _check_float(value, is_point):
    if is_point and not abs(value) <= MOST_COORDINATE:
        raise ValueError('they have coordinates that are not finite or farther than 1000 km')
    if math.isfinite(value) and abs(value) > MOST:
        raise ValueError('they have numbers that cannot be')
