"""Which numbers a run can have. Anybody may publish others, and a recorder keeps what it hears."""
MOST_COORDINATE = 1e6  # [m], as for the nodes
MOST = 1e12  # of whatever else is a float
PLACES = ('geometry_msgs/Point', 'geometry_msgs/Point32', 'geometry_msgs/Vector3')


def check(message):
    """Raises ValueError where a message, or one that it is made of, has a number that no run can have."""
    is_place = message._type in PLACES
    for name in message.__slots__:
        value = getattr(message, name)
        if isinstance(value, float):
            _check_float(value, is_place)
        elif hasattr(value, '_type'):
            check(value)
        elif isinstance(value, (list, tuple)) and value and hasattr(value[0], '_type'):
            for part in value:
                check(part)


def _check_float(value, is_place):
    if is_place and not abs(value) <= MOST_COORDINATE:
        raise ValueError('they have places farther than 1000 km from the origin')
    if abs(value) > MOST:  # what is not known is no number (NaN)
        raise ValueError('they have numbers that cannot be')
